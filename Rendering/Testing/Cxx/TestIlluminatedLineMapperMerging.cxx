// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards MergeLength of vtkIlluminatedLineMapper: that fewer segments give the same picture, that
 * light computed for each point looks like light computed for each pixel, and that neither happens
 * where segments count one by one or can be told apart.
 */

#include "VoxelLineMapperTesting.h"
#include "vtkHardwareSelector.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTextureUnitManager.h"

#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
vtkSmartPointer<vtkActor> AddHelices(Stage& stage, vtkIlluminatedLineMapper* mapper)
{
  mapper->SetInputData(MakeHelices(12, 4000));
  auto actor = stage.Add(mapper);
  actor->GetProperty()->SetSpecular(0.6);
  actor->GetProperty()->SetSpecularPower(40.0);
  actor->GetProperty()->SetLineWidth(2.0f);
  stage.Renderer->GetActiveCamera()->SetPosition(4.0, 3.0, 3.5);
  stage.Renderer->ResetCamera();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, 1.0, 2.0);
  stage.Renderer->AddLight(light);
  return actor;
}

double GetMean(const Picture& picture)
{
  double sum = 0.0;
  for (unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum / static_cast<double>(picture.Bytes.size());
}

void CheckPictures(Checks& check)
{
  Stage stage(300, 240);
  vtkNew<vtkIlluminatedLineMapper> mapper;
  auto actor = AddHelices(stage, mapper);
  check(mapper->GetNumberOfDrawnSegments() == 0, "no segments before the first frame");
  mapper->SetMergeLength(0.0);
  const Picture whole = stage.Render();
  const vtkIdType all = mapper->GetNumberOfDrawnSegments();
  check(all == 12 * 3999, "length 0 draws every segment");
  check(GetCoverage(whole, Background) > 0.05, "something is drawn");

  mapper->SetMergeLength(3.0);
  const Picture merged = stage.Render();
  const vtkIdType fewer = mapper->GetNumberOfDrawnSegments();
  const Difference difference = Compare(whole, merged);
  std::cout << fewer << " of " << all << " segments" << Describe(difference) << "\n";
  check(fewer > 0 && fewer < all / 4, "segments are merged");
  // A line that moves by a part of a pixel covers another pixel here and there.
  check(difference.Rms < 6.0 && difference.Part < 0.02,
    "merged lines look like whole ones" + Describe(difference));
  check(std::abs(GetMean(whole) - GetMean(merged)) < 0.002 * GetMean(whole),
    "merged lines are as bright as whole ones");
  check(difference.Part > 0.0, "merging was compared with something else");

  // The same segments one by one, lit for each point as all are shorter than a pixel.
  mapper->SetInputData(MakeHelices(12, 500));
  mapper->SetMergeLength(0.0);
  const Picture byPixel = stage.Render();
  mapper->SetMergeLength(2.0);
  const Picture byPoint = stage.Render();
  std::cout << mapper->GetNumberOfDrawnSegments() << " of " << 12 * 499 << " segments"
            << Describe(Compare(byPixel, byPoint)) << "\n";
  check(Compare(byPixel, byPoint).Rms < 6.0,
    "light for each point looks like light for each pixel" + Describe(Compare(byPixel, byPoint)));

  // Near by, nothing may be merged.
  stage.Renderer->GetActiveCamera()->SetClippingRange(0.01, 100.0);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Renderer->GetActiveCamera()->SetPosition(0.2, 0.1, 0.3);
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() == 12 * 499, "nothing is merged around the camera");
}

void CheckExceptions(Checks& check)
{
  Stage stage(200, 160);
  vtkNew<vtkIlluminatedLineMapper> mapper;
  auto actor = AddHelices(stage, mapper);
  stage.Render();
  const vtkIdType fewer = mapper->GetNumberOfDrawnSegments();
  check(fewer < 12 * 3999 / 4, "segments are merged");

  // Colours of cells belong to the segments by their number.
  vtkNew<vtkPolyData> colored;
  colored->ShallowCopy(mapper->GetInput());
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  for (int i = 0; i < 12; ++i)
  {
    cells->InsertNextValue(i / 11.0);
  }
  colored->GetCellData()->SetScalars(cells);
  mapper->SetInputData(colored);
  mapper->SetScalarModeToUseCellData();
  mapper->SetMergeLength(0.0);
  const Picture right = stage.Render();
  mapper->SetMergeLength(3.0);
  const Picture same = stage.Render();
  check(mapper->GetNumberOfDrawnSegments() == 12 * 3999, "lines with colours of cells stay whole");
  check(Compare(right, same).Largest <= 40 && Compare(right, same).Rms < 1.0,
    "colours of cells" + Describe(Compare(right, same)));
  mapper->SetScalarModeToUsePointData();
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() == fewer, "segments are merged again");

  // The selection knows every cell.
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(0, 0, 199, 159);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  check(selection->GetNumberOfNodes() == 1 &&
      selection->GetNode(0)->GetSelectionList()->GetNumberOfTuples() == 12,
    "all lines are selected");
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() == fewer, "segments are merged after a selection");

  // Points as such are all drawn; other data is merged anew.
  actor->GetProperty()->SetRepresentationToPoints();
  stage.Render();
  actor->GetProperty()->SetRepresentationToSurface();
  mapper->SetInputData(MakeHelices(3, 4000));
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() < fewer, "other lines");
  mapper->ReleaseGraphicsResources(stage.Window);
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() > 0, "lines after a release");
}

