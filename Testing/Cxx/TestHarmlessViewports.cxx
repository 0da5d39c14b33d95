// SPDX-License-Identifier: BSD-3-Clause

// Several renderers in one window: viewports, layers, and a second renderer that does not erase.

#include "vtkRendererCollection.h"
#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"

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
  const auto drawAll = [&](const std::function<vtkRenderPass*(int)>& passOf)
  {
    vtkCollectionSimpleIterator it;
    vtkRendererCollection* renderers = together.Window->GetRenderers();
    renderers->InitTraversal(it);
    for (int i = 0; vtkRenderer* renderer = renderers->GetNextRenderer(it); ++i)
    {
      renderer->SetPass(passOf(i));
    }
    together.Render();
    return together.Read();
  };
  const Picture plain = drawAll([](int) { return nullptr; });
  for (AOPass* pass : passes)
  {
    ForceVisibility(pass, 1.0);
  }
  const Picture open = drawAll([&](int i) { return passes[i]; });
  const std::string samples = std::to_string(multiSamples) + " samples";
  report.Same(samples + ", viewports, V 1", plain, open, 1.0 * Step);
  report.SetListening(false);
  std::vector<vtkSmartPointer<vtkSSAOPass>> vtks;
  for (int i = 0; i < 4; ++i)
  {
    vtks.push_back(MakeVTKPass());
  }
  const Picture ofVTK = drawAll([&](int i) { return vtks[i]; });
  drawAll([&](int i) { return passes[i]; });
  for (vtkSSAOPass* pass : vtks)
  {
    pass->ReleaseGraphicsResources(together.Window);
  }
  report.SetListening(true);
  PrintRow("2 x 2 viewports, " + samples, std::to_string(LargestDifference(plain, open)),
    std::to_string(LargestDifference(plain, ofVTK)));
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
void CheckOverlay(Report& report, bool layer, bool preserveDepth, int multiSamples = 0)
{
  Stage stage(report, 160, 120, multiSamples);
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
  const std::string name = std::string(layer ? "layers" : "no erase") +
    (preserveDepth ? ", depth kept" : "") +
    (multiSamples ? ", " + std::to_string(multiSamples) + " samples" : "");
  const Picture plain = draw(nullptr, nullptr);
  report.Differ(name + ", the second renderer draws", plainAlone, plain, 0.1, 300);
  ForceVisibility(secondPass, 1.0);
  vtkNew<AOPass> open;
  ForceVisibility(open, 1.0);
  // The contract for V = 1.
  const Picture openPicture = draw(open, secondPass);
  report.Same(name + ", V 1", plain, openPicture, 1.0 * Step);
  report.SetListening(false);
  vtkSmartPointer<vtkSSAOPass> vtks[2] = { MakeVTKPass(), MakeVTKPass() };
  const Picture ofVTK = draw(vtks[0], vtks[1]);
  draw(nullptr, nullptr);
  for (vtkSSAOPass* pass : vtks)
  {
    pass->ReleaseGraphicsResources(stage.Window);
  }
  report.SetListening(true);
  PrintRow(name, std::to_string(LargestDifference(plain, openPicture)),
    std::to_string(LargestDifference(plain, ofVTK)));

  // The second renderer's pass touches the second renderer's pixels only, and the first's the
  // first's.
  const Mask above = ChangedPixels(plainAlone, plain);
  const Mask below = [&](int x, int y) { return !above(x, y); };
  ForceVisibility(secondPass, 0.3);
  const Picture both = draw(firstPass, secondPass);
  report.Same(name + ", the first renderer", firstAlone, both, 0.0, below, 5000);
  // Samples of silhouettes show the first renderer, too.
  const Mask inside = SmoothPixels(plain, 0.1);
  report.Same(
    name + ", the second renderer", draw(nullptr, secondPass), both, 0.0,
    [&](int x, int y) { return above(x, y) && (!multiSamples || inside(x, y)); }, 300);
  report.Differ(name + ", the second is darkened", plain, both, 0.1, 300, above);
}

//------------------------------------------------------------------------------
// A renderer that does not erase: what it drew before stays where nothing is drawn over it.
void CheckTrail(Report& report, int multiSamples)
{
  const std::string name =
    "one renderer without erasing, " + std::to_string(multiSamples) + " samples";
  const auto draw = [&](vtkRenderPass* pass)
  {
    Stage stage(report, 160, 120, multiSamples);
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5));
    stage.Renderer->AddActor(sphere);
    stage.Camera()->SetPosition(0.0, 0.0, 6.0);
    stage.Camera()->SetClippingRange(4.0, 8.0);
    for (double x : { -0.9, 0.0, 0.9 })
    {
      sphere->SetPosition(x, 0.3 * x, 0.0);
      stage.Draw(pass);
      stage.Renderer->EraseOff();
    }
    const Picture picture = stage.Read();
    stage.Renderer->SetPass(nullptr);
    if (pass)
    {
      pass->ReleaseGraphicsResources(stage.Window);
    }
    return picture;
  };
  const Picture plain = draw(nullptr);
  int left = 0;
  for (int y = 0; y < plain.Height; ++y)
  {
    left += plain.At(45, y)[0] > 0.5F ? 1 : 0;
  }
  report.ExpectAtLeast(left, 10, name + ", pixels that show the first frame");
  vtkNew<AOPass> pass;
  ForceVisibility(pass, 1.0);
  const Picture open = draw(pass);
  report.Same(name + ", V 1", plain, open, 1.0 * Step);
  pass->SetIntensity(0.0);
  report.Same(name + ", Intensity 0", plain, draw(pass), 1.0 * Step);
  report.SetListening(false);
  const Picture ofVTK = draw(MakeVTKPass());
  report.SetListening(true);
  PrintRow(name, std::to_string(LargestDifference(plain, open)),
    std::to_string(LargestDifference(plain, ofVTK)));
}

//------------------------------------------------------------------------------
// A viewport whose corner is on no whole pixel.
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
  CheckOverlay(report, false, true);
  CheckOverlay(report, true, false, 4);
  CheckOverlay(report, false, false, 4);
  CheckTrail(report, 0);
  CheckTrail(report, 4);
  CheckViewportWithBorders(report);
  return report.GetResult();
}
