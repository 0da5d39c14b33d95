// SPDX-License-Identifier: BSD-3-Clause

// Glass casts no occlusion, receives none, and the occlusion behind it shows through.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"

namespace
{
using namespace vtkSSAOTest;

constexpr double Opacity = 0.4;

//------------------------------------------------------------------------------
void CheckGlass(
  Report& report, const std::string& name, const std::function<void(Stage&)>& set, int multiSamples)
{
  Stage stage(report, 150, 120, multiSamples);
  set(stage);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.3);
  floor->SetPoint1(3.0, -1.0, -0.3);
  floor->SetPoint2(-1.0, 3.0, -0.3);
  floor->Update();
  stage.Renderer->AddActor(MakeActor(floor->GetOutput()));
  for (int i = 0; i < 9; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5));
    sphere->SetPosition(i % 3, i / 3, -0.1);
    stage.Renderer->AddActor(sphere);
  }
  stage.Camera()->SetFocalPoint(1.0, 1.0, 0.0);
  stage.Camera()->SetPosition(1.2, -1.0, 9.0);
  stage.Camera()->SetClippingRange(4.0, 14.0);
  // A slanted pane of one colour that cuts through spheres; unlit, so that its share is known.
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(0.0, 0.0, 0.6);
  source->SetPoint1(2.2, 0.2, 0.1);
  source->SetPoint2(0.1, 2.2, 0.2);
  source->Update();
  vtkSmartPointer<vtkActor> pane = MakeActor(source->GetOutput());
  pane->GetProperty()->LightingOff();
  pane->GetProperty()->SetColor(0.2, 0.9, 0.4);
  pane->GetProperty()->SetOpacity(Opacity);
  stage.Renderer->AddActor(pane);

  vtkNew<AOPass> pass;
  pass->SetRadius(0.8);
  pass->SetIntensity(3.0);
  pane->VisibilityOff();
  const Picture plain = stage.Draw(nullptr);
  const Picture occluded = stage.Draw(pass);
  pane->VisibilityOn();
  const Picture plainGlass = stage.Draw(nullptr);
  const Picture occludedGlass = stage.Draw(pass);
  report.Differ(name + ", there is glass", plain, plainGlass, 0.05, 1000);
  const Mask behindGlass = ChangedPixels(plain, plainGlass);
  const Mask inFront = [&](int x, int y) { return !behindGlass(x, y); };
  report.Differ(name + ", there is occlusion", plain, occluded, 0.1, 300, behindGlass);

  // What occlusion takes behind the pane shows weakened by the pane. Under multisampling VTK's own
  // translucency is not exact at silhouettes.
  const Picture expected = Picture::Of([](float before, float after, float glass)
    { return glass + (1.0 - Opacity) * (after - before); },
    plain, occluded, plainGlass);
  const Mask inside = SmoothPixels(plainGlass, 0.1);
  const Mask compared = [&](int x, int y)
  { return behindGlass(x, y) && (!multiSamples || inside(x, y)); };
  // Half a step for each of the four pictures.
  report.Same(name + ", behind the glass", expected, occludedGlass, 2.0 * Step, compared, 300);
  report.Same(name + ", beside the glass", occluded, occludedGlass, 0.0, inFront, 1000);

  pass->SetOutputModeToOcclusion();
  const Picture visibility = stage.Draw(pass);
  pane->VisibilityOff();
  report.Same(name + ", visibility", stage.Draw(pass), visibility, 0.0);

  // Glass alone.
  stage.Renderer->RemoveAllViewProps();
  pane->VisibilityOn();
  pane->GetProperty()->LightingOn();
  stage.Renderer->AddActor(pane);
  pass->SetOutputModeToComposite();
  pass->SetModulationToAll();
  ForceVisibility(pass, 0.0);
  const Picture alone = stage.Draw(nullptr);
  report.Same(name + ", lit glass alone", alone, stage.Draw(pass), 0.0);
}
}

//------------------------------------------------------------------------------
int TestHarmlessTranslucent(int, char*[])
{
  Report report;
  const auto nothing = [](Stage&) {};
  const auto peeling = [](Stage& stage)
  {
    stage.Renderer->UseDepthPeelingOn();
    stage.Renderer->SetMaximumNumberOfPeels(8);
    stage.Renderer->SetOcclusionRatio(0.0);
    stage.Window->AlphaBitPlanesOn();
  };
  CheckGlass(report, "order-independent", nothing, 0);
  CheckGlass(report, "depth peeling", peeling, 0);
  CheckGlass(report, "order-independent, 4 samples", nothing, 4);
  HarmlessOptions alone;
  alone.Floor = false;
  CheckHarmless(
    report, "glass alone",
    [](Stage& stage)
    {
      vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.7));
      glass->GetProperty()->SetOpacity(0.5);
      stage.Renderer->AddActor(glass);
      stage.Renderer->ResetCamera();
    },
    alone);
  for (const bool peeled : { false, true })
  {
    for (const int samples : { 0, 4 })
    {
      HarmlessOptions options;
      options.MultiSamples = samples;
      if (peeled && samples > 0)
      {
        // Under multisampling VTK's peeling copies between depth buffers of different formats,
        // which is an error, and draws no glass at all, with or without a pass.
        continue;
      }
      CheckHarmless(
        report,
        std::string("glass, ") + (peeled ? "depth peeling, " : "order-independent, ") +
          std::to_string(samples) + " samples",
        [&](Stage& stage)
        {
          Grid grid(3);
          AddTranslucentProps(stage.Renderer, grid);
          for (int i = 0; i < 3; ++i)
          {
            vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.7));
            glass->SetPosition(0.5 * i + 0.5, 0.5 * i, 0.5);
            glass->GetProperty()->SetOpacity(0.5);
            glass->GetProperty()->SetColor(0.3 * i, 0.5, 1.0 - 0.3 * i);
            stage.Renderer->AddActor(glass);
          }
          if (peeled)
          {
            peeling(stage);
          }
        },
        options);
    }
  }
  return report.GetResult();
}
