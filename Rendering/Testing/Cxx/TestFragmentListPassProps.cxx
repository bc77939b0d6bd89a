// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFragmentListPass with all kinds of translucent props: the pictures are those of VTK's
// dual depth peeling with as many peels as there are layers; and what it does without a delegate.

#include "FragmentListTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkOpenGLRenderWindow.h"

using namespace FragmentListTesting;

namespace
{
vtkSmartPointer<vtkVoxelLineMapper> MakeVoxelMapper(vtkVoxelLineMapper::EngineType engine)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(MakeHelices(5, 100));
  mapper->SetRadius(0.05);
  mapper->SetResolution(32);
  mapper->SetFaceBins(0);
  mapper->SetEngine(engine);
  return mapper;
}

void AddSpheres(Stage& stage)
{
  for (int i = 0; i < 8; ++i)
  {
    auto actor = stage.AddSphere(0.5 * std::cos(i), 0.5 * std::sin(2.0 * i),
      0.4 * std::sin(3.0 * i), 0.3 + 0.03 * i, 0.2 + 0.08 * i);
    actor->GetProperty()->SetColor(0.1 * i, 1.0 - 0.1 * i, 0.5);
    actor->GetProperty()->SetSpecular(0.4);
  }
  stage.AddSphere(0.1, 0.1, 0.0, 0.3);
}

void AddLines(Stage& stage, bool asTubes)
{
  vtkNew<vtkIlluminatedLineMapper> mapper;
  mapper->SetInputData(MakeHelices(5, 100));
  mapper->SetScalarRange(0.0, 1.0);
  auto actor = stage.Add(mapper, 0.4);
  actor->GetProperty()->SetLineWidth(asTubes ? 9.0 : 3.0);
  actor->GetProperty()->SetRenderLinesAsTubes(asTubes);
}

void AddPoints(Stage& stage)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeHelices(3, 30));
  mapper->SetScalarRange(0.0, 1.0);
  vtkProperty* property = stage.Add(mapper, 0.5)->GetProperty();
  property->SetRepresentationToPoints();
  property->SetPointSize(9.0);
  property->RenderPointsAsSpheresOn();
}

// A square in the plane of another one, moved towards the viewer by the mapper.
void AddCoincident(Stage& stage)
{
  Square square;
  square.HalfSize = 1.0;
  stage.Add(MakeMapper({ square }));
  vtkNew<vtkPolyDataMapper> mapper;
  square.Color = { 200, 30, 30, 100 };
  square.Z = -0.001;
  mapper->SetInputData(MakePolyData({ square }, { 0 }));
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0.0, -20.0);
  stage.Add(mapper);
}

template <typename FunctorT>
void CheckAgainstPeeling(Checks& check, const std::string& name, const FunctorT& addProps)
{
  Picture pictures[2];
  for (int i : { 0, 1 })
  {
    Stage stage(150, 150);
    LookAlongZ(stage);
    stage.Renderer->GetActiveCamera()->Azimuth(20.0);
    addProps(stage);
    vtkNew<vtkFragmentListPass> pass;
    if (i == 0)
    {
      ListStage::UseLists(stage.Renderer, pass);
    }
    else
    {
      stage.Renderer->UseDepthPeelingOn();
      stage.Renderer->SetMaximumNumberOfPeels(100);
      stage.Renderer->SetOcclusionRatio(0.0);
    }
    pictures[i] = stage.Render();
    if (i == 0)
    {
      check(pass->GetNumberOfFragments() > 1000 && pass->GetNumberOfRenderedProps() > 0,
        name + ": fragments");
    }
  }
  // Peeling keeps its sums in bytes, and takes fragments of equal depth for one.
  const Difference difference = Compare(pictures[0], pictures[1]);
  check(difference.Rms < 1.0 && difference.Part < 0.01, name + Describe(difference));
  check(GetCoverage(pictures[0], Background) > 0.1, name + ": something is seen");
}

void CheckMappers(Checks& check)
{
  CheckAgainstPeeling(check, "spheres", AddSpheres);
  CheckAgainstPeeling(check, "lines", [](Stage& stage) { AddLines(stage, false); });
  CheckAgainstPeeling(check, "lines as tubes", [](Stage& stage) { AddLines(stage, true); });
  CheckAgainstPeeling(check, "points as spheres", AddPoints);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  CheckAgainstPeeling(check, "coincident", AddCoincident);
  vtkMapper::SetResolveCoincidentTopologyToDefault();
  CheckAgainstPeeling(check, "voxel lines",
    [](Stage& stage)
    {
      stage.Add(MakeVoxelMapper(vtkVoxelLineMapper::Native), 0.5);
      AddSpheres(stage);
    });
}

// The mapper of voxels draws its own picture in the middle of the pass.
void CheckEngines(Checks& check)
{
  Picture pictures[2];
  for (int i : { 0, 1 })
  {
    ListStage stage(150, 150);
    auto mapper = MakeVoxelMapper(i == 0 ? vtkVoxelLineMapper::Native : vtkVoxelLineMapper::Shader);
    stage.Add(mapper, 0.5);
    AddSpheres(stage);
    // Several strips, thus several draws.
    stage.Pass->SetMaximumNumberOfBytes(16 * 2000);
    pictures[i] = stage.Render();
    check(mapper->GetNumberOfPictures() == 1, "rays are cast once");
    check(stage.Pass->GetNumberOfStrips() > 5, "there are several strips");
  }
  const Difference difference = Compare(pictures[0], pictures[1]);
  check(difference.Rms < 0.5 && difference.Part < 0.01, "both engines" + Describe(difference));
}

void CheckDelegate(Checks& check, Messages* messages)
{
  ListStage stage;
  stage.AddSquares(MakeSquares(3, 50, 100));
  check(stage.Pass->GetTranslucentPass() != nullptr, "there is a delegate by default");
  const Picture picture = stage.Render();
  check(stage.Pass->GetNumberOfRenderedProps() == 1, "number of rendered props");
  const vtkMTimeType time = stage.Pass->GetMTime();
  stage.Pass->SetTranslucentPass(nullptr);
  check(stage.Pass->GetMTime() > time, "another delegate is a change");
  check(GetCoverage(stage.Render(), Background) == 0.0, "nothing is drawn without a delegate");
  check(messages->TakeWarnings("no TranslucentPass") == 1, "a warning tells so");
  stage.Pass->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  check(stage.Render().Bytes == picture.Bytes, "with a delegate again");
  std::ostringstream text;
  stage.Pass->Print(text);
  check(text.str().find("NumberOfFragments: 2700") != std::string::npos, "print" + text.str());

  // As a member of a sequence.
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(stage.Pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(camera);
  check(stage.Render().Bytes == picture.Bytes, "in a sequence");
}
}

int TestFragmentListPassProps(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckMappers(check);
  CheckEngines(check);
  CheckDelegate(check, messages);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
