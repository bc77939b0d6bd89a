// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineModel
 * @brief   a set of curves as short segments in the voxels of a sparse grid
 *
 * Each curve is cut at the faces of a grid of cubic voxels; within a voxel it is one straight
 * segment (or a few, where one would deviate too far). The end points are quantized to bins on
 * the faces, so that a segment takes one 32-bit word. See Kanzler, Rautenhaus and Westermann,
 * "A Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019, Secs. 3.1 to 3.3. Unlike the
 * paper's grid, this one is sparse, has no limit of lines per voxel, keeps the ends of the lines,
 * and knows for each segment which curve it belongs to.
 *
 * <b>Grid-local coordinates.</b> A world point w has the grid-local coordinates
 * (w - Origin) / VoxelSize; voxel (i,j,k) is the cube [i,i+1]x[j,j+1]x[k,k+1]. Only the
 * placement (Origin, VoxelSize) is in world units, and in double, so that data far from the
 * origin loses nothing.
 *
 * <b>Bricks.</b> 4x4x4 voxels make a brick. BrickGrid holds one signed number per brick cell, x
 * fastest: the brick's index if it holds segments, else minus its Chebyshev distance, in brick
 * cells, to the nearest cell that does (-1: a neighbour does); the distance is clamped at 127.
 * Bricks holds five unsigned words per brick:
 * - 0, 1: occupancy mask, low and high word. Voxel (x,y,z) of the brick is bit x + 4y + 16z.
 * - 2: index of the brick's first segment,
 * - 3: index of its first entry in VoxelStarts,
 * - 4: index of its first entry in BrickCurves.
 * One further row after the last brick holds the end indices, so that a brick's range is always
 * [its own, the next one's).
 * VoxelStarts holds, for each occupied voxel of the brick in the order of its mask bit, the
 * voxel's first segment relative to the brick's first one, and one closing entry per brick. It is
 * an array of 16-bit numbers, or of 32-bit ones where a brick has more than 65535 segments.
 * BrickCurves lists the curves of a brick, ascending. A segment's local curve id is an index into
 * that list, so that ids never collide.
 *
 * <b>Order.</b> Segments are ordered by (brick, voxel, curve, position along the curve).
 *
 * <b>Endpoint codes</b>, for N = FaceBins = 2^b: bits [0,b) hold u, [b,2b) hold v, [2b,2b+3) the
 * face. Faces 0 to 5 are -x +x -y +y -z +z. On a face of axis a, u runs along axis (a+1) mod 3 and
 * v along axis (a+2) mod 3, and the point lies in the middle of its bin, at (u + 1/2) / N.
 * Faces 6 and 7 mark a point inside the voxel: with q = (face - 6) N^2 + v N + u and
 * M = floor(cbrt(2 N^2)), its bins along x, y, z are q mod M, (q / M) mod M, q / M^2, and it lies
 * at (bin + 1/2) / M.
 *
 * <b>Encodings.</b> Segments has 1, 2 or 6 components of 32 bits:
 * - OneWord (FaceBins 2 to 32): start code in bits [0,2b+3), end code in bits [2b+3,4b+6), the
 *   lowest 6 bits of the local curve id in bits 26 to 31.
 * - TwoWords (FaceBins 64 to 2048): word 0 has the start code in bits 0 to 25 and the lowest 6 bits
 *   of the id in bits 26 to 31; word 1 the end code and the next 6 bits of the id.
 * - Exact (FaceBins 0): the two end points in voxel-local coordinates [0,1] as 32-bit floats.
 * Where some brick has more curves than these bits can tell apart, CurveIdExtension holds the
 * higher bits for every segment (8, 16 or 32 bits wide).
 *
 * @sa vtkLineVoxelizer vtkVoxelLineMapper vtkVoxelLineGeometry vtkVoxelLineDensity
 */

#ifndef vtkVoxelLineModel_h
#define vtkVoxelLineModel_h

#include "vtkDataObject.h"
#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"          // For array members

#include <string> // For std::string

class vtkDataArray;
class vtkIdTypeArray;
class vtkUnsignedCharArray;

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineModel : public vtkDataObject
{
public:
  static vtkVoxelLineModel* New();
  vtkTypeMacro(vtkVoxelLineModel, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Edge length of a brick, in voxels.
  static constexpr int BrickSize = 4;

  /// Largest distance, in brick cells, that BrickGrid tells.
  static constexpr int LargestBrickDistance = 127;

  /// How the end points of a segment are stored; see the class description.
  enum EncodingType
  {
    OneWord = 0,
    TwoWords = 1,
    Exact = 2
  };

  /// What an attribute of an endpoint means.
  enum AttributeType
  {
    NoAttribute = 0, ///< Attributes is null
    Scalar = 1,      ///< one byte per endpoint, see AttributeRange
    Color = 2        ///< four bytes per endpoint: red, green, blue, opacity
  };

  /// Why a curve of the input is not in the model.
  enum DropReason
  {
    TooFewPoints = 0, ///< no point, or a single one
    NonFinitePoints,  ///< no two points in a row are finite
    InvalidPointIds,  ///< no two point ids in a row belong to points of the input
    NumberOfDropReasons
  };

  /// Parts of the model that GetNumberOfBytes() tells apart.
  enum Part
  {
    SegmentPart = 0, ///< Segments and CurveIdExtension
    AttributePart,   ///< Attributes
    RadiusPart,      ///< Radii
    GridPart,        ///< BrickGrid, Bricks and VoxelStarts
    CurvePart,       ///< BrickCurves and CurveCells
    NumberOfParts
  };

  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;
  int GetDataObjectType() override { return VTK_DATA_OBJECT; }

  /// Memory of all arrays, in KiB, rounded up.
  unsigned long GetActualMemorySize() override;

  ///@{
  /**
   * Retrieve the model from an information object, or nullptr.
   */
  static vtkVoxelLineModel* GetData(vtkInformation* info);
  static vtkVoxelLineModel* GetData(vtkInformationVector* v, int i = 0);
  ///@}

  ///@{
  /**
   * Number of voxels along x, y and z. Default 0 0 0 (an empty model).
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  /// Number of brick cells along x, y and z: Dimensions / BrickSize, rounded up.
  void GetBrickDimensions(int dimensions[3]) const;

  ///@{
  /**
   * World position of the grid's lower corner. Default 0 0 0.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Edge length of a voxel, in world units, above 0. Default 1.
   */
  vtkSetMacro(VoxelSize, double);
  vtkGetMacro(VoxelSize, double);
  ///@}

  ///@{
  /**
   * Bins along the edge of a voxel face: a power of two from 2 to 2048, or 0 for exact end points.
   * Default 32. It determines the encoding.
   */
  vtkSetMacro(FaceBins, int);
  vtkGetMacro(FaceBins, int);
  ///@}

  /// EncodingType that FaceBins asks for.
  int GetEncoding() const;

  /// Number of 32-bit components per segment: 1, 2 or 6.
  int GetSegmentWords() const;

  /// Number of bins per axis for a point inside a voxel: floor(cbrt(2 FaceBins^2)); 0 when exact.
  int GetInteriorBins() const;

  ///@{
  /**
   * The arrays of the model as the class description tells. Arrays that are not needed are null:
   * CurveIdExtension, Attributes and Radii; in an empty model all are.
   * - BrickGrid: signed 32-bit. Bricks, BrickCurves: unsigned 32-bit. VoxelStarts: unsigned, 16 or
   *   32 bits. Segments: unsigned 32-bit, or 32-bit float where end points are exact.
   *   CurveIdExtension: unsigned, 8, 16 or 32 bits.
   * - Attributes: Scalar type 2 components (start, end), Color type 8 components.
   *   A scalar byte q stands for (1 - q / m) AttributeRange[0] + q / m AttributeRange[1], with
   *   m = 254 where HasNaNAttribute is set, and 255 else; where it is set, 255 stands for NaN.
   * - Radii: 2 components (start, end); a byte q stands for the radius q / 255 * MaximumRadius.
   * - CurveCells: one row (input connection index, cell id) per curve of the model.
   */
  virtual void SetBrickGrid(vtkDataArray* array);
  vtkDataArray* GetBrickGrid() const;
  virtual void SetBricks(vtkDataArray* array);
  vtkDataArray* GetBricks() const;
  virtual void SetVoxelStarts(vtkDataArray* array);
  vtkDataArray* GetVoxelStarts() const;
  virtual void SetSegments(vtkDataArray* array);
  vtkDataArray* GetSegments() const;
  virtual void SetCurveIdExtension(vtkDataArray* array);
  vtkDataArray* GetCurveIdExtension() const;
  virtual void SetBrickCurves(vtkDataArray* array);
  vtkDataArray* GetBrickCurves() const;
  virtual void SetCurveCells(vtkIdTypeArray* array);
  vtkIdTypeArray* GetCurveCells() const;
  virtual void SetAttributes(vtkUnsignedCharArray* array);
  vtkUnsignedCharArray* GetAttributes() const;
  virtual void SetRadii(vtkUnsignedCharArray* array);
  vtkUnsignedCharArray* GetRadii() const;
  ///@}

  ///@{
  /**
   * What the attributes are (AttributeType) and, for scalars, the range that the bytes span and
   * whether the byte 255 marks NaN.
   */
  vtkSetMacro(AttributeKind, int);
  vtkGetMacro(AttributeKind, int);
  vtkSetVector2Macro(AttributeRange, double);
  vtkGetVector2Macro(AttributeRange, double);
  vtkSetMacro(HasNaNAttribute, bool);
  vtkGetMacro(HasNaNAttribute, bool);
  ///@}

  ///@{
  /**
   * Largest radius of the Radii array, in world units; 0 without that array.
   */
  vtkSetMacro(MaximumRadius, double);
  vtkGetMacro(MaximumRadius, double);
  ///@}

  ///@{
  /**
   * Bounds of the curves (without their radius), in world units; 1 -1 1 -1 1 -1 when
   * the model is empty.
   */
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * What the model holds.
   */
  vtkIdType GetNumberOfSegments() const;
  vtkIdType GetNumberOfBricks() const;
  vtkIdType GetNumberOfCurves() const;
  vtkIdType GetNumberOfOccupiedVoxels() const;
  ///@}

  ///@{
  /**
   * What it cost and lost.
   * - NumberOfDuplicates: segments with the same two end points as another segment of their voxel
   *   (Kanzler et al., Fig. 16c). They are kept, each with its own curve and attributes, so that
   *   transparency is right.
   * - NumberOfCollapsedSegments: segments whose end points fell on each other and that are left
   *   out, since their neighbours on the curve end in the same point.
   * - NumberOfDroppedCurves by reason, lines of the input and pieces of them that have no two
   *   usable points in a row.
   * - NumberOfDroppedPoints: points that are not finite, and point ids that do not exist. They
   *   interrupt a curve: it goes on after them as a new curve of the same cell.
   * - LargestDeviation: largest distance between a point of a curve and the segment that
   *   represents it, in world units.
   */
  vtkSetMacro(NumberOfDuplicates, vtkIdType);
  vtkGetMacro(NumberOfDuplicates, vtkIdType);
  vtkSetMacro(NumberOfCollapsedSegments, vtkIdType);
  vtkGetMacro(NumberOfCollapsedSegments, vtkIdType);
  void SetNumberOfDroppedCurves(int reason, vtkIdType number);
  vtkIdType GetNumberOfDroppedCurves(int reason) const;
  vtkSetMacro(NumberOfDroppedPoints, vtkIdType);
  vtkGetMacro(NumberOfDroppedPoints, vtkIdType);
  vtkSetMacro(LargestDeviation, double);
  vtkGetMacro(LargestDeviation, double);
  ///@}

  /**
   * What keeps the model from being drawn or read: an array that is missing or that does not have
   * the type, components or rows that the class description asks for, or a grid that cannot be.
   * Empty where the model is complete or empty. The entries of the arrays are not looked through,
   * except for the closing row of Bricks, so that it takes no time to speak of.
   */
  std::string FindDefect() const;

  /// Bytes that a part of the model takes.
  vtkIdType GetNumberOfBytes(int part) const;

  /// Bytes that the whole model takes.
  vtkIdType GetNumberOfBytes() const;

  /**
   * Decode the end points of a segment in voxel-local coordinates [0,1]. For tests, filters and
   * users; the ray casters decode by themselves. An error is told, and the points are 0, where
   * there is no such segment.
   */
  void GetSegmentPoints(vtkIdType segment, double start[3], double end[3]) const;

  /**
   * Index of the curve that a segment of the given brick belongs to. An error is told, and it is
   * -1, where the brick has no such segment.
   */
  vtkIdType GetSegmentCurve(vtkIdType brick, vtkIdType segment) const;

protected:
  vtkVoxelLineModel();
  ~vtkVoxelLineModel() override;

  ///@{
  /**
   * Parts of FindDefect().
   */
  std::string FindGridDefect() const;
  std::string FindArraysDefect() const;
  ///@}

  /// Everything but the arrays.
  void CopyMembers(vtkVoxelLineModel* model);

  int Dimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double VoxelSize = 1.0;
  int FaceBins = 32;
  int AttributeKind = NoAttribute;
  double AttributeRange[2] = { 0.0, 1.0 };
  bool HasNaNAttribute = false;
  double MaximumRadius = 0.0;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  vtkIdType NumberOfDuplicates = 0;
  vtkIdType NumberOfCollapsedSegments = 0;
  vtkIdType NumberOfDroppedCurves[NumberOfDropReasons] = { 0, 0, 0 };
  vtkIdType NumberOfDroppedPoints = 0;
  double LargestDeviation = 0.0;

  vtkSmartPointer<vtkDataArray> BrickGrid;
  vtkSmartPointer<vtkDataArray> Bricks;
  vtkSmartPointer<vtkDataArray> VoxelStarts;
  vtkSmartPointer<vtkDataArray> Segments;
  vtkSmartPointer<vtkDataArray> CurveIdExtension;
  vtkSmartPointer<vtkDataArray> BrickCurves;
  vtkSmartPointer<vtkIdTypeArray> CurveCells;
  vtkSmartPointer<vtkUnsignedCharArray> Attributes;
  vtkSmartPointer<vtkUnsignedCharArray> Radii;

private:
  vtkVoxelLineModel(const vtkVoxelLineModel&) = delete;
  void operator=(const vtkVoxelLineModel&) = delete;
};

#endif