/// A mapper that ends while another window's context is the current one deletes nothing there.
void CheckOtherWindow(Checks& check)
{
  Stage stage(200, 160);
  auto mapper = vtkSmartPointer<vtkIlluminatedLineMapper>::New();
  auto actor = AddHelices(stage, mapper);
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() < 12 * 3999 / 4, "segments are merged");
  // So many buffers that some have the same names as those of the lines.
  Stage other(200, 160);
  for (int i = 0; i < 20; ++i)
  {
    other.AddSphere(0.3 * (i % 5), 0.3 * (i / 5), 0.0, 0.1);
  }
  other.Renderer->ResetCamera();
  const Picture before = other.Render();
  stage.Renderer->RemoveAllViewProps();
  actor = nullptr;
  mapper = nullptr;
  check(GetCoverage(before, Background) > 0.05, "something is in the other window");
  check(Compare(before, other.Render()).Largest == 0, "another window keeps its buffers");
}

/// Points that move are merged anew.
void CheckMovedPoints(Checks& check)
{
  Stage stage(200, 160);
  vtkNew<vtkIlluminatedLineMapper> mapper;
  auto actor = AddHelices(stage, mapper);
  stage.Render();
  const vtkIdType fewer = mapper->GetNumberOfDrawnSegments();
  vtkPolyData* lines = mapper->GetInput();
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double point[3];
    lines->GetPoint(i, point);
    point[0] += i % 2 ? 0.2 : -0.2;
    lines->GetPoints()->SetPoint(i, point);
  }
  lines->GetPoints()->Modified();
  lines->Modified();
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() > 2 * fewer, "zigzags are not merged");
  actor->GetProperty()->SetRepresentationToPoints();
  stage.Render();
  check(mapper->GetNumberOfDrawnSegments() == 0, "points are no segments");
}

/// Texture units are given back after every frame.
void CheckTextureUnits(Checks& check)
{
  Stage stage(60, 60);
  vtkNew<vtkIlluminatedLineMapper> mapper;
  auto actor = AddHelices(stage, mapper);
  stage.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
  vtkTextureUnitManager* units = window->GetState()->GetTextureUnitManager();
  int used = 0;
  for (int i = 0; i < units->GetNumberOfTextureUnits(); ++i)
  {
    used += units->IsAllocated(i) ? 1 : 0;
  }
  check(used == 0, std::to_string(used) + " texture units are not given back");
}

/// What is wholly transparent hides nothing, even in an actor that has to pass for opaque.
void CheckTransparentPoints(Checks& check)
{
  Stage stage(100, 100);
  auto lines = MakeLines({ { { -0.8, 0.0, 0.5 }, { 0.8, 0.0, 0.5 } } });
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  colors->InsertNextTuple4(255, 0, 0, 0);
  colors->InsertNextTuple4(255, 0, 0, 0);
  lines->GetPointData()->SetScalars(colors);
  vtkNew<vtkIlluminatedLineMapper> mapper;
  mapper->SetInputData(lines);
  auto actor = stage.Add(mapper);
  actor->ForceOpaqueOn();
  actor->GetProperty()->SetLineWidth(20.0f);
  auto sphere = stage.AddSphere(0.0, 0.0, -2.0, 0.9);
  sphere->GetProperty()->SetColor(0.0, 1.0, 0.0);
  LookAlongZ(stage);
  const auto color = stage.Render().At(50, 50);
  check(color[0] < 10 && color[1] > 200, "a sphere behind invisible lines" + Describe(color));
}

void CheckBadValues(Checks& check)
{
  const auto messages = Listen();
  {
    Stage stage(60, 60);
    vtkNew<vtkIlluminatedLineMapper> bad;
    auto actor = AddHelices(stage, bad);
    actor->GetProperty()->SetSpecularPower(std::numeric_limits<double>::quiet_NaN());
    const Picture picture = stage.Render();
    stage.Render();
    check(messages->TakeWarnings("SpecularPower") == 1, "an exponent that is NaN is told once");
    actor->GetProperty()->SetSpecularPower(1.0);
    check(Compare(picture, stage.Render()).Largest == 0, "an exponent that is NaN is taken for 1");
  }
  vtkNew<vtkIlluminatedLineMapper> mapper;
  const double right = mapper->GetMergeLength();
  mapper->SetMergeLength(-1.0);
  mapper->SetMergeLength(std::numeric_limits<double>::quiet_NaN());
  mapper->SetMergeLength(std::numeric_limits<double>::infinity());
  check(messages->TakeErrors("MergeLength") == 3 && mapper->GetMergeLength() == right,
    "a length out of range is an error");
  mapper->SetMergeLength(5.0);
  vtkNew<vtkIlluminatedLineMapper> other;
  other->ShallowCopy(mapper);
  check(other->GetMergeLength() == 5.0 && messages->IsQuiet(), "the length is copied");
}
}

int TestIlluminatedLineMapperMerging(int, char*[])
{
  Checks check;
  CheckPictures(check);
  CheckExceptions(check);
  CheckOtherWindow(check);
  CheckMovedPoints(check);
  CheckTransparentPoints(check);
  CheckTextureUnits(check);
  CheckBadValues(check);
  return check.GetResult();
}
