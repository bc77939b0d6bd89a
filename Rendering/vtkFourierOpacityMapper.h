// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityMapper
 * @brief   draws points, lines and surfaces and fades what hides the important ones
 *
 * Takes the place of a vtkPolyDataMapper. An array tells how important each point or cell is, and
 * the opacity of everything follows from it for each view: what is important stays opaque, what
 * lies before it or clutters the view behind it fades (Baeza Rojo, Gross and Guenther, "Fourier
 * Opacity Optimization for Scalable Exploration", IEEE TVCG 26(11), 2020). vtkOpacityOptimization
 * has the parameters and tells the method.
 *
 * @code{.cpp}
 * vtkNew<vtkFourierOpacityMapper> mapper;
 * mapper->SetInputConnection(streamTracer->GetOutputPort());
 * mapper->SetImportanceArrayName("Vorticity");
 * actor->SetMapper(mapper);
 * @endcode
 *
 * Fragments are blended in order of depth without sorting them, in memory that depends on the size
 * of the picture alone.
 *
 * <b>Several actors.</b> By itself the mapper optimizes and blends its own actor only; to the rest
 * of the scene it is one translucent layer. vtkFourierOpacityPass does it for all actors of a
 * renderer together, so that they fade for each other.
 *
 * <b>What is drawn</b> is what vtkIlluminatedLineMapper draws: vertices, lines, polygons and
 * strips; lines are lit as thin cylinders, surfaces as VTK lights them. Colours by scalars,
 * clipping planes, textures and selection are those of vtkPolyDataMapper. The optimized opacity
 * multiplies that of colours and property. Everything is drawn in the translucent pass.
 *
 * <b>Segments.</b> Opacity belongs to segments of lines, patches of surfaces and single points, and
 * is interpolated between their centres. Where the input lacks the arrays of vtkOpacitySegments,
 * the mapper runs that filter once for each new input. Where a cell is drawn between points of
 * different segments, it counts as its last point's.
 *
 * <b>Selection</b> leaves out what is fainter than 0.1 in the last picture of the renderer.
 *
 * <b>Needs</b> OpenGL 4.2. Where there is less, an error says so, once, and nothing is drawn by
 * this mapper; the rest of the scene is. Wrong input costs nothing but itself: without a usable
 * array nothing is important, and everything is opaque; a warning tells it once.
 *
 * @sa vtkFourierOpacityPass vtkOpacityOptimization vtkOpacitySegments vtkIlluminatedLineMapper
 */

#ifndef vtkFourierOpacityMapper_h
#define vtkFourierOpacityMapper_h

#include "vtkDataObject.h" // For associations
#include "vtkIlluminatedLineMapper.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <limits> // For open sides
#include <map>    // For the shaders
#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkFourierOpacityPainter;
struct vtkFourierOpacityGroup;
struct vtkFourierOpacityStage;
class vtkOpacityOptimization;
class vtkShaderProgram;

class VTKRENDERINGLINESETS_EXPORT vtkFourierOpacityMapper : public vtkIlluminatedLineMapper
{
public:
  static vtkFourierOpacityMapper* New();
  vtkTypeMacro(vtkFourierOpacityMapper, vtkIlluminatedLineMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How opacity is optimized; may be shared by several mappers. Default: an object of the
   * mapper's own; nullptr brings such a one back. Without effect in a vtkFourierOpacityPass, which
   * has its own.
   */
  virtual void SetOptimization(vtkOpacityOptimization* optimization);
  vtkOpacityOptimization* GetOptimization();
  ///@}

  ///@{
  /**
   * Name of the array that tells importance; of several components the length counts. A point of
   * several cells is as important as the most important one. Default empty: the active scalars.
   */
  virtual void SetImportanceArrayName(const std::string& name);
  vtkGetMacro(ImportanceArrayName, std::string);
  ///@}

  ///@{
  /**
   * What the array that tells importance belongs to: vtkDataObject::FIELD_ASSOCIATION_POINTS,
   * FIELD_ASSOCIATION_CELLS or, the default, FIELD_ASSOCIATION_POINTS_THEN_CELLS: points and, where
   * these have no such array, cells. Another value is an error.
   */
  virtual void SetImportanceArrayAssociation(int association);
  vtkGetMacro(ImportanceArrayAssociation, int);
  ///@}

  ///@{
  /**
   * Values of the array that count as unimportant and as most important, 0 and 1; others lie
   * between or are clamped. Default (1, 0): the first is above the second, and the range of the
   * array's finite values counts. NaN and infinity are errors.
   */
  virtual void SetImportanceRange(double low, double high);
  void SetImportanceRange(const double range[2]) { this->SetImportanceRange(range[0], range[1]); }
  vtkGetVector2Macro(ImportanceRange, double);
  ///@}

  ///@{
  /**
   * Number of segments into which all lines are cut, 0 to 2^24-1, where the input has none. Default
   * 0: 16 per line, but at most one for four points, and at least 50 000. The paper has 20 000 to
   * 150 000.
   */
  virtual void SetNumberOfLineSegments(int number);
  vtkGetMacro(NumberOfLineSegments, int);
  ///@}

  ///@{
  /**
   * Number of patches into which all surfaces are cut, 1 to 2^24-1, where the input has none.
   * Default 500, as in the paper.
   */
  virtual void SetNumberOfPatches(int number);
  vtkGetMacro(NumberOfPatches, int);
  ///@}

  ///@{
  /**
   * Part of the scene that is drawn, a box in world coordinates (smallest x, largest x, ...), for
   * processes that share a picture; infinite sides are open. Other than with clipping planes, the
   * optimized opacity counts what lies outside. So processes that all have everything draw the same
   * opacities, and their pictures of boxes side by side, laid over each other in the order of the
   * boxes, are that of the whole scene, except that the sums of blending approximate each by
   * itself. Default: everything. NaN is an error.
   */
  virtual void SetRegion(const double region[6]);
  const double* GetRegion() const { return this->Region; }
  ///@}

  /**
   * Forget the opacities of earlier pictures. What a picture does not show keeps them, and its
   * neighbours are smoothed with it, so that a picture depends on those before it; the next one
   * does not.
   */
  void ForgetOpacities();

  ///@{
  /// Bytes on the graphics device for sums, layers and opacities, of the mapper by itself. 0 before
  /// the first picture.
  vtkIdType GetNumberOfBytes();
  /// Bytes on the graphics device for the sums alone, which the paper counts.
  vtkIdType GetNumberOfSumBytes();
  ///@}

  ///@{
  /**
   * Number of fragments of the last picture of the mapper by itself that was made with lists.
   */
  vtkIdType GetNumberOfFragments();
  /// Number of fragments of that picture that were dropped since they did not fit, which a warning
  /// tells.
  vtkIdType GetNumberOfDroppedFragments();
  /// Mean number of fragments of that picture over the pixels that have any.
  double GetMeanDepthComplexity();
  ///@}

  /// Number of pictures whose mean was drawn last by the mapper by itself, up to
  /// AccumulationFrames; 0 before the first one.
  int GetNumberOfAccumulatedPictures();

  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }

  vtkMTimeType GetMTime() override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkFourierOpacityMapper();
  ~vtkFourierOpacityMapper() override;

  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateShaders(vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  bool HaveWideLines(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderRenderPass(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
    vtkActor* actor, bool prePass) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

  std::string ImportanceArrayName;
  int ImportanceArrayAssociation = vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
  double ImportanceRange[2] = { 1.0, 0.0 };
  int NumberOfLineSegments = 0;
  int NumberOfPatches = 500;
  static constexpr double Open = std::numeric_limits<double>::infinity();
  double Region[6] = { -Open, Open, -Open, Open, -Open, Open };

private:
  friend class vtkFourierOpacityPainter;
  friend class vtkFourierOpacityPass;

  vtkFourierOpacityMapper(const vtkFourierOpacityMapper&) = delete;
  void operator=(const vtkFourierOpacityMapper&) = delete;

  /// What the painter and the pass ask for: the elements of the input, which is brought up to date;
  /// and a draw with the shaders of a stage, by itself or as the actor draws it.
  vtkFourierOpacityGroup UpdateElements();
  void RenderStage(
    vtkRenderer* renderer, vtkActor* actor, const vtkFourierOpacityStage& stage, bool byActor);
  /// Whose last picture tells what a selection leaves out.
  void SetSelectionPainter(const std::shared_ptr<vtkFourierOpacityPainter>& painter);
  /// Sizes of points and widths of lines in pictures of reduced resolution, and what part of its
  /// pixels they should cover.
  double GetReducedSize(double size);
  bool IsOfPoints(const vtkOpenGLHelper& cellBO, vtkActor* actor);
  float GetCoverage(vtkOpenGLHelper& cellBO, vtkActor* actor);
  bool HasReducedLines(vtkActor* actor);
  static void SetLineWidth(vtkShaderProgram* program, vtkRenderer* renderer, double pixels);
  bool HasHalo(vtkActor* actor);
  void SetHaloParameters(vtkShaderProgram* program, vtkRenderer* renderer, vtkActor* actor);
  void RenderSelection(vtkRenderer* renderer, vtkActor* actor);
  int GetNumberOfRegionPlanes() const;
  void SetRegionParameters(vtkShaderProgram* program, vtkRenderer* renderer);
  void RenderAlone(vtkRenderer* renderer, vtkActor* actor);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
