// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of vtkVoxelLineMapper share: lines, a window with one renderer, pictures to
 * compare, and a listener for errors and warnings.
 */

#ifndef VoxelLineMapperTesting_h
#define VoxelLineMapperTesting_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace VoxelLineMapperTesting
{
using Point = std::array<double, 3>;
using Curve = std::vector<Point>;

/// Counts failed checks; the test returns EXIT_FAILURE if there is one.
class Checks
{
public:
  bool operator()(bool isRight, const std::string& what)
  {
    if (!isRight)
    {
      std::cerr << "FAILED: " << what << std::endl;
      ++this->Failures;
    }
    return isRight;
  }
  int GetResult() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

/// Catches errors and warnings of all objects while it lives, and keeps their texts.
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Texts.emplace_back(text); }
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char* text) override { this->Warnings.emplace_back(text); }
  void DisplayGenericWarningText(const char* text) override { this->Warnings.emplace_back(text); }

  /// Number of errors and warnings since the last call, if all of them hold the text; else -1.
  int TakeErrors(const std::string& part) { return Take(this->Errors, part); }
  int TakeWarnings(const std::string& part) { return Take(this->Warnings, part); }
  /// Whether nothing was said since the last call; what was said is printed.
  bool IsQuiet()
  {
    bool quiet = true;
    for (auto* texts : { &this->Errors, &this->Warnings, &this->Texts })
    {
      for (const std::string& text : *texts)
      {
        std::cerr << "said: " << text << std::endl;
        quiet = false;
      }
      texts->clear();
    }
    return quiet;
  }

private:
  static int Take(std::vector<std::string>& texts, const std::string& part)
  {
    int count = static_cast<int>(texts.size());
    for (const std::string& text : texts)
    {
      if (text.find(part) == std::string::npos)
      {
        std::cerr << "said without \"" << part << "\": " << text << std::endl;
        count = -1;
      }
    }
    texts.clear();
    return count;
  }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> Texts;
};
inline vtkStandardNewMacro(Messages);

/// Listens for the rest of the test.
inline vtkSmartPointer<Messages> Listen()
{
  auto messages = vtkSmartPointer<Messages>::New();
  vtkOutputWindow::SetInstance(messages);
  // Else the log repeats what is said, and an error that a test expects would fail it.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  return messages;
}

/// Polylines of the given curves.
inline vtkSmartPointer<vtkPolyData> MakeLines(const std::vector<Curve>& curves)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Curve& curve : curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (const Point& point : curve)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/**
 * Helices about the z axis, of radius 0.4 to 1 and height -1 to 1, with the point array "t" from 0
 * at the start to 1 at the end of each, as active scalars.
 */
inline vtkSmartPointer<vtkPolyData> MakeHelices(int numberOfCurves = 5, int numberOfPoints = 200)
{
  std::vector<Curve> curves(static_cast<std::size_t>(numberOfCurves));
  vtkNew<vtkDoubleArray> t;
  t->SetName("t");
  for (int i = 0; i < numberOfCurves; ++i)
  {
    const double radius = 0.4 + 0.6 * i / std::max(numberOfCurves - 1, 1);
    for (int k = 0; k < numberOfPoints; ++k)
    {
      const double s = static_cast<double>(k) / (numberOfPoints - 1);
      const double angle = 2.0 * i + 20.0 * s;
      curves[i].push_back({ radius * std::cos(angle), radius * std::sin(angle), 2.0 * s - 1.0 });
      t->InsertNextValue(s);
    }
  }
  auto data = MakeLines(curves);
  data->GetPointData()->SetScalars(t);
  return data;
}

/// A picture of a window: three bytes per pixel, row by row from the bottom.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  std::array<int, 3> At(int x, int y) const
  {
    const unsigned char* pixel =
      this->Bytes.data() + 3 * (static_cast<std::size_t>(y) * this->Width + x);
    return { pixel[0], pixel[1], pixel[2] };
  }
};

