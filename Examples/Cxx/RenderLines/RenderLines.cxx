// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the lines of a file as tubes or as lit lines, into a window or a picture.
 *
 *   RenderLines FILE [--radius R | --line-width W] [--opacity A] [--color-by ARRAY]
 *     [--importance ARRAY] [--shadows none|hard|level|soft]
 *     [--occlusion none|spherical|hemisphere] [--size WxH] [--output PNG]
 *
 * FILE is anything VTK reads by itself (.vtp, .vtk, ...). The radius is in data units, by default
 * 1/512 of the longest side of the data. With --line-width lines of so many pixels
 * take the place of tubes, without shadows and occlusion. With --importance lines of low values of
 * the array fade where they hide high ones. Without --output an interactive window opens.
 */

#include "vtkFourierOpacityMapper.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkVoxelLineMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGeometryFilter.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLGenericDataObjectReader.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
const char* const Usage = "usage: RenderLines FILE [--radius R | --line-width W] [--opacity A] "
                          "[--color-by ARRAY] [--importance ARRAY] "
                          "[--shadows none|hard|level|soft] "
                          "[--occlusion none|spherical|hemisphere] [--size WxH] [--output PNG]\n";

struct Options
{
  std::string File;
  double Radius = 0.0;    // the mapper's default
  double LineWidth = 0.0; // 0: tubes
  double Opacity = 1.0;
  std::string ColorBy;
  std::string Importance;
  int Shadows = vtkLineGlobalIllumination::NoShadows;
  int Occlusion = vtkLineGlobalIllumination::NoOcclusion;
  int Size[2] = { 1024, 768 };
  std::string Output;
};

double ParseNumber(const std::string& option, const std::string& text)
{
  std::size_t end = 0;
  double number = 0.0;
  try
  {
    number = std::stod(text, &end);
  }
  catch (const std::exception&)
  {
    end = 0;
  }
  if (end == 0 || end != text.size())
  {
    throw std::runtime_error(option + " takes a number, not \"" + text + "\"");
  }
  return number;
}

// The place of a name among the names of values from 0 on.
int ParseName(
  const std::string& option, const std::string& text, const std::vector<std::string>& names)
{
  const auto name = std::find(names.begin(), names.end(), text);
  if (name == names.end())
  {
    std::string all;
    for (const std::string& known : names)
    {
      all += " " + known;
    }
    throw std::runtime_error(option + " takes one of" + all);
  }
  return static_cast<int>(name - names.begin());
}

Options ParseOptions(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind("--", 0) != 0)
    {
      if (!options.File.empty())
      {
        throw std::runtime_error("one file at a time, please: " + argument);
      }
      options.File = argument;
      continue;
    }
    if (i + 1 == argc)
    {
      throw std::runtime_error(argument + " takes a value");
    }
    const std::string value = argv[++i];
    char rest = 0;
    if (argument == "--radius")
    {
      options.Radius = ParseNumber(argument, value);
    }
    else if (argument == "--line-width")
    {
      options.LineWidth = ParseNumber(argument, value);
      if (!(options.LineWidth > 0.0))
      {
        throw std::runtime_error("--line-width takes a number of pixels above 0");
      }
    }
    else if (argument == "--opacity")
    {
      options.Opacity = ParseNumber(argument, value);
    }
    else if (argument == "--color-by")
    {
      options.ColorBy = value;
    }
    else if (argument == "--importance")
    {
      options.Importance = value;
    }
    else if (argument == "--shadows")
    {
      options.Shadows = ParseName(argument, value, { "none", "hard", "level", "soft" });
    }
    else if (argument == "--occlusion")
    {
      options.Occlusion = ParseName(argument, value, { "none", "spherical", "hemisphere" });
    }
    else if (argument == "--output")
    {
      options.Output = value;
    }
    else if (argument != "--size")
    {
      throw std::runtime_error("unknown option " + argument);
    }
    else if (std::sscanf(value.c_str(), "%dx%d%c", options.Size, options.Size + 1, &rest) != 2 ||
      options.Size[0] < 1 || options.Size[1] < 1)
    {
      throw std::runtime_error("--size takes a width and a height such as 1024x768");
    }
  }
  if (options.File.empty())
  {
    throw std::runtime_error("no file was named");
  }
  if (!options.Importance.empty() && options.LineWidth == 0.0)
  {
    options.LineWidth = 1.0;
  }
  if (options.LineWidth > 0.0 && (options.Shadows != 0 || options.Occlusion != 0))
  {
    throw std::runtime_error("--shadows and --occlusion are for tubes, not for --line-width "
                             "or --importance");
  }
  return options;
}

