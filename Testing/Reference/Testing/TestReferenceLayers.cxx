// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the picture that the reference renderer makes of scenes whose answer is known: a bent
// line is one layer, crossing curves are two, n layers blend by the closed formula, attributes are
// interpolated along the axis, planes and other geometry cut, and a camera inside a tube sees it.

#include "ReferenceRenderer.h"
#include "ReferenceTesting.h"

#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

using namespace linesets;

namespace
{
// A view along -z on [-1,1] x [-1,1] with z = 5 nearest, of 41 x 41 pixels; pixel (20,20) looks at
// the origin.
class View
{
public:
  explicit View(const CapsuleScene& scene)
    : Renderer(scene)
  {
    this->Camera->SetPosition(0, 0, 5);
    this->Camera->SetFocalPoint(0, 0, 0);
    this->Camera->SetClippingRange(0.0001, 20);
    this->Camera->ParallelProjectionOn();
    this->Camera->SetParallelScale(1.0);
    this->Renderer.Camera = this->Camera;
    this->Renderer.Width = 41;
    this->Renderer.Height = 41;
    this->Renderer.CountAllLayers = true;
  }

  std::size_t Draw(int x = 20, int y = 20)
  {
    this->Renderer.Render(this->Image);
    return 41 * static_cast<std::size_t>(y) + x;
  }

