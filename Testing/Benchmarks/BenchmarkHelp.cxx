// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkOptions.h"

#include "BenchmarkMethod.h"
#include "OpacityMethod.h"
#include "Scenes.h"

#include <ostream>
#include <sstream>

namespace linesets
{
namespace
{
// Names in lines that fit under the options' texts.
std::string Wrap(const std::vector<std::string>& names)
{
  constexpr std::size_t width = 74;
  const std::string indent = "\n" + std::string(25, ' ');
  std::string text;
  std::size_t length = 0;
  for (const std::string& name : names)
  {
    const bool breaks = length + name.size() > width;
    text += text.empty() ? "" : breaks ? indent : " ";
    length = (breaks ? 0 : length) + name.size() + 1;
    text += name;
  }
  return text;
}

// Scenes and what OpacityMethod has for them.
std::vector<std::string> GetOpacityDefaults()
{
  std::vector<std::string> texts;
  for (const OpacityMethod::SceneDefaults& defaults : OpacityMethod::GetSceneDefaults())
  {
    const std::string scene = defaults.Scene;
    std::ostringstream text;
    text << (scene.empty() ? "others" : scene) << " " << defaults.Weights[0] << ","
         << defaults.Weights[1] << "," << defaults.Weights[2] << "," << defaults.Weights[3]
         << " and " << defaults.Smoothing << (scene.empty() ? "" : ";");
    texts.push_back(text.str());
  }
  return texts;
}

void PrintOptions(std::ostream& out)
{
  out << R"(linesets-bench SCENE [options]
Times how fast line sets are drawn, by several methods in turn, frame by frame, in one run, and
writes one JSON object per method.

SCENE or --scene SCENE   )"
      << Wrap(GetSceneNames()) << R"(,
                         or a file of lines, .vtp or .vtk, coloured by its active point scalars;
                         of a file without lines, its vertices and polygons. The method lines
                         and those of opacity optimization draw these, too; the others need lines
--lines N --vertices N   size of a named scene, in place of its own. For points, --lines is the
                         number of points; for surfaces, that of the stream lines of each of the
                         20 surfaces
--methods LIST           of
                         )"
      << Wrap(GetMethodNames()) << R"(,
                         separated by commas (default voxel,tubes,line-tubes; below opacity 1
                         voxel,oit; for points and surfaces lines)
  voxel                  vtkVoxelLineMapper
  voxel-hard-shadow      the same with hard shadows; this and the next two and voxel-full need
                         --light right or studio, since a headlight casts no shadows that the
                         camera sees
  voxel-line-shadow      the same with shadows of the representative lines of a level
  voxel-soft-shadow      the same with soft shadows
  voxel-occlusion        the same with spherical ambient occlusion, per voxel
  voxel-full             the same with soft shadows and spherical occlusion
  voxel-hemisphere       the same with occlusion of hemispheres by densities, per pixel
  voxel-hemisphere-tubes the same with occlusion of hemispheres by the tubes, per pixel
  tubes                  vtkTubeFilter with 8 sides, back faces culled; translucent tubes are
                         drawn as VTK does by default
  peeling                the same by dual depth peeling, without a limit of peels
  oit                    the same by VTK's order-independent translucency
  line-tubes             lines as they are, with RenderLinesAsTubes of vtkProperty; the width is
                         that of the tubes at the focal point
  lines                  lines, points and surfaces as VTK draws them; lines and points without
                         light
  illuminated            vtkIlluminatedLineMapper, cylinder averaging
  illuminated-max        the same with maximum reflection
  illuminated-blinn      the same with Blinn's highlights
  illuminated-direct     the same without a table
  fourier                vtkFourierOpacityMapper: opacity optimization, for importance from 0 to 1,
                         with Fourier series; this and the next five draw lines, points and
                         surfaces
  fourier-paper          the same with the series and weights of the paper
  bins                   the same with bins of depth in place of series for blending and importance
  weighted-average       the same blended by the mean colour, weighted by opacity
  weighted-blended       the same blended by the mean colour, weighted by opacity and depth
  fragment-list          the same with all fragments sorted, for importance and blending: exact
--engine LIST            of automatic native shader, for voxel methods (default automatic); each
                         gives an object of its own
--resolution N           voxels along the longest side of the bounds, for voxel methods (default
                         256)
--face-bins N            bins along a voxel's edge, for voxel methods (default 32; 0 for exact
                         points)