/// RMS difference to a picture that is so many times as large, averaged over its pixels.
inline double GetError(const Picture& picture, const Picture& large)
{
  const int scale = large.Width / picture.Width;
  double sum = 0.0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      double mean[3] = { 0.0, 0.0, 0.0 };
      for (int i = 0; i < scale * scale; ++i)
      {
        const auto sample = large.At(scale * x + i % scale, scale * y + i / scale);
        for (int c = 0; c < 3; ++c)
        {
          mean[c] += sample[c] / static_cast<double>(scale * scale);
        }
      }
      const auto pixel = picture.At(x, y);
      for (int c = 0; c < 3; ++c)
      {
        sum += (pixel[c] - mean[c]) * (pixel[c] - mean[c]);
      }
    }
  }
  return std::sqrt(sum / (3.0 * picture.Width * picture.Height));
}

inline Picture Grab(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetSize()[0];
  picture.Height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetPixelData(0, 0, picture.Width - 1, picture.Height - 1, 0, bytes);
  picture.Bytes.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  return picture;
}

/// How two pictures differ, in units of a byte.
struct Difference
{
  double Rms = 1e9;
  int Largest = 1000;
  /// Part of the pixels in which some component differs by more than 2.
  double Part = 1.0;
};

inline Difference Compare(const Picture& a, const Picture& b)
{
  Difference difference;
  if (a.Width != b.Width || a.Height != b.Height || a.Bytes.empty())
  {
    return difference;
  }
  double sum = 0.0;
  std::size_t pixels = 0;
  difference.Largest = 0;
  for (std::size_t i = 0; i < a.Bytes.size(); i += 3)
  {
    int largest = 0;
    for (std::size_t k = i; k < i + 3; ++k)
    {
      const int d = std::abs(static_cast<int>(a.Bytes[k]) - static_cast<int>(b.Bytes[k]));
      sum += static_cast<double>(d) * d;
      largest = std::max(largest, d);
    }
    pixels += largest > 2 ? 1 : 0;
    difference.Largest = std::max(difference.Largest, largest);
  }
  difference.Rms = std::sqrt(sum / static_cast<double>(a.Bytes.size()));
  difference.Part = 3.0 * static_cast<double>(pixels) / static_cast<double>(a.Bytes.size());
  return difference;
}

inline std::string Describe(const Difference& difference)
{
  std::ostringstream text;
  text << " (rms " << difference.Rms << ", largest " << difference.Largest << ", part "
       << difference.Part << ")";
  return text.str();
}

/// Part of the pixels that are not of the given colour.
inline double GetCoverage(const Picture& picture, const std::array<int, 3>& background)
{
  std::size_t covered = 0;
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      covered += picture.At(x, y) != background ? 1 : 0;
    }
  }
  return static_cast<double>(covered) / (static_cast<double>(picture.Width) * picture.Height);
}

inline bool IsNear(const std::array<int, 3>& a, const std::array<int, 3>& b, int tolerance)
{
  return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
    std::abs(a[2] - b[2]) <= tolerance;
}

inline std::string Describe(const std::array<int, 3>& color)
{
  std::ostringstream text;
  text << " (" << color[0] << " " << color[1] << " " << color[2] << ")";
  return text.str();
}

/// An off-screen window with one renderer and a dark blue background.
struct Stage
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  explicit Stage(int width = 200, int height = 160)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(26.0 / 255.0, 0.2, 0.4);
  }

  Picture Render()
  {
    this->Window->Render();
    return Grab(this->Window);
  }

  vtkSmartPointer<vtkActor> Add(vtkMapper* mapper, double opacity = 1.0)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkSmartPointer<vtkActor> AddSphere(
    double x, double y, double z, double radius, double opacity = 1.0)
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(x, y, z);
    source->SetRadius(radius);
    source->SetThetaResolution(32);
    source->SetPhiResolution(32);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    return this->Add(mapper, opacity);
  }
};

constexpr std::array<int, 3> Background{ 26, 51, 102 };

/// Keeps a window open: a virtual X server may start anew when its last client leaves, and then
/// turn the next one away.
class KeptDisplay
{
public:
  KeptDisplay()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(8, 8);
    this->Window->Render();
  }

private:
  vtkNew<vtkRenderWindow> Window;
};

/// A parallel view along z of what lies between -1 and 1.
inline void LookAlongZ(Stage& stage)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetClippingRange(1.0, 20.0);
}
}

#endif
