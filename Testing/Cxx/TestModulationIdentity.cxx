// SPDX-License-Identifier: BSD-3-Clause

// With visibility 1 the picture is the one without the pass, whatever is in the scene.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestProps.h"

#include "vtkLightKit.h"
#include "vtkSkybox.h"

namespace
{
using namespace vtkSSAOTest;

// The contract; VTK's own picture is the same to the last bit from frame to frame.
constexpr double Tolerance = 1.0 * Step;

//------------------------------------------------------------------------------
// All ways to visibility 1 give the plain picture.
void Check(Report& report, Stage& stage, const std::string& name, bool allWays)
{
  const Picture plain = stage.Draw(nullptr);
  const auto check = [&](const char* what, const std::function<void(AOPass*)>& set)
  {
    vtkNew<AOPass> pass;
    set(pass);
    report.Same(name + ", " + what, plain, stage.Draw(pass), Tolerance);
  };
  check("forced V 1", [](AOPass* pass) { ForceVisibility(pass, 1.0); });
  if (!allWays)
  {
    return;
  }
  check("Ambient",
    [](AOPass* pass)
    {
      pass->SetModulationToAmbient();
      ForceVisibility(pass, 1.0);
    });
  check("All",
    [](AOPass* pass)
    {
      pass->SetModulationToAll();
      ForceVisibility(pass, 1.0);
    });
  check("Intensity 0", [](AOPass* pass) { pass->SetIntensity(0.0); });
  check("Unoccluded", [](AOPass* pass) { pass->SetOutputModeToUnoccluded(); });

  // The effect is there when it is asked for.
  vtkNew<AOPass> pass;
  ForceVisibility(pass, 0.5);
  report.Differ(name + ", forced V 0.5", plain, stage.Draw(pass), 0.05, 1000);
}

//------------------------------------------------------------------------------
void CheckScene(Report& report, bool physical, bool parallel)
{
  Stage stage(report, 300, 240);
  Grid grid(8);
  LightParts parts;
  if (physical)
  {
    AddPhysicalActors(stage.Renderer, grid);
    SetEnvironment(stage.Renderer);
  }
  else
  {
    AddLitProps(stage.Renderer, grid, parts);
    vtkSmartPointer<vtkActor> edges = MakeActor(MakeSphere(0.45, 10));
    edges->GetProperty()->EdgeVisibilityOn();
    edges->GetProperty()->VertexVisibilityOn();
    edges->GetProperty()->SetEdgeColor(0.9, 0.1, 0.1);
    grid.Place(edges);
    stage.Renderer->AddActor(edges);
  }
  if (!physical)
  {
    AddUnlitProps(stage.Renderer, grid);
  }
  AddTranslucentProps(stage.Renderer, grid);
  AddVolume(stage.Renderer, grid);
  AddAnnotations(stage.Renderer, grid);
  grid.Look(stage.Renderer, parallel);

  const std::string name =
    std::string(physical ? "physical, " : "") + (parallel ? "parallel, " : "");
  if (!physical)
  {
    stage.Renderer->GradientBackgroundOn();
    stage.Renderer->SetBackground2(0.9, 0.4, 0.2);
    SetHeadlight(stage.Renderer);
    Check(report, stage, name + "headlight, gradient background", !parallel);
  }
  if (parallel)
  {
    stage.Renderer->RemoveAllLights();
    vtkNew<vtkLightKit> kit;
    kit->AddLightsToRenderer(stage.Renderer);
    stage.Renderer->UseDepthPeelingOn();
    Check(report, stage, name + "light kit, depth peeling", false);
  }
  else
  {
    SetBrightLights(stage.Renderer);
    stage.Renderer->SetUseImageBasedLighting(physical);
    vtkSmartPointer<vtkTexture> picture = MakeWavesTexture();
    stage.Renderer->SetBackgroundTexture(picture);
    stage.Renderer->TexturedBackgroundOn();
    Check(report, stage, name + "positional lights, textured background", physical);
  }
}

//------------------------------------------------------------------------------
// A sky is an actor whose shaders nobody can hook; it is not occluded either.
void CheckSky(Report& report)
{
  Stage stage(report, 120, 90);
  SetEnvironment(stage.Renderer);
  stage.Renderer->UseImageBasedLightingOn();
  vtkNew<vtkSkybox> sky;
  sky->SetTexture(stage.Renderer->GetEnvironmentTexture());
  sky->SetProjectionToSphere();
  stage.Renderer->AddActor(sky);
  Grid grid(2);
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere());
    sphere->GetProperty()->SetInterpolationToPBR();
    grid.Place(sphere);
    stage.Renderer->AddActor(sphere);
  }
  grid.Look(stage.Renderer);
  SetHeadlight(stage.Renderer);
  Check(report, stage, "sky", false);

  // Whatever the sky wrote, it does not darken.
  const Picture plain = stage.Draw(nullptr);
  vtkNew<AOPass> pass;
  pass->SetModulationToAll();
  pass->SetOutputModeToOcclusion();
  const Picture occlusion = stage.Draw(pass);
  pass->SetOutputModeToDepth();
  const Picture depth = stage.Draw(pass);
  pass->SetOutputModeToComposite();
  ForceVisibility(pass, 0.0);
  const Mask background = [&](int x, int y) { return depth.At(x, y)[0] >= 1.0F; };
  report.Same("sky, V 0 in the background", plain, stage.Draw(pass), 0.0, background, 2000);
  const Picture white = Picture::Of([](float) { return 1.0; }, plain);
  report.Same("sky, occlusion in the background", white, occlusion, 0.0, background, 2000);
}
}

//------------------------------------------------------------------------------
int TestModulationIdentity(int, char*[])
{
  Report report;
  CheckScene(report, false, false);
  CheckScene(report, false, true);
  CheckScene(report, true, false);
  CheckSky(report);
  return report.GetResult();
}