--light LIGHT            headlight (default), or right: one light in the scene, to the right of
                         the camera as it stands in the first view, where it stays while the
                         camera turns; or studio: that one and a headlight half as bright
--shadow-level N         level of voxel-line-shadow, 1 to 12 (default 1)
--cone-angle A           full angle of the cones of soft shadows, 0 to 60 degrees (default 10)
--occlusion-radius R     how far occlusion reaches, 1 to 4096 voxels (default 15)
--occlusion-samples N    rays per point for hemispheres, 1 to 10000 (default 64)
--peels N                for peeling, at most N peels and the rest unsorted (default 0: no limit,
                         which takes half as many passes over all tubes as there are layers, and
                         hence minutes to hours for a frame of the large scenes on a processor;
                         with a limit ratio_peeling is a lower bound)
--line-width W           of lines and illuminated lines, and size of points, in pixels (default 1)
--samples N              samples per pixel (default 0: no multisampling; for the plain pass only)
--stretch                stretch the dynamic range of illuminated lines
--color COLOR            scalars, or importance: from blue for 0 to red for 1 (default: importance
                         for opacity optimization and scalars for the other methods)
--plain                  draw lines in one colour on a dark background, in place of scalars on
                         white
--importance NAME        array of the points, of one component, that tells opacity optimization what
                         is important, from 0 to 1; scaled to that where it leaves it (default:
                         importance, which all named scenes have, or else the active scalars)
--bands M                frequencies of the Fourier series of opacity optimization, 1 to 16
                         (default 5)
--subset N               opacity optimization takes one of N segments for its series, 1 to 10000
                         (default 1: all); fragment-list takes all
--line-segments N        of opacity optimization in all lines together, up to 16777215 (default 0:
                         16 per line, at most one for four points, at least 50000)
--patches N              of opacity optimization on all surfaces together, 1 to 16777215 (default
                         500)
--weights P,Q,R,LAMBDA   of the energy that opacity optimization minimizes: of opacity itself, of
                         what hides the important, and of clutter behind it, and the exponent that
                         emphasizes the important; p from 1e-6 to 1e6, q and r from 0 to 1e6,
                         lambda from 0.01 to 100
--smoothing N            steps by which optimized opacities are smoothed along the geometry, 0 to
                         1000. Defaults of --weights and --smoothing:
                         )"
      << Wrap(GetOpacityDefaults()) << R"(
--importance-sums SUMS   fourier (default), or exact: sums of importance over all fragments of a
                         pixel, in the order of their depths, as fragment-list has them
--importance-reduction N importance is summed for one of N pixels of a row and of a column, 1 to 8
                         (default 2)
--depth-reduction N      the same for the optical depth of fourier (default 1)
--half-floats SWITCH     on (default) or off: sums of fourier, but for the optical depth of a pixel,
                         and colours have 2 bytes in place of 4
--depth-scale SCALE      linear (default) or logarithmic: how series and bins divide the depth
--tight-depth SWITCH     on (default) or off, for fourier: whether the series of a pixel's optical
                         depth spans only the depths that this pixel shows
--opaque-threshold T     for fourier, opacity from which on a fragment hides what is behind it, 0.5
                         to 1 (default 0.98; above 0.9999 none does)
--list-memory MIB        most memory for sorted fragments, 1 to 1048576 MiB (default 1024): what
                         does not fit at once is drawn in strips
--radius R               of the tubes in units of the data (default: 1/512 of the longest side
                         of the bounds, that is, half a voxel of 256)
--opacity A              0 to 1 (default 1)
--size WxH               of the image (default 1024x768)
--zoom Z                 magnify the middle of the picture, 0.1 to 100 times (default 1)
--frames N               frames that count, after one that does not (default 5); the camera moves
                         by 2 degrees from frame to frame
--animate                other lines in every frame that counts: points move along their lines
                         and in a slow swirl about the vertical axis, the same in each run. New
                         points, cells and arrays are made outside the times, and go through
                         each method's pipeline as lines that were never seen before: models and
                         tubes are made again, lines are uploaded. Needs lines
