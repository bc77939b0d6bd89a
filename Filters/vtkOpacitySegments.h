// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpacitySegments
 * @brief   part lines and surfaces into the segments that opacity optimization works on
 *
 * Opacity optimization finds one opacity for each segment of a line and each patch of a surface,
 * smooths these along the geometry, and interpolates them at the vertices. See Baeza Rojo, Gross
 * and Guenther, "Fourier Opacity Optimization for Scalable Exploration", 2019, Sec. 4.1.
 *
 * This filter makes the segments and what the interpolation needs:
 * 1. Lines are cut into segments of equal arc length.
 * 2. On surfaces, seeds are placed by geodesic farthest-point sampling; a patch is the set of
 *    vertices that are nearer to its seed than to any other (a geodesic Voronoi cell).
 * 3. Each point that only vertex cells use is a segment of its own.
 *
 * The output has the points, cells and attributes of the input, and in addition
 * - point array `OpacitySegmentIds` (int, 3 components): the segment that the point belongs to,
 *   and those that follow in distance, or -1 where there is none;
 * - point array `OpacitySegmentDistances` (float, 4 components): distances along the geometry to
 *   the centres of these three segments, in world units and ascending, and the cut-off distance.
 *   The distance of a missing segment is the cut-off. GetWeights() tells the interpolation;
 * - field array `OpacitySegmentNeighbors` (int, 2 components): each pair of neighbours once, the
 *   smaller id first, sorted. Neighbours follow each other on a line, the last and the first of a
 *   closed one too, or are patches that an edge joins;
 * - field array `NumberOfOpacitySegments` (int, one value).
 * Arrays of these names that the input has are replaced.
 *
 * <b>Ids</b> count from 0: the segments along each line, in the order of the cells, then the
 * patches, then the points. They are below 2^24, so that single precision holds them exactly.
 * Segments become longer where there would be more, and a warning tells so.
 *
 * <b>Lines.</b> The second segment of a point is the one whose centre is next on the other side,
 * and the cut-off is the distance of the two centres: opacity is interpolated linearly along the
 * line. Before the first centre of a line and after the last one, the end segment alone counts,
 * with distance 0 and cut-off 1; closed lines, whose first and last points coincide, have no ends.
 *
 * <b>Surfaces.</b> The segments of a point are the three nearest seeds, and the cut-off is the
 * distance of the fourth, so that weights are continuous where seeds change places. The exception
 * is a point from which four seeds are equally far. A connected piece with two or three patches has
 * one cut-off, the largest distance of any of its points to any of its seeds; with a single patch,
 * distances are 0 and the cut-off is 1. Points at identical coordinates are one vertex of the
 * surface. Distances are exact on planes up to rounding, but for few cut-offs, and within 1 % on
 * spheres of more than 1200 vertices. A million triangles with 500 patches take about 4 s.
 *
 * <b>Shared points.</b> A point that several lines use, or lines, surfaces and vertices, belongs to
 * the first that uses it, lines before surfaces before vertices; see GetNumberOfSharedPoints().
 * Pass geometry whose cells do not share points where that matters.
 *
 * <b>What cannot be used</b> is left out, counted, and told in one warning: points that are not
 * finite or whose id does not exist, and lines of fewer than two points. A line is parted there,
 * and a polygon loses that corner, or is ignored where the id does not exist. Points that nothing
 * uses have ids of -1, distances of 1 and a cut-off of 1. Distances that single precision cannot
 * hold are in units of the cut-off, which gives the same weights.
 *
 * Lines are shared by threads with vtkSMPTools. The result does not depend on their number.
 */

