// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminatedLineMapper
 * @brief   draws lines, a number of pixels wide, lit as thin cylinders
 *
 * Takes the place of a vtkPolyDataMapper whose lines are to be lit (Mallo, Peikert, Sigg and Sadlo,
 * "Illuminated Lines Revisited", IEEE Visualization 2005; vtkLineIllumination tells the model). No
 * geometry of tubes is made: each point gets a tangent, and the light is computed for each pixel.
 *
 * @code{.cpp}
 * vtkNew<vtkIlluminatedLineMapper> mapper;
 * mapper->SetInputConnection(streamTracer->GetOutputPort());
 * actor->SetMapper(mapper);
 * actor->GetProperty()->SetSpecular(0.5);
 * actor->GetProperty()->SetSpecularPower(50.0);
 * @endcode
 *
 * <b>What is lit.</b> Lines of the input, drawn as wireframe or surface, by all lights of the
 * renderer that are switched on, up to 16; a warning tells how many are left out. Interpolation of
 * vtkProperty and normals of the input make no difference to them; what is physically based of
 * vtkProperty has no effect. Vertices, polygons and strips, also as wireframe, lines as points, and
 * highlighted selections are drawn as vtkPolyDataMapper draws them, and so are all lines where
 * vtkProperty asks for tubes (RenderLinesAsTubes with a LineWidth above 1), where it switches
 * lighting off, and where no light is switched on.
 * Colours by scalars, line width, multi-sampling, clipping planes, selection, textures,
 * coincident topology, order-independent translucency and depth peeling are those of
 * vtkPolyDataMapper.
 *
 * <b>Tangents</b> run from the point before to the one after; at the ends of a line from or to the
 * only neighbour; in a closed line (its last point is the first one, by id or by coordinates)
 * across the seam. Repeated points have the tangent of the place. A point that several lines share
 * has a tangent in each: such points are repeated in a copy of the input, while selection gives the
 * ids of the input. Lines of two points each are therefore lit each by itself; vtkStripper joins
 * them. Tangents are computed when the input changed, not for camera, lights or property.
 *
 * <b>Bad input</b> costs nothing but itself, and warnings tell it once: lines without extent are
 * lit as if they lay across view and light, points that are not finite part their line, an exponent
 * of vtkProperty that is not a number is taken for 1. Ids of points that do not exist are told, but
 * what is drawn then is as undefined as with vtkPolyDataMapper.
 *
 * @sa vtkLineIllumination vtkVoxelLineMapper vtkPolyDataMapper
 */

#ifndef vtkIlluminatedLineMapper_h
#define vtkIlluminatedLineMapper_h

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <map>    // For the shaders
#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For selected pixels

class vtkLineIllumination;

class VTKRENDERINGLINESETS_EXPORT vtkIlluminatedLineMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkIlluminatedLineMapper* New();
  vtkTypeMacro(vtkIlluminatedLineMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How the lines reflect light; may be shared by several mappers. Default: an object of the
   * mapper's own with the defaults of vtkLineIllumination; nullptr brings such a one back.
   */
  virtual void SetIllumination(vtkLineIllumination* illumination);
  vtkLineIllumination* GetIllumination();
  ///@}

  ///@{
  /**
   * Name of a point array of three components with the tangents, in data coordinates, of any length
   * and either sense. Default empty: tangents are computed. Where the array is missing or has
   * another shape, and where a tuple is null or not finite, computed tangents take its place, and a
   * warning says so.
   */
  virtual void SetTangentArrayName(const std::string& name);
  vtkGetMacro(TangentArrayName, std::string);
  ///@}

  ///@{
  /**
   * Name of a point array of one component with the exponent of the specular term, 0 to 1000,
   * interpolated along the line. Default empty: the exponent of the light model, which is that of
   * vtkLineIllumination or else of vtkProperty. It also takes the place of the array where that is
   * missing or has another shape, and of values that are negative or NaN; values above 1000 are
   * taken for 1000; a warning says so.
   */
  virtual void SetSpecularPowerArrayName(const std::string& name);
  vtkGetMacro(SpecularPowerArrayName, std::string);
  ///@}

  ///@{
  /**
   * Consecutive segments of a lit line that are together no longer than so many pixels of the
   * screen, 0 or above, are drawn as one, unless that would move the line by more than an eighth of
   * it: line sets often have many points to a pixel, and the time goes by the segment. Default 3:
   * lines move by at most three eighths of a pixel. 0: every segment is drawn.
   *
   * Where no segment is longer, light is computed for each point and interpolated, not for each
   * pixel. Colours of the points in between do not count. Where cells have colours, are selected,
   * or lines are not lit, every segment is drawn as with 0. A negative value, infinity or NaN is an
   * error.
   */
  virtual void SetMergeLength(double pixels);
  vtkGetMacro(MergeLength, double);
  ///@}

  ///@{
  /**
   * Bounds in data coordinates (smallest x, largest x, ...), used when UseCustomBounds is on
   * instead of those of the input, to tell how long MergeLength is where lines are nearest. So
   * several mappers merge alike, as processes do of which each draws a part of a line set. Default
   * off, and 0 1 0 1 0 1.
   */
  vtkSetMacro(UseCustomBounds, bool);
  vtkGetMacro(UseCustomBounds, bool);
  vtkBooleanMacro(UseCustomBounds, bool);
  vtkSetVector6Macro(CustomBounds, double);
  vtkGetVector6Macro(CustomBounds, double);
  ///@}

  /// Number of segments that were drawn in the last frame, after merging; 0 before the first one
  /// and where lines were drawn as points. Frames of selections do not count.
  vtkGetMacro(NumberOfDrawnSegments, vtkIdType);

  /// Modification time of the mapper, its lookup table and its illumination.
  vtkMTimeType GetMTime() override;

  using Superclass::MapScalars;
  /// Where points of the input are repeated, so are the colours.
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop) override;

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkIlluminatedLineMapper();
  ~vtkIlluminatedLineMapper() override;

  void UpdateCameraShiftScale(vtkRenderer* renderer, vtkActor* actor) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderLight(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderPositionVC(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetLightingShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

  std::string TangentArrayName;
  std::string SpecularPowerArrayName;
  double MergeLength = 3.0;
  bool UseCustomBounds = false;
  double CustomBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  vtkIdType NumberOfDrawnSegments = 0;

private:
  vtkIlluminatedLineMapper(const vtkIlluminatedLineMapper&) = delete;
  void operator=(const vtkIlluminatedLineMapper&) = delete;

  void UpdateVertices();
  bool IsOpaqueEverywhere(vtkActor* actor);
  void UpdateMergeLength(vtkRenderer* renderer, vtkActor* actor);
  bool AreLinesLit(vtkOpenGLHelper& lines, vtkRenderer* renderer, vtkActor* actor);
  /// Of the selected pixels, from the array that ProcessIdArrayName names: the superclass puts them
  /// into the raw buffer, which tells what was drawn and which no selection is made from.
  void WriteProcesses(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixelOffsets);
  void WarnOnce(std::string& last, const std::string& warning);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
