// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineMapper
 * @brief   draws large line sets as tubes by ray casting a voxel line model
 *
 * The lines of a vtkPolyData are cut into a sparse grid of voxels (vtkLineVoxelizer), and each
 * pixel's ray visits the voxels in order from front to back (Kanzler, Rautenhaus and Westermann,
 * "A Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019, Sec. 4). Opaque and transparent
 * lines are therefore drawn in exact order, without sorting and without fragment lists, and the
 * time depends on the picture rather than on the number of lines.
 *
 * It takes the place of a vtkTubeFilter with a vtkPolyDataMapper:
 *
 * @code{.cpp}
 * vtkNew<vtkVoxelLineMapper> mapper;
 * mapper->SetInputConnection(streamTracer->GetOutputPort());
 * mapper->SetRadius(0.01);
 * actor->SetMapper(mapper);
 * actor->GetProperty()->SetOpacity(0.25);
 * @endcode
 *
 * <b>Input</b> is a vtkPolyData, of which the lines are drawn (vertices, polygons and strips are
 * not), or a vtkVoxelLineModel, which may be shared by several mappers and windows. From a
 * vtkPolyData the mapper builds the model itself, and again only when the input, what colours it,
 * or Resolution, FaceBins, InteriorTolerance or RadiusArrayName changed. Camera, actor, property,
 * lookup table, Radius and clipping planes rebuild nothing.
 *
 * <b>Colours</b> follow vtkMapper: ScalarVisibility, ScalarMode, the selected array and component,
 * ColorMode, LookupTable and ScalarRange. Scalars are stored as 8 bits over the range of the array
 * and looked up when drawing; unsigned char arrays with ColorMode default, and any array with
 * ColorMode direct, are direct colours. InterpolateScalarsBeforeMapping has no effect: along a line
 * scalars are always interpolated before they are mapped. Where the array that was asked for is
 * missing or of the wrong length, the lines get the property's colour, and a warning says so once.
 * Of vtkProperty count colours, ambient, diffuse, specular, specular power, opacity and lighting;
 * representation, line width, interpolation and textures do not.
 *
 * <b>Light</b> is that of vtkLineIllumination. Tubes wider than a pixel show it at each point of
 * their surface, as vtkPolyDataMapper's surfaces do, and thinner ones as its average over their
 * width; see SubPixelCoverage. A model of light that no surface has, MaximumReflection or a
 * stretched dynamic range, lights tubes of any width as lines. In parallel views the viewer is in
 * the direction of the camera everywhere, whereas surfaces in VTK 9.1 take the direction to the
 * camera's position, which moves their highlights.
 *
 * <b>Passes.</b> The picture is ray cast once per frame and drawn as one layer with depth, in the
 * plain pass and in order-independent translucency and depth peeling. Rays end at opaque actors
 * drawn before. Where tubes are thinner than a pixel (SubPixelCoverage), what is behind them shows
 * through, and they are drawn in the translucent pass; an actor with ForceOpaque hides opaque
 * actors drawn later behind them. To other translucent actors the lines are one layer, at the depth
 * of the first line.
 *
 * <b>Selection</b> with vtkHardwareSelector gives for cells the cell of the input that a line came
 * from, with the composite index 1 (plus the index of the input connection, where a shared model
 * was made from several), and for points that point of the cell which is nearest to what is
 * seen. A shared model knows no points, so that points cannot be selected in it: a warning says so.
 *
 * <b>Errors.</b> A setter that is given a value out of range reports an error that names the range
 * and keeps the last valid value. Where the graphics context cannot do what is needed, an error
 * names what is missing, once, and nothing is drawn by this mapper; the rest of the scene is.
 *
 * @sa vtkLineVoxelizer vtkVoxelLineModel
 */

#ifndef vtkVoxelLineMapper_h
#define vtkVoxelLineMapper_h

