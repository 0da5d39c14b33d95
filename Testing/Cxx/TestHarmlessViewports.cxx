// SPDX-License-Identifier: BSD-3-Clause

// Several renderers in one window: viewports, layers, and a second renderer that does not erase.

#include "vtkSSAOTestEverything.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// Four different scenes of spheres on a floor.
void BuildScene(vtkRenderer* renderer, int number)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.4);
  floor->SetPoint1(3.0, -1.0, -0.4);
  floor->SetPoint2(-1.0, 3.0, -0.4);
  floor->Update();
  vtkSmartPointer<vtkActor> ground = MakeActor(floor->GetOutput());
  ground->GetProperty()->SetColor(0.5 + 0.1 * number, 0.8, 0.9 - 0.1 * number);
  renderer->AddActor(ground);
  for (int i = 0; i < 4 + number; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5));
    sphere->SetPosition(i % 3, i / 3, 0.0);
    renderer->AddActor(sphere);
  }
  renderer->SetBackground(0.1 * number, 0.3, 0.4);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(1.0, 1.0, 0.0);
  camera->SetPosition(1.2 - number, -1.0 + number, 9.0);
  camera->SetClippingRange(4.0, 14.0);
}

//------------------------------------------------------------------------------
void CheckViewports(Report& report, int multiSamples)
{
  const int width = 100;
  const int height = 70;
  Stage together(report, 2 * width, 2 * height, multiSamples);
  std::vector<vtkSmartPointer<AOPass>> passes;
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkRenderer> renderer = together.Renderer.Get();
    if (i > 0)
    {
      renderer = vtkSmartPointer<vtkRenderer>::New();
      together.Window->AddRenderer(renderer);
    }
    renderer->SetViewport(0.5 * (i % 2), 0.5 * (i / 2), 0.5 + 0.5 * (i % 2), 0.5 + 0.5 * (i / 2));
    BuildScene(renderer, i);
    passes.push_back(vtkSmartPointer<AOPass>::New());
    renderer->SetPass(passes.back());
  }
  together.Render();
  const Picture all = together.Read();
  for (int i = 0; i < 4; ++i)
  {
    Stage alone(report, width, height, multiSamples);
    BuildScene(alone.Renderer, i);
    vtkNew<AOPass> pass;
    const Picture expected = alone.Draw(pass);
    const std::string name =
      std::to_string(multiSamples) + " samples, viewport " + std::to_string(i);
    // Window positions differ in their last bits, which rounding of depth to a pixel may show.
    report.Same(
      name, expected, all.Part(width * (i % 2), height * (i / 2), width, height), 1.0 * Step);
    report.Differ(name + ", there is occlusion", expected, alone.Draw(nullptr), 0.1, 60);
  }
}

//------------------------------------------------------------------------------
// A second renderer over the first: on a layer of its own, or on the same one without erasing.
void CheckOverlay(Report& report, bool layer, bool preserveDepth)
{
  Stage stage(report, 160, 120);
  BuildScene(stage.Renderer, 2);
  vtkNew<vtkRenderer> second;
  BuildScene(second, 0);
  second->RemoveViewProp(second->GetViewProps()->GetLastProp());
  vtkActor::SafeDownCast(second->GetViewProps()->GetItemAsObject(0))->VisibilityOff();
  second->GetActiveCamera()->SetFocalPoint(2.0, 2.5, 0.0);
  second->SetPreserveDepthBuffer(preserveDepth);
  if (layer)
  {
    stage.Window->SetNumberOfLayers(2);
    second->SetLayer(1);
  }
  else
  {
    second->EraseOff();
  }

  vtkNew<AOPass> firstPass;
  vtkNew<AOPass> secondPass;
  const Picture firstAlone = stage.Draw(firstPass);
  const Picture plainAlone = stage.Draw(nullptr);
  stage.Window->AddRenderer(second);
  const auto draw = [&](vtkRenderPass* below, vtkRenderPass* above)
  {
    second->SetPass(above);
    return stage.Draw(below);
  };
  const std::string name =
    std::string(layer ? "layers" : "no erase") + (preserveDepth ? ", depth kept" : "");
  const Picture plain = draw(nullptr, nullptr);
  report.Differ(name + ", the second renderer draws", plainAlone, plain, 0.1, 300);
  ForceVisibility(secondPass, 1.0);
  vtkNew<AOPass> open;
  ForceVisibility(open, 1.0);
  // The contract for V = 1.
  report.Same(name + ", V 1", plain, draw(open, secondPass), 1.0 * Step);

  // The second renderer's pass touches the second renderer's pixels only, and the first's the
  // first's.
  const Mask above = ChangedPixels(plainAlone, plain);
  const Mask below = [&](int x, int y) { return !above(x, y); };
  ForceVisibility(secondPass, 0.3);
  const Picture both = draw(firstPass, secondPass);
  report.Same(name + ", the first renderer", firstAlone, both, 0.0, below, 5000);
  report.Same(name + ", the second renderer", draw(nullptr, secondPass), both, 0.0, above, 300);
  report.Differ(name + ", the second is darkened", plain, both, 0.1, 300, above);
}

//------------------------------------------------------------------------------
// Parts of a picture that is magnified in tiles join.
void CheckViewportWithBorders(Report& report)
{
  // A viewport whose corner is on no whole pixel of the window.
  Stage stage(report, 151, 97);
  stage.Renderer->SetViewport(0.213, 0.307, 0.911, 0.887);
  BuildScene(stage.Renderer, 1);
  vtkNew<AOPass> pass;
  ForceVisibility(pass, 1.0);
  const Picture plain = stage.Draw(nullptr);
  report.Same("odd viewport, V 1", plain, stage.Draw(pass), 1.0 * Step);
  ForceVisibility(pass, 0.0);
  const Picture dark = stage.Draw(pass);
  report.Differ("odd viewport, V 0", plain, dark, 0.1, 1000);
  report.Same(
    "odd viewport, outside", plain, dark, 0.0,
    [](int x, int y) { return x < 31 || y < 28 || x > 138 || y > 87; }, 5000);
}
}

//------------------------------------------------------------------------------
int TestHarmlessViewports(int, char*[])
{
  Report report;
  CheckViewports(report, 0);
  CheckViewports(report, 4);
  CheckOverlay(report, true, false);
  CheckOverlay(report, true, true);
  CheckOverlay(report, false, false);
  CheckViewportWithBorders(report);
  return report.GetResult();
}