--threads N              of vtkSMPTools and of software OpenGL (default: all)
--reference              also compare each picture of the first view with an exact one: keys rmse,
                         ssim. It has one ray per pixel, so that tubes thinner than a pixel, which
                         voxel draws by what they cover, differ from it. It has neither shadows
                         nor occlusion, so methods that have are not compared. Needs lines. But
                         methods of opacity optimization are compared with all fragments sorted,
                         in any scene: keys rmse, ssim with the same --importance-reduction, and
                         rmse_full, ssim_full without
--reference-decoded      for voxel, also with an exact picture of the model: key rmse_decoded
--occlusion-reference    for voxel-occlusion and voxel-full, also compare the occlusion of voxels with
                         brute force, and time it: keys densities_ms to bias_occlusion_seen
--occlusion-places N     how many places of the lines that compares, 1 to 1000000 (default 300)
--json FILE              where the JSON goes (default: standard output)
--image PREFIX           write the pictures of the first view as PREFIX-METHOD.png; with
                         --animate, of the lines of the last frame
--data DIR               folder of carotid.vti
--help                   this text
)";
}

void PrintKeys(std::ostream& out)
{
  out << R"(
Keys: scene lines points polygons vertices method engine width height opacity radius light
animated frames median_ms min_ms max_ms cpu_ms rebuild_ms draw_ms build_ms first_frame_ms
model_bytes gpu_bytes segments drawn importance importance_reduction bands subset depth_reduction
half_floats weights smoothing sum_bytes fragments dropped depth_complexity peels shadows shadow_level
cone_angle occlusion occlusion_radius occlusion_samples rmse ssim rmse_full ssim_full rmse_decoded densities_ms
occlusion_ms rmse_occlusion bias_occlusion rmse_occlusion_lines bias_occlusion_lines
rmse_occlusion_seen bias_occlusion_seen ratio_tubes ratio_peeling ratio_lines ratio_fragment_list
ratio_voxel renderer vtk threads error.
Keys that do not apply are left out.

Times are wall clock times of a frame until OpenGL has finished, but cpu_ms is the median of the
processor time of all threads, which other programs disturb less; build_ms is the time to make the
model, the tubes or, for opacity optimization, the segments and patches, first_frame_ms that of the
first frame after it, with uploads and shaders.

With --animate (animated is 1 then) median_ms, min_ms, max_ms and cpu_ms are of whole frames, from
the new lines to the picture. rebuild_ms is the median of the part in which voxel methods made
their model, tubes their triangles or opacity optimization its segments, draw_ms that of the rest of
the frame; uploads and, where shadows or occlusion need them, levels and densities are in the rest.
Lines are drawn as they are and have neither of the two.

densities_ms and occlusion_ms are medians of three times that the densities, and the occlusion of all
voxels that is computed from them, take from scratch; compare build_ms. Brute force casts 2500 rays
of --occlusion-radius from a point on a line through the tubes of the decoded model, of which the
stretch that a ray starts inside does not count. rmse_occlusion and bias_occlusion (positive: too
dark) compare voxels with the mean over 8 points on their lines, at places spread evenly over the
length of all lines; those on lines compare interpolated values at these places themselves, and
those seen at places under random pixels of the first view. Occlusions are in [0,1];
the places are the same in each run.

gpu_bytes of opacity optimization is what its textures and buffers take beside the geometry, and
sum_bytes the part of it that holds sums of series or bins. fragments and dropped are told where
fragments are sorted: their number in the last list, which is that of the importance where only that
is exact, and those that did not fit. depth_complexity is the mean number of fragments of the pixels
that have any, as fragment-list or the reference finds it. With --image, the exact pictures are
written as PREFIX-opacity-reference.png and PREFIX-opacity-reference-full.png.

drawn is the number of segments that illuminated lines drew after merging. gpu_bytes of tubes is
computed from the arrays that VTK uploads. rmse is in [0,1]. ratio_tubes, ratio_peeling,
ratio_lines and ratio_fragment_list are the median time of tubes, peeling, lines or fragment-list
over that of the method. ratio_voxel of
a voxel method is the other way round, its median time over that of plain voxel with the same
engine: what shadows and occlusion cost. The exit status is 0 if all went well, 1 if a method
failed, which its object tells as "error", and 2 for a wrong command line.
)";
}
}

//------------------------------------------------------------------------------
void PrintBenchmarkHelp(std::ostream& out)
{
  PrintOptions(out);
  PrintKeys(out);
}
}