  vtkNew<vtkCamera> Camera;
  ReferenceRenderer Renderer;
  ReferenceImage Image;
};

void CheckCounts(Checker& checker)
{
  CapsuleScene scene;
  scene.Capsules = { MakeCapsule(-1, -1, 0, 0, 0, 0, 0.2), MakeCapsule(0, 0, 0, 1, -1, 0, 0.2) };
  View bent(scene);
  checker.Check(bent.Image.Layers.empty() && bent.Draw() == 840, "pixel of the origin");
  checker.Check(bent.Image.Layers[840] == 1, "a bent line is one layer at its joint");
  checker.CheckNear(bent.Image.Depth[840], (4.8 - 0.0001) / 19.9999, 1e-9, "depth of the joint");

  scene.Capsules[1].Curve = 1;
  View crossing(scene);
  const std::size_t pixel = crossing.Draw();
  checker.Check(crossing.Image.Layers[pixel] == 2, "two curves are two layers");
  checker.Check(crossing.Image.Curve[pixel] == 0, "the lower curve is first at equal depth");

  // A hairpin across the view: the same curve twice.
  scene.Capsules = { MakeCapsule(-2, 0, 1, 2, 0, 1, 0.2), MakeCapsule(2, 0, 1, 2, 0, -1, 0.2),
    MakeCapsule(2, 0, -1, -2, 0, -1, 0.2) };
  View hairpin(scene);
  checker.Check(hairpin.Image.Layers.empty(), "drawn only when asked");
  hairpin.Draw();
  checker.Check(hairpin.Image.Layers[840] == 2, "a hairpin is two layers");
  checker.Check(hairpin.Image.Layers[840 + 41 * 10] == 0, "beside it is nothing");
  hairpin.Renderer.CountAllLayers = false;
  hairpin.Draw();
  checker.Check(hairpin.Image.Layers[840] == 1, "opaque: the nearest layer is all");
}

void CheckBlending(Checker& checker)
{
  // Spheres along the view axis, nearest last, each a curve with its own direct colour.
  const int count = 40;
  CapsuleScene scene;
  scene.Colors = ColorSource::Direct;
  Random random(3);
  for (int i = 0; i < count; ++i)
  {
    const double z = -4.0 + 0.2 * i;
    Capsule sphere = MakeCapsule(0, 0, z, 0, 0, z, 0.05, i);
    for (int c = 0; c < 4; ++c)
    {
      sphere.StartColor[c] = static_cast<unsigned char>(random.Uniform(0, 256));
      sphere.EndColor[c] = sphere.StartColor[c];
    }
    scene.Capsules.push_back(sphere);
  }
  View view(scene);
  view.Renderer.Surface.Opacity = 0.6;
  view.Renderer.Surface.Ambient = 0.2;
  view.Renderer.Surface.Diffuse = 0.5;
  view.Renderer.Surface.Specular = 0.1;
  const double background[3] = { 0.1, 0.9, 0.4 };
  std::copy_n(background, 3, view.Renderer.Background);
  const std::size_t pixel = view.Draw();
  checker.Check(view.Image.Layers[pixel] == count, "all spheres are layers");
  // Back to front, the other way round than the renderer. Head-on, the headlight gives
  // (ambient + diffuse) colour + specular.
  double expected[3] = { 0.1, 0.9, 0.4 };
  for (const Capsule& sphere : scene.Capsules)
  {
    const double opacity = 0.6 * sphere.StartColor[3] / 255.0;
    for (int c = 0; c < 3; ++c)
    {
      const double color = std::min(1.0, 0.7 * sphere.StartColor[c] / 255.0 + 0.1);
      expected[c] = opacity * color + (1.0 - opacity) * expected[c];
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    checker.CheckNear(view.Image.Color[3 * pixel + c], expected[c], 1e-12, "blended colour");
    checker.CheckNear(view.Image.Color[c], background[c], 0.0, "background elsewhere");
  }
  checker.CheckNear(view.Image.Depth[0], 1.0, 0.0, "depth of the background");
  checker.Check(view.Image.Curve[0] == -1, "curve of the background");

  std::vector<double>& image = view.Renderer.BackgroundImage;
  image.assign(41 * 41 * 3, 0.25);
  view.Draw();
  checker.CheckNear(view.Image.Color[0], 0.25, 0.0, "background image");
  const double seen = expected[0];
  checker.CheckNear(view.Image.Color[3 * pixel],
    seen + (1.0 - view.Image.Opacity[pixel]) * (0.25 - 0.1), 1e-12, "in front of an image");
}

void CheckAttributes(Checker& checker)
{
  CapsuleScene scene;
  scene.Colors = ColorSource::Scalars;
  scene.Capsules = { MakeCapsule(-1, 0, 0, 1, 0, 0, 0.1) };
  scene.Capsules[0].StartValue = 10.0;
  scene.Capsules[0].EndValue = 20.0;
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(10);
  table->SetRange(10.0, 20.0);
  for (int i = 0; i < 10; ++i)
  {
    table->SetTableValue(i, i / 10.0, 0.5, 0.0, i < 5 ? 1.0 : 0.5);
  }
  View view(scene);
  view.Renderer.Table = ColorTable(table);
  for (int x = 0; x < 41; ++x)
  {
    const std::size_t pixel = view.Draw(x);
    // Head-on the colour is the table's; steps of the table are 4.1 pixels wide.
    const int entry = static_cast<int>(10.0 * (x + 0.5) / 41.0);
    const double opacity = entry < 5 ? 1.0 : 128 / 255.0;
    const double red = std::floor(entry / 10.0 * 255.0 + 0.5) / 255.0;
    checker.CheckNear(view.Image.Opacity[pixel], opacity, 1e-9, "opacity of the table");
    checker.CheckNear(view.Image.Color[3 * pixel], opacity * red, 1e-9, "colour of the table");
  }
}

void CheckCuts(Checker& checker)
{
  CapsuleScene scene;
  scene.Capsules = { MakeCapsule(-2, 0, 2, 2, 0, 2, 0.5, 0),
    MakeCapsule(-2, 0, -2, 2, 0, -2, 0.5, 1) };
  View view(scene);
  view.Renderer.Surface.Diffuse = 0.8;
  const std::size_t pixel = view.Draw();
  checker.Check(view.Image.Layers[pixel] == 2, "two tubes");
  view.Renderer.Planes = { { { 0, 0, 2.0 }, { 0, 0, -1 } } };
  view.Draw();
  checker.Check(view.Image.Layers[pixel] == 2, "a cut tube shows its far side");
  checker.CheckNear(view.Image.Depth[pixel], (3.5 - 0.0001) / 19.9999, 1e-9, "at its far side");
  checker.CheckNear(view.Image.Color[3 * pixel], 0.8, 1e-12, "lit from inside");
  view.Renderer.Planes = { { { 0, 0, 1.4 }, { 0, 0, -1 } } };
  view.Draw();
  checker.Check(view.Image.Layers[pixel] == 1 && view.Image.Curve[pixel] == 1, "cut away");
  view.Renderer.Planes = { { { 0, 0, 0 }, { 1, 0, 0 } } };
  view.Draw();
  checker.Check(view.Image.Layers[pixel - 1] == 0 && view.Image.Layers[pixel + 1] == 2,
    "a plane along the ray keeps one side");
  view.Renderer.Planes.clear();
  view.Renderer.SceneDepth.assign(41 * 41, static_cast<float>((5.0 - 0.0001) / 19.9999));
  view.Draw();
  checker.Check(view.Image.Layers[pixel] == 1 && view.Image.Curve[pixel] == 0, "hidden");
  view.Renderer.SceneDepth.clear();
  view.Camera->SetPosition(0, 0, 2.1);
  view.Draw();
  checker.Check(view.Image.Layers[pixel] == 2, "the camera is inside a tube");
  checker.CheckNear(
    view.Image.Depth[pixel], (0.6 - 0.0001) / 19.9999, 1e-9, "and sees its far side");
}
}

int TestReferenceLayers(int, char*[])
{
  Checker checker;
  CheckCounts(checker);
  CheckBlending(checker);
  CheckAttributes(checker);
  CheckCuts(checker);
  return checker.GetExitCode();
}
