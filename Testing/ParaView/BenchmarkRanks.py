# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""
Prints how long frames take on several ranks; no test.
  mpiexec -n RANKS pvbatch --sym BenchmarkRanks.py [LINES] [POINTS PER LINE]
with the environment that the tests have. The first frame distributes the lines and builds what is
drawn; later ones have another camera each.
"""
import sys
import time

import linesets_ranks as ranks
import linesets_testing as testing
from paraview import simple

NUMBER = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
POINTS = int(sys.argv[2]) if len(sys.argv) > 2 else 500
FRAMES = 5

testing.load_plugin()
lines = simple.XMLPartitionedPolydataReader(
    FileName=[ranks.write_pieces(ranks.make_waves(NUMBER, POINTS), "benchmark")])
view = testing.make_view((800, 600))
display = simple.Show(lines, view)
display.ImportanceArray = "Height"
view.CameraPosition = [4.0, 3.0, 3.5]
for name in ("Voxel Lines", "Illuminated Lines", "Fourier Opacity"):
    for opacity in (1.0, 0.25):
        display.Representation = name
        display.Opacity = opacity
        times = []
        for frame in range(FRAMES + 1):
            ranks.CONTROLLER.Barrier()
            start = time.time()
            view.CameraPosition = [4.0 - 0.2 * frame, 3.0, 3.5]
            simple.Render(view)
            ranks.CONTROLLER.Barrier()
            times.append(time.time() - start)
        if ranks.RANK == 0:
            print("| %d | %s | %.2f | %.2f s | %.2f s |" % (
                ranks.RANKS, name, opacity, times[0], sum(times[1:]) / FRAMES))
            sys.stdout.flush()