#ifndef vtkOpacitySegments_h
#define vtkOpacitySegments_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class VTKFILTERSLINESETS_EXPORT vtkOpacitySegments : public vtkPolyDataAlgorithm
{
public:
  static vtkOpacitySegments* New();
  vtkTypeMacro(vtkOpacitySegments, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Most segments of all kinds together: ids are exact in single precision.
  static constexpr int LargestNumberOfSegments = (1 << 24) - 1;

  ///@{
  /// Names of the arrays.
  static const char* GetIdsName() { return "OpacitySegmentIds"; }
  static const char* GetDistancesName() { return "OpacitySegmentDistances"; }
  static const char* GetNeighborsName() { return "OpacitySegmentNeighbors"; }
  static const char* GetCountName() { return "NumberOfOpacitySegments"; }
  ///@}

  ///@{
  /**
   * Number of segments of all lines together, 0 to 2^24-1. Default 0: 16 per line, but at most one
   * for four points, and at least 50 000. Their length is the total length of the lines divided by
   * it; then each line gets a whole number of them, at least one, so that the total differs a
   * little. Lines of few segments have nearly the same opacity all along. The paper uses 20 000 to
   * 150 000 (Sec. 5.5.2). A value out of range is an error, and the old one stays.
   */
  virtual void SetNumberOfLineSegments(int number);
  vtkGetMacro(NumberOfLineSegments, int);
  ///@}

  ///@{
  /**
   * Length of the segments of lines in world units, 0 or above. Default 0: NumberOfLineSegments
   * rules. It is rounded so that each line has a whole number of segments. A value out of range is
   * an error, and the old one stays.
   */
  virtual void SetSegmentLength(double length);
  vtkGetMacro(SegmentLength, double);
  ///@}

  ///@{
  /**
   * Number of patches of all surfaces together, 1 to 2^24-1. Each connected piece has at least one,
   * and each vertex at most one. Default 500, as in the paper (Sec. 5.5.2). A value out of range is
   * an error, and the old one stays.
   */
  virtual void SetNumberOfPatches(int number);
  vtkGetMacro(NumberOfPatches, int);
  ///@}

  /**
   * Weights of the three segments of a point for one tuple of each array: max(0, 1 - distance /
   * cut-off), divided by their sum. A missing segment has weight 0. Where all would be 0, the
   * first segment has weight 1; where there is none, all are 0.
   */
  static void GetWeights(const int ids[3], const float distances[4], double weights[3]);

  ///@{
  /// Number of segments of all kinds that the last update made.
  int GetNumberOfSegments() const;
  /// Those of each kind.
  vtkGetMacro(NumberOfSegmentsOfLines, int);
  vtkGetMacro(NumberOfSegmentsOfSurfaces, int);
  vtkGetMacro(NumberOfSegmentsOfPoints, int);
  ///@}

  ///@{
  /// Number of points that several lines, or lines, surfaces and vertex cells share.
  vtkGetMacro(NumberOfSharedPoints, vtkIdType);
  /// Number of uses of points that are not finite, by lines and vertex cells; each point of the
  /// surfaces counts once.
  vtkGetMacro(NumberOfNonFinitePoints, vtkIdType);
  /// Number of uses of point ids that do not exist, counted alike.
  vtkGetMacro(NumberOfInvalidIds, vtkIdType);
  ///@}

protected:
  vtkOpacitySegments() = default;
  ~vtkOpacitySegments() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfLineSegments = 0;
  double SegmentLength = 0.0;
  int NumberOfPatches = 500;

private:
  /// Returns what went wrong, or an empty string.
  std::string Execute(vtkPolyData* input, vtkPolyData* output, std::string& warning);

  int NumberOfSegmentsOfLines = 0;
  int NumberOfSegmentsOfSurfaces = 0;
  int NumberOfSegmentsOfPoints = 0;
  vtkIdType NumberOfSharedPoints = 0;
  vtkIdType NumberOfNonFinitePoints = 0;
  vtkIdType NumberOfInvalidIds = 0;

  vtkOpacitySegments(const vtkOpacitySegments&) = delete;
  void operator=(const vtkOpacitySegments&) = delete;
};

#endif
