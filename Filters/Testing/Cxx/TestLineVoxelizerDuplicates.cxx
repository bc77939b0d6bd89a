// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the count of segments that quantization made equal: it is right, whichever way a segment
 * points, and its rate on smooth curves stays below that of Kanzler et al. 2019, Fig. 16c: less
 * than 0.1 % from 128^3 voxels and 32 bins on.
 */

#include "VoxelLineTesting.h"

#include <map>

using namespace VoxelLineTesting;

namespace
{

vtkIdType CountByHand(vtkVoxelLineModel* model)
{
  std::map<std::pair<Point, Point>, vtkIdType> counts;
  for (const Segment& segment : DecodeModel(model))
  {
    ++counts[std::minmax(segment.Start, segment.End)];
  }
  return model->GetNumberOfSegments() - static_cast<vtkIdType>(counts.size());
}

}

int TestLineVoxelizerDuplicates(int, char*[])
{
  Checks check;
  // The same line three times, once backwards, and a line on its own.
  const std::vector<Curve> same = { { { 0.0, 0.0, 0.0 }, { 1.0, 0.7, 0.4 } },
    { { 0.0, 0.0, 0.0 }, { 1.0, 0.7, 0.4 } }, { { 1.0, 0.7, 0.4 }, { 0.0, 0.0, 0.0 } },
    { { 0.0, 0.5, 0.1 }, { 0.2, 0.1, 0.9 } } };
  for (int bins : { 0, 4, 32, 256 })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(same), 9, bins);
    vtkSmartPointer<vtkVoxelLineModel> one = MakeModel(check, MakeLines({ same[0] }), 9, bins);
    const std::string name = std::to_string(bins) + " bins";
    check(model->GetNumberOfDuplicates() == CountByHand(model), name + ": equal lines, by hand");
    // Bounds differ in z, but the first line is cut as often in both; backwards, the two lines may
    // fall into other bins only where a crossing lies on the border between two.
    check(model->GetNumberOfDuplicates() >= one->GetNumberOfSegments(), name + ": equal lines");
  }
  vtkSmartPointer<vtkPolyData> random = MakeLines(MakeSmoothCurves(300, 50));
  for (int bins : { 2, 4, 8 })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, random, 16, bins);
    check(
      model->GetNumberOfDuplicates() > 0 && model->GetNumberOfDuplicates() == CountByHand(model),
      std::to_string(bins) + " bins: random curves, by hand");
  }

  vtkSmartPointer<vtkPolyData> smooth = MakeLines(MakeSmoothCurves(2000, 400));
  double previous = 1.0;
  for (int resolution : { 32, 64, 128, 256 })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, smooth, resolution, 32);
    const double rate =
      static_cast<double>(model->GetNumberOfDuplicates()) / model->GetNumberOfSegments();
    std::cout << "Resolution " << resolution << ": " << 100.0 * rate << " % duplicates of "
              << model->GetNumberOfSegments() << " segments\n";
    check(resolution < 128 || rate < 0.001,
      "less than 0.1 % duplicates at resolution " + std::to_string(resolution));
    check(rate <= previous, "the rate falls with the resolution");
    previous = rate;
  }
  return check.GetResult();
}