template <typename ReaderT>
vtkSmartPointer<vtkDataObject> Read(const std::string& file)
{
  vtkNew<ReaderT> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkPolyData> ReadLines(const std::string& file)
{
  const bool legacy = file.size() > 4 && file.compare(file.size() - 4, 4, ".vtk") == 0;
  vtkSmartPointer<vtkDataObject> data =
    legacy ? Read<vtkGenericDataObjectReader>(file) : Read<vtkXMLGenericDataObjectReader>(file);
  vtkSmartPointer<vtkPolyData> lines = vtkPolyData::SafeDownCast(data);
  if (!lines && vtkDataSet::SafeDownCast(data))
  {
    vtkNew<vtkGeometryFilter> toPolyData;
    toPolyData->SetInputData(data);
    toPolyData->Update();
    lines = toPolyData->GetOutput();
  }
  if (!lines)
  {
    throw std::runtime_error(file + " holds no data set that VTK can read");
  }
  if (lines->GetNumberOfLines() == 0)
  {
    throw std::runtime_error(file + " holds no lines");
  }
  return lines;
}

vtkDataArray* FindArray(const std::string& name, vtkPolyData* lines)
{
  std::string names;
  for (vtkFieldData* fields : { static_cast<vtkFieldData*>(lines->GetPointData()),
         static_cast<vtkFieldData*>(lines->GetCellData()) })
  {
    if (vtkDataArray* array = fields->GetArray(name.c_str()))
    {
      return array;
    }
    for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    {
      names += std::string(" ") + (fields->GetArrayName(i) ? fields->GetArrayName(i) : "");
    }
  }
  throw std::runtime_error(
    "there is no array \"" + name + "\", but" + (names.empty() ? " none" : names));
}

void ColorBy(const std::string& name, vtkPolyData* lines, vtkMapper* mapper)
{
  vtkDataArray* array = FindArray(name, lines);
  if (lines->GetPointData()->GetArray(name.c_str()))
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  else
  {
    mapper->SetScalarModeToUseCellFieldData();
  }

  // From blue over pale yellow to red. Vectors are coloured by magnitude; NaN does not count for
  // the range.
  double range[2];
  array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
  vtkNew<vtkColorTransferFunction> table;
  const double colors[5][3] = { { 0.17, 0.32, 0.66 }, { 0.35, 0.66, 0.83 }, { 0.95, 0.92, 0.75 },
    { 0.96, 0.62, 0.32 }, { 0.80, 0.15, 0.15 } };
  for (int i = 0; i < 5; ++i)
  {
    table->AddRGBPoint(
      range[0] + 0.25 * i * (range[1] - range[0]), colors[i][0], colors[i][1], colors[i][2]);
  }
  table->SetNanColor(0.5, 0.5, 0.5);
  if (array->GetNumberOfComponents() > 1)
  {
    table->SetVectorModeToMagnitude();
  }
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SelectColorArray(name.c_str());
  mapper->ScalarVisibilityOn();
}

// Lights for shadows. The headlight that VTK makes by itself casts none that are seen: what lies
// in its shadow lies behind what casts it, for the camera as well. So a light is put into the
// scene, to the upper right of the first view, where it stays while the camera moves. A weak
// headlight keeps what is in the shadow from being black.
void AddLights(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  // In coordinates in which the camera looks from (0, 0, 1) to the origin.
  const double upperRight[4] = { 1.0, 1.0, 1.0, 1.0 };
  double position[4];
  camera->GetCameraLightTransformMatrix()->MultiplyPoint(upperRight, position);
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(position[0], position[1], position[2]);
  sun->SetFocalPoint(camera->GetFocalPoint());
  sun->SetIntensity(0.8);
  renderer->AddLight(sun);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.4);
  renderer->AddLight(fill);
}

void Write(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("could not write " + file);
  }
  std::cout << file << "\n";
}

void Render(const Options& options)
{
  vtkSmartPointer<vtkPolyData> lines = ReadLines(options.File);
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (!options.Importance.empty())
  {
    FindArray(options.Importance, lines);
    auto fading = vtkSmartPointer<vtkFourierOpacityMapper>::New();
    fading->SetImportanceArrayName(options.Importance);
    mapper = fading;
  }
  else if (options.LineWidth > 0.0)
  {
    mapper = vtkSmartPointer<vtkIlluminatedLineMapper>::New();
  }
  else
  {
    auto tubes = vtkSmartPointer<vtkVoxelLineMapper>::New();
    tubes->SetRadius(options.Radius);
    tubes->GetGlobalIllumination()->SetShadows(options.Shadows);
    tubes->GetGlobalIllumination()->SetOcclusion(options.Occlusion);
    mapper = tubes;
  }
  mapper->SetInputDataObject(lines);
  mapper->ScalarVisibilityOff();
  if (!options.ColorBy.empty())
  {
    ColorBy(options.ColorBy, lines, mapper);
  }

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(options.Opacity);
  actor->GetProperty()->SetLineWidth(
    options.LineWidth > 0.0 ? static_cast<float>(options.LineWidth) : 1.0f);
  actor->GetProperty()->SetColor(0.2, 0.45, 0.7);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(30.0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  window->SetWindowName("RenderLines");
  // Tubes are ray cast, which samples make no smoother.
  window->SetMultiSamples(options.LineWidth > 0.0 ? 8 : 0);
  window->AddRenderer(renderer);
  window->SetOffScreenRendering(!options.Output.empty());
  window->SetSize(options.Size[0], options.Size[1]);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->GetActiveCamera()->SetPosition(0.0, -1.0, 0.3);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->ResetCameraScreenSpace();
  if (options.Shadows != vtkLineGlobalIllumination::NoShadows)
  {
    AddLights(renderer);
  }

  if (!options.Output.empty())
  {
    window->Render();
    Write(window, options.Output);
    return;
  }
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(window);
  window->Render();
  interactor->Start();
}
}

int main(int argc, char* argv[])
{
  try
  {
    Render(ParseOptions(argc, argv));
  }
  catch (const std::exception& error)
  {
    std::cerr << "RenderLines: " << error.what() << "\n" << Usage;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
