// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ways of drawing that linesets-bench compares. Each has a renderer of its own in the common
 * window, with the common camera; only the one whose turn it is draws.
 */

#ifndef BenchmarkMethod_h
#define BenchmarkMethod_h

#include "vtkNew.h"          // For members
#include "vtkSmartPointer.h" // For members

#include <memory> // For the factory
#include <string> // For names
#include <vector> // For times

class vtkActor;
class vtkCamera;
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
  vtkSmartPointer<vtkPolyData> Lines;
  vtkSmartPointer<vtkCamera> Camera;
  /// Null where the lines have no colours of their own.
  vtkSmartPointer<vtkLookupTable> Table;
  double Radius = 0.0;
  double PixelRadius = 0.0; ///< the radius at the focal point, in pixels
  double Opacity = 1.0;
  int Resolution = 256;
  int FaceBins = 32;
  int Peels = 0; ///< 0: no limit
  double LineWidth = 1.0; ///< of lines, in pixels
  bool Stretch = false;   ///< the dynamic range of illuminated lines
  bool LightFromRight = false;
  bool Plain = false; ///< one colour on a dark background
  /// Tubes, made by the first method that needs them, and the time that took.
  vtkSmartPointer<vtkPolyData> Tubes;
  double TubeMilliseconds = 0.0;
};

class BenchmarkMethod
{
public:
  BenchmarkMethod();
  virtual ~BenchmarkMethod();

  /// Build what is drawn, before the first frame. Fills BuildMilliseconds.
  virtual void Prepare(BenchmarkInput& input) = 0;

  /// Add the keys that only this method has; after the last frame.
  virtual void Describe(JsonObject& object) = 0;

  /// The model that is drawn, or nullptr.
  virtual vtkVoxelLineModel* GetModel() { return nullptr; }

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkActor* GetActor() { return this->Actor; }

  std::string Name;
  std::string FileName; ///< name that tells engines apart
  std::string Error;    ///< why it failed, or empty
  double BuildMilliseconds = 0.0;
  double FirstFrameMilliseconds = 0.0;
  std::vector<double> FrameMilliseconds;
  std::vector<double> ProcessorMilliseconds; ///< of all threads, per frame

protected:
  /// Set up the actor with a mapper.
  void SetMapper(vtkPolyDataMapper* mapper, const BenchmarkInput& input);

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
};

/// Names of all methods.
std::vector<std::string> GetMethodNames();

/// Make a method; `engine` is automatic, native or shader and counts for voxel only.
std::unique_ptr<BenchmarkMethod> MakeMethod(const std::string& name, const std::string& engine);
}

#endif
