// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ways of drawing that linesets-bench compares. Each has a renderer of its own in the common
 * window, with the common camera; only the one whose turn it is draws.
 */

#ifndef BenchmarkMethod_h
#define BenchmarkMethod_h

#include "BenchmarkOptions.h"

#include "vtkNew.h"          // For members
#include "vtkSmartPointer.h" // For members

#include <chrono> // For times
#include <limits> // For what is not known
#include <memory> // For the factory
#include <string> // For names
#include <vector> // For times

class vtkActor;
class vtkCamera;
class vtkFloatArray;
class vtkLight;
class vtkLookupTable;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkVoxelLineModel;

namespace linesets
{
class JsonObject;

/// What all methods draw.
struct BenchmarkInput
{
  BenchmarkOptions Options;
  /// The lines of the current frame; or vertex cells, polygons or both, where there are no lines.
  vtkSmartPointer<vtkPolyData> Geometry;
  /// The scene at rest with all its arrays.
  vtkSmartPointer<vtkPolyData> Scene;
  /// What GetImportance made.
  vtkSmartPointer<vtkFloatArray> Importance;
  /// Bounds of the geometry at rest, in units of the data.
  double Bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  /// Distance of the camera, where that from which a sphere about the bounds fills the picture
  /// is 1.
  double Closeness = 0.85;
  vtkSmartPointer<vtkCamera> Camera;
  /// Empty where the headlight that VTK makes is the light.
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  /// Null where the geometry has no colours of their own.
  vtkSmartPointer<vtkLookupTable> Table;
  /// From blue for 0 to red for 1.
  vtkSmartPointer<vtkLookupTable> ImportanceTable;
  double Radius = 0.0;
  double PixelRadius = 0.0; ///< the radius at the focal point, in pixels
  /// Tubes at rest, made by the first method that needs them, and the time that took.
  vtkSmartPointer<vtkPolyData> Tubes;
  double TubeMilliseconds = 0.0;
  /// The same of the geometry with the segments of opacity optimization.
  vtkSmartPointer<vtkPolyData> Segments;
  double SegmentMilliseconds = 0.0;
};

class BenchmarkMethod
{
public:
  BenchmarkMethod();
  virtual ~BenchmarkMethod();

  /// Build what is drawn, before the first frame. Fills BuildMilliseconds.
  virtual void Prepare(BenchmarkInput& input) = 0;

  /// Give new geometry to the pipeline and bring it up to date. Returns the milliseconds in which
  /// it made something else of them, NaN where they are drawn as they are.
  virtual double Update(BenchmarkInput& input) = 0;

  /// Forget the frames before, where they change the next one.
  virtual void PrepareForPicture() {}

  /// Add the keys that only this method has; after the last frame.
  virtual void Describe(JsonObject& object) = 0;

  /// The model that is drawn, or nullptr.
  virtual vtkVoxelLineModel* GetModel() { return nullptr; }

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkActor* GetActor() { return this->Actor; }

  std::string Name;
  std::string Engine;   ///< the one asked for, or empty where there is no choice
  std::string FileName; ///< name that tells engines apart
  std::string Error;    ///< why it failed, or empty
  double BuildMilliseconds = 0.0;
  /// Mean number of fragments of a pixel that has any; NaN where it is not known.
  double DepthComplexity = std::numeric_limits<double>::quiet_NaN();
  double FirstFrameMilliseconds = 0.0;
  std::vector<double> FrameMilliseconds;
  std::vector<double> ProcessorMilliseconds; ///< of all threads, per frame
  /// What Update took, per frame, and the rest of the frame; empty where nothing moves or it
  /// cannot be told.
  std::vector<double> RebuildMilliseconds;
  std::vector<double> DrawMilliseconds;

protected:
  /// Set up the actor with a mapper.
  void SetMapper(vtkPolyDataMapper* mapper, const BenchmarkInput& input);

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
};

/// The importance of the points of all frames, from 0 to 1, for opacity optimization; made for the
/// first method that needs it. The geometry has no such array, so that other methods do not carry
/// it along. Throws std::runtime_error where there is none.
vtkFloatArray* GetImportance(BenchmarkInput& input);

/// Names of all methods.
std::vector<std::string> GetMethodNames();

/// Whether a method is drawn by vtkVoxelLineMapper, which has engines.
bool IsVoxelMethod(const std::string& name);

/// Whether a method is drawn by vtkFourierOpacityMapper.
bool IsOpacityMethod(const std::string& name);

/// Whether a method draws lines and nothing else.
bool DrawsLinesOnly(const std::string& name);

/// Whether a method has shadows, for which a headlight does not do.
bool HasShadows(const std::string& name);

/// Whether a method has the occlusion of voxels that can be held against brute force.
bool HasSphericalOcclusion(const std::string& name);

/// Whether a method has shadows or ambient occlusion, which the exact pictures do not have.
bool HasGlobalIllumination(const std::string& name);

/// Make a method; `engine` is automatic, native or shader and counts for voxel methods only.
std::unique_ptr<BenchmarkMethod> MakeMethod(const std::string& name, const std::string& engine);

/// Wall clock time in milliseconds.
double GetMilliseconds(std::chrono::steady_clock::time_point since);

/// Median, the mean of the middle two for an even number; NaN for no values.
double GetMedian(std::vector<double> values);

/// Segments of all lines.
long long CountLineSegments(vtkPolyData* lines);
}

#endif