#include "vtkLineVoxelizer.h" // For what is measured
#include "vtkPolyDataMapper.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <limits> // For open sides
#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkLineGlobalIllumination;
class vtkLineIllumination;
class vtkVoxelLineModel;

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineMapper : public vtkPolyDataMapper
{
public:
  static vtkVoxelLineMapper* New();
  vtkTypeMacro(vtkVoxelLineMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where rays are cast.
  enum EngineType
  {
    Automatic = 0, ///< native where OpenGL runs on the processor, shader else
    Native = 1,    ///< on the processor, over tiles with vtkSMPTools
    Shader = 2     ///< in a fragment shader (OpenGL 3.2)
  };

  /// What is drawn of tubes that reach out of their voxels.
  enum QualityType
  {
    AutomaticQuality = 0,   ///< by the window's desired update rate
    InteractiveQuality = 1, ///< what lies in voxels that a ray passes
    StillQuality = 2        ///< all of it
  };

  ///@{
  /**
   * The input without a pipeline. Any other way of vtkAlgorithm serves as well, with port 0.
   */
  void SetInputData(vtkPolyData* input);
  void SetInputData(vtkVoxelLineModel* input);
  ///@}

  ///@{
  /**
   * Radius of the tubes, in units of the data, 0 or above; the actor's matrix scales it with the
   * data. Default 0: 1/512 of the longest side of the lines' bounds, by which a tube is as wide as
   * a voxel of the default resolution. Without effect where there is an array of radii.
   *
   * A shared model may have radii of its own; see RadiusArrayName. A negative or not finite value
   * is an error.
   */
  virtual void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

  /**
   * Radius that is drawn, in units of the data. Of several radii the largest. Updates the model.
   */
  double GetRadiusInUse();

  ///@{
  /**
   * Name of a point array of the input with one radius per point, in units of the data. Default
   * empty: all tubes have the same radius. Only for vtkPolyData; see vtkLineVoxelizer.
   */
  virtual void SetRadiusArrayName(const std::string& name);
  vtkGetMacro(RadiusArrayName, std::string);
  ///@}

  ///@{
  /**
   * Number of voxels along the longest side of the lines' bounds, 1 to 4096. Default 256. More
   * voxels make thin tubes faster to draw, and take more time and memory to build.
   *
   * Only for vtkPolyData; see vtkLineVoxelizer. A value out of range is an error.
   */
  virtual void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Bins along the edge of a voxel face to which points are rounded: a power of two from 2 to 2048,
   * or 0 for exact points. Default 32. Up to 32 bins, a segment takes 4 bytes, above 8, and exact
   * ones 24.
   *
   * Only for vtkPolyData; see vtkLineVoxelizer. Another value is an error.
   */
  virtual void SetFaceBins(int bins);
  vtkGetMacro(FaceBins, int);
  ///@}

  ///@{
  /**
   * How far a line may deviate inside a voxel before its points there are kept, in voxels, 0 or
   * above. Default 0.1. With infinity no such point is kept.
   *
   * Only for vtkPolyData; see vtkLineVoxelizer. A negative value or NaN is an error.
   */
  virtual void SetInteriorTolerance(double tolerance);
  vtkGetMacro(InteriorTolerance, double);
  ///@}

  ///@{
  /**
   * Bounds in data coordinates (smallest x, largest x, ...), used when UseCustomBounds is on
   * instead of those of the lines: for the grid, see vtkLineVoxelizer, and for the automatic
   * radius. So several mappers cut their lines at the same places, as processes do of which each
   * draws a part of a line set. Default off, and 0 1 0 1 0 1. Only for vtkPolyData. Bounds that are
   * not finite or do not ascend are an error when the model is built.
   */
  vtkSetMacro(UseCustomBounds, bool);
  vtkGetMacro(UseCustomBounds, bool);
  vtkBooleanMacro(UseCustomBounds, bool);
  vtkSetVector6Macro(CustomBounds, double);
  vtkGetVector6Macro(CustomBounds, double);
  ///@}

  ///@{
  /**
   * Range of the scalars that colour the lines and largest radius of RadiusArrayName, used when
   * UseCustomRanges is on instead of those of the lines, since models store both in 8 bits of
   * these; see vtkLineVoxelizer. A range that does not ascend and a radius of 0 stand for those of
   * the lines. Default off, (1, 0) and 0. Only for vtkPolyData.
   */
  vtkSetMacro(UseCustomRanges, bool);
  vtkGetMacro(UseCustomRanges, bool);
  vtkBooleanMacro(UseCustomRanges, bool);
  vtkSetVector2Macro(CustomAttributeRange, double);
  vtkGetVector2Macro(CustomAttributeRange, double);
  vtkSetMacro(CustomMaximumRadius, double);
  vtkGetMacro(CustomMaximumRadius, double);
  ///@}

  /**
   * What the lines of a vtkPolyData have that CustomBounds, CustomAttributeRange and
   * CustomMaximumRadius replace, with the colours as they are set now and no regard to the custom
   * values. The union of what several mappers measure is what they have to share.
   */
  vtkLineVoxelizer::Measures MeasureLines(vtkPolyData* lines);

  ///@{
  /**
   * Part of the scene that is drawn, a box in world coordinates (smallest x, largest x, ...), for
   * processes that share a picture; infinite sides are open. What is first seen of a tube outside
   * is not drawn, and what is first seen inside is drawn whole: other than with clipping planes,
   * tubes are not cut open, and lines outside cast shadows and occlude as ever. So pictures of
   * boxes side by side, laid over each other in the order of the boxes, are that of the whole
   * scene, if each process has all lines of its box and around it, up to the radius and a voxel
   * more. With OpacityByPathLength it must have them up to five radii and three voxels, and the
   * light of tubes that a ray follows for longer may change at a side of the box. Default:
   * everything. NaN is an error.
   */
  virtual void SetRegion(const double region[6]);
  const double* GetRegion() const { return this->Region; }
  ///@}

  ///@{
  /**
   * Opacity at which a ray ends, 0 to 1. Default 0.99 (Kanzler et al., Sec. 4). 1: a ray ends only
   * behind an opaque line; 0: at its first line.
   *
   * A value out of range is an error.
   */
  virtual void SetEarlyTermination(double opacity);
  vtkGetMacro(EarlyTermination, double);
  ///@}

  ///@{
  /**
   * Opacity from which on the lines behind are not told apart, 0 to 1: the rest of a ray goes
   * through ever coarser densities of the lines, which is faster, and takes the colour of the lines
   * in front (opacity acceleration; Kanzler et al., Sec. 4.1.1). What is behind the lines shows
   * through by how much the lines leave of it on the mean. Default 1: never. Without effect on
   * opaque lines, and on rays that end before, see EarlyTermination.
   *
   * docs/design.md has times and errors. A value out of range is an error.
   */
  virtual void SetOpacityAcceleration(double opacity);
  vtkGetMacro(OpacityAcceleration, double);
  ///@}

  ///@{
  /**
   * Where rays are cast (EngineType). Default Automatic: on the processor where OpenGL is rendered
   * by software, else in a shader. Both give the same picture.
   *
   * Software is what GL_RENDERER names llvmpipe, softpipe, SWR, swrast, SwiftShader, Software
   * Rasterizer, GDI Generic or Microsoft Basic Render. Another value is an error.
   */
  virtual void SetEngine(int engine);
  vtkGetMacro(Engine, int);
  void SetEngineToAutomatic() { this->SetEngine(Automatic); }
  void SetEngineToNative() { this->SetEngine(Native); }
  void SetEngineToShader() { this->SetEngine(Shader); }
  ///@}

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
   * Shadows and ambient occlusion; may be shared by several mappers. Default: an object of the
   * mapper's own with the defaults of vtkLineGlobalIllumination, by which there are none; nullptr
   * brings such a one back.
   */
  virtual void SetGlobalIllumination(vtkLineGlobalIllumination* illumination);
  vtkLineGlobalIllumination* GetGlobalIllumination();
  ///@}

  ///@{
  /**
   * Actors that receive the shadows and the ambient occlusion of the lines, as GlobalIllumination
   * tells them (Kanzler et al., Secs. 4.1.2 and 4.1.3): those of vtkIlluminatedLineMapper and of
   * VTK's vtkPolyDataMapper by OpenGL, whatever they draw. This mapper itself needs no actor: its
   * input and its parameters tell which lines cast shadows. Where it was drawn, the lines have
   * the matrix and the opacity of the actor that drew it last, before its first frame those of an
   * actor of the same window that has this mapper; where there is none, the coordinates of the data
   * are taken for the world's, and the opacity is that of the receiving actor.
   *
   * Other mappers cannot follow rays through the tubes: hard shadows and those of a level are
   * replaced by soft ones, HemisphereTubes by HemisphereDensity, and a warning says so once. What
   * VTK draws without light, as lines without normals, gets the mean of all lights' shadows. An
   * actor whose vtkProperty switches lighting off receives nothing, nor does one that is drawn
   * by other kinds of mappers. Clipping planes of this mapper are not looked at: lines that are
   * clipped cast shadows on receivers.
   *
   * Code is added to the actor's vtkShaderProperty, beside what a user has put there, when the
   * actor is drawn. Two actors with the same vtkShaderProperty must both receive. An actor receives
   * from one mapper: adding it to a second one is an error, and so is nullptr. Neither the actor
   * nor this mapper is kept alive by it.
   */
  virtual void AddReceiver(vtkActor* actor);
  virtual void RemoveReceiver(vtkActor* actor);
  virtual void RemoveAllReceivers();
  int GetNumberOfReceivers();
  ///@}

  ///@{
  /**
   * Whether tubes that are thinner than a pixel are drawn one pixel wide with the opacity
   * multiplied by the part of that width which they cover, and lit by the average over their width
   * (Mallo, Peikert, Sigg and Sadlo, "Illuminated Lines Revisited", 2005, Sec. 2.2); between one
   * and two pixels the light changes over to that of a surface, which has the same average. So the
   * brightness of the picture stays the same as the camera moves away, and no line is lost between
   * pixels. Default on. Off: each pixel shows what lies at its centre, with the light of a surface.
   *
   * Selection finds such tubes one pixel wide. A tube of radius 0 is invisible in either case.
   *
   * A pixel's width is its larger side in the coordinates of the data: an actor scaled unevenly
   * widens some tubes to more than a pixel. A line that passes itself within the width of a pixel
   * at the same depth counts once there.
   *
   * Tubes are drawn with a radius of at most as many voxels as let a ray meet about 4096 segments,
   * if these were spread evenly, but at least 2: in views from so far that half a pixel is larger,
   * rays miss some lines, and those that they hit are less transparent by as much. The brightness
   * remains, with noise, and a warning says so once.
   */
  vtkSetMacro(SubPixelCoverage, bool);
  vtkGetMacro(SubPixelCoverage, bool);
  vtkBooleanMacro(SubPixelCoverage, bool);
  ///@}

  ///@{
  /**
   * Number of pictures whose mean is drawn while nothing changes, 1 to 4096. Default 1: every frame
   * shows one picture with one ray through the centre of each pixel. Above, each further frame that
   * would show the same casts one more picture, whose rays pass through other points of the pixels,
   * and shows the mean of all so far: edges of lines become smooth and details finer than a pixel
   * get their brightness. After so many pictures none is cast any more, and the mean is replayed.
   *
   * Any change begins anew with the picture that is drawn without accumulation: of camera, size,
   * lights, property, colours, model, clipping planes, engine, or of the depth of the opaque actors
   * that are drawn before. Selections change nothing. A mapper that is drawn by several actors or
   * in several renderers (or for both eyes) draws another picture each time, and so never
   * accumulates: give each a mapper of its own, which may share a model.
   *
   * The mean of opaque lines is drawn with the translucent actors, since lines are
   * translucent at their edges then; it writes no depth, so that volumes, which are drawn later,
   * cover it. An actor with ForceOpaque stays in the opaque pass, where edges hide opaque actors
   * that are drawn later behind them. Before each picture of a mean the depth of the scene is
   * read, by the shader engine the picture as well; 24 bytes per pixel, 32 with that engine, are
   * kept on the processor. Frames that change cost nothing more. A value out of range is an error.
   */
  virtual void SetAccumulationFrames(int frames);
  vtkGetMacro(AccumulationFrames, int);
  ///@}

  /**
   * Number of pictures whose mean was drawn last: 0 before the first frame, 1 where the last frame
   * showed a change, up to AccumulationFrames.
   *
   * An application that draws when it is idle can stop
   * when that is reached, or when the number does not rise from one frame to the next.
   */
  int GetNumberOfAccumulatedPictures();

  ///@{
  /**
   * Whether the opacity of a tube depends on how far a ray goes inside it (Kanzler et al., Sec.
   * 4.1.1): tubes fade towards their edges, and are denser where they are seen along their axis.
   * Opaque tubes stay opaque. Default off: each tube that a ray enters has the same opacity,
   * whatever its way inside.
   *
   * A tube's opacity a, that of the property times that of its colour, is then that of a ray
   * through its whole diameter 2r; a ray that is inside for a length l, in units of the data, is
   * covered by 1 - (1 - a)^(l / 2r). How far a ray goes in all tubes of a curve that overlap on its
   * way counts once.
   */
  vtkSetMacro(OpacityByPathLength, bool);
  vtkGetMacro(OpacityByPathLength, bool);
  vtkBooleanMacro(OpacityByPathLength, bool);
  ///@}

  ///@{
  /**
   * Speed or completeness (Kanzler et al., Sec. 4.1). Whole tubes or, faster, those parts of them
   * that lie in voxels which a ray passes: what reaches out of the voxels of its line is missing,
   * the more, the wider tubes are compared to voxels, and transparent tubes may be blended in the
   * wrong order there. Default AutomaticQuality: the faster one during interaction.
   *
   * Automatic means Interactive where the render window's DesiredUpdateRate is 1 per second or
   * above, as it is while vtkRenderWindowInteractor moves something, else Still, as in a window
   * without an interactor. Selection and rays to lights take whole tubes. Another value is an
   * error.
   */
  virtual void SetQuality(int quality);
  vtkGetMacro(Quality, int);
  void SetQualityToAutomatic() { this->SetQuality(AutomaticQuality); }
  void SetQualityToInteractive() { this->SetQuality(InteractiveQuality); }
  void SetQualityToStill() { this->SetQuality(StillQuality); }
  ///@}

  /// Quality of the last frame: InteractiveQuality or StillQuality; AutomaticQuality before it.
  vtkGetMacro(QualityInUse, int);

  /// Engine of the last frame: Native or Shader; Automatic before the first one.
  vtkGetMacro(EngineInUse, int);

  /**
   * The model that is drawn: the input or what was built of it; nullptr without input. It is
   * brought up to date first, unless Static is on.
   */
  vtkVoxelLineModel* GetModel();

  /// Seconds that the mapper spent on building its model the last time; 0 for a shared model.
  vtkGetMacro(ModelBuildTime, double);

  /**
   * Seconds spent on what shadows and ambient occlusion are looked up in (densities, occlusion of
   * voxels, the lines of a level), the last time that any of it had to be computed; 0 before.
   *
   * It is computed when a frame needs it and the model, its opacity or a parameter changed, but not
   * for camera or lights.
   */
  double GetLightBuildTime();

  /**
   * Number of pictures ray cast so far. In a frame there is one, however often a render pass draws
   * the mapper in it, and none where a mean of AccumulationFrames is replayed; pictures of
   * selections do not count.
   */
  vtkIdType GetNumberOfPictures();

  /// Bytes on the graphics device: the model, where a shader draws it, and pictures.
  vtkIdType GetGraphicsMemory();

  ///@{
  /**
   * Bounds of the tubes in data coordinates: those of the lines, grown by the largest radius. The
   * input is brought up to date first, unless Static is on.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  /**
   * Whether lookup table or direct colours let something through, or tubes are thinner than a pixel
   * as the cameras stand of those renderers that have drawn them, or the frame under way shows a
   * mean (AccumulationFrames); the property's opacity comes on top.
   */
  bool HasTranslucentPolygonalGeometry() override;

  /// Selection works as the class description tells.
  bool GetSupportsSelection() override { return true; }

  ///@{
  /**
   * Arrays of the input that hold the ids which a selection is to tell in place of the input's own:
   * a point array and a cell array of vtkIdTypeArray. nullptr or empty, the default: the input's
   * own ids. An array that is missing, of another type or not of one component counts for nothing.
   * Only for vtkPolyData, as for vtkOpenGLPolyDataMapper. The newest releases of VTK have these
   * functions in vtkPolyDataMapper.
   */
  vtkSetStringMacro(PointIdArrayName);
  vtkGetStringMacro(PointIdArrayName);
  vtkSetStringMacro(CellIdArrayName);
  vtkGetStringMacro(CellIdArrayName);
  ///@}

  ///@{
  /**
   * Array of the input's cells, a vtkUnsignedIntArray, that holds the composite index which a
   * selection is to tell; nullptr or empty, the default: 1. Else as CellIdArrayName.
   */
  vtkSetStringMacro(CompositeIdArrayName);
  vtkGetStringMacro(CompositeIdArrayName);
  ///@}

  ///@{
  /**
   * Array of the input's points, a vtkUnsignedIntArray, that holds the process which a selection is
   * to tell, for a selector whose UseProcessIdFromData is on: that of a line's first point. nullptr
   * or empty, the default: the selector's. Else as PointIdArrayName.
   */
  vtkSetStringMacro(ProcessIdArrayName);
  vtkGetStringMacro(ProcessIdArrayName);
  ///@}

  /// Modification time of the mapper, its lookup table, its illumination and global illumination.
  vtkMTimeType GetMTime() override;

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;

  /// Release what lies on the graphics device; may be called several times. The model is kept.
  void ReleaseGraphicsResources(vtkWindow* window) override;

  void ShallowCopy(vtkAbstractMapper* mapper) override;

protected:
  vtkVoxelLineMapper();
  ~vtkVoxelLineMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void ComputeBounds() override;

  double Radius = 0.0;
  std::string RadiusArrayName;
  int Resolution = 256;
  int FaceBins = 32;
  double InteriorTolerance = 0.1;
  bool UseCustomBounds = false;
  double CustomBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  bool UseCustomRanges = false;
  double CustomAttributeRange[2] = { 1.0, 0.0 };
  double CustomMaximumRadius = 0.0;
  static constexpr double Open = std::numeric_limits<double>::infinity();
  double Region[6] = { -Open, Open, -Open, Open, -Open, Open };
  double EarlyTermination = 0.99;
  double OpacityAcceleration = 1.0;
  int Engine = Automatic;
  int EngineInUse = Automatic;
  int Quality = AutomaticQuality;
  int QualityInUse = AutomaticQuality;
  bool SubPixelCoverage = true;
  int AccumulationFrames = 1;
  bool OpacityByPathLength = false;
  double ModelBuildTime = 0.0;
  char* PointIdArrayName = nullptr;
  char* CellIdArrayName = nullptr;
  char* CompositeIdArrayName = nullptr;
  char* ProcessIdArrayName = nullptr;

private:
  vtkVoxelLineMapper(const vtkVoxelLineMapper&) = delete;
  void operator=(const vtkVoxelLineMapper&) = delete;

  void WarnOnce(std::string& last, const std::string& warning);
  void ErrorOnce(const std::string& error);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
