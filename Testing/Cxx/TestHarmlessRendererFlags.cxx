// SPDX-License-Identifier: BSD-3-Clause

// Without a delegate the pass honours the flags of the renderer: FXAA, hidden line removal, depth
// peeling of surfaces and volumes.

#include "vtkSSAOTestEverything.h"

#include "vtkFXAAOptions.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
void BuildScene(Stage& stage)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.4);
  floor->SetPoint1(3.0, -1.0, -0.4);
  floor->SetPoint2(-1.0, 3.0, -0.4);
  floor->Update();
  stage.Renderer->AddActor(MakeActor(floor->GetOutput()));
  for (int i = 0; i < 6; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.45));
    sphere->SetPosition(i % 3, i / 3, 0.0);
    stage.Renderer->AddActor(sphere);
  }
  stage.Camera()->SetFocalPoint(1.0, 1.0, 0.0);
  stage.Camera()->SetPosition(1.2, -1.0, 9.0);
  stage.Camera()->SetClippingRange(4.0, 14.0);
}

//------------------------------------------------------------------------------
// Three spheres of glass through each other, and peels enough for all their layers.
void AddGlass(Stage& stage)
{
  for (int i = 0; i < 3; ++i)
  {
    vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.7));
    glass->SetPosition(0.5 * i + 0.5, 0.5 * i, 0.5);
    glass->GetProperty()->SetOpacity(0.5);
    glass->GetProperty()->SetColor(0.3 * i, 0.5, 1.0 - 0.3 * i);
    stage.Renderer->AddActor(glass);
  }
  stage.Renderer->SetMaximumNumberOfPeels(10);
  stage.Renderer->SetOcclusionRatio(0.0);
}

//------------------------------------------------------------------------------
// The flag changes the picture, and with V 1 the pass gives the picture with the flag.
void CheckFlag(Report& report, Stage& stage, const std::string& name,
  const std::function<void(bool)>& set, int changed)
{
  vtkNew<AOPass> pass;
  ForceVisibility(pass, 1.0);
  const Picture off = stage.Draw(nullptr);
  set(true);
  const Picture on = stage.Draw(nullptr);
  report.Differ(name + " has an effect", off, on, 0.02, changed);
  // The contract for V = 1.
  report.Same(name + " on", on, stage.Draw(pass), 1.0 * Step);
  set(false);
  report.Same(name + " off again", off, stage.Draw(pass), 1.0 * Step);
  pass->ReleaseGraphicsResources(stage.Window);
}
}

//------------------------------------------------------------------------------
int TestHarmlessRendererFlags(int, char*[])
{
  Report report;
  {
    Stage stage(report, 140, 110);
    BuildScene(stage);
    CheckFlag(
      report, stage, "FXAA", [&](bool on) { stage.Renderer->SetUseFXAA(on); }, 200);
    // Its options, too.
    stage.Renderer->UseFXAAOn();
    CheckFlag(
      report, stage, "FXAA option",
      [&](bool on)
      {
        stage.Renderer->GetFXAAOptions()->SetDebugOptionValue(
          on ? vtkFXAAOptions::FXAA_DEBUG_EDGE_DIRECTION : vtkFXAAOptions::FXAA_NO_DEBUG);
      },
      200);
    // Occlusion comes before it: silhouettes against the background stay smooth.
    vtkNew<AOPass> pass;
    ForceVisibility(pass, 0.0);
    const Picture smooth = stage.Draw(pass);
    stage.Renderer->UseFXAAOff();
    report.Differ("FXAA after occlusion", stage.Draw(pass), smooth, 0.02, 100);
  }
  {
    Stage stage(report, 140, 110);
    BuildScene(stage);
    vtkSmartPointer<vtkActor> wires = MakeActor(MakeSphere(1.0, 12));
    wires->SetPosition(1.0, 1.0, 1.0);
    wires->GetProperty()->SetRepresentationToWireframe();
    stage.Renderer->AddActor(wires);
    CheckFlag(
      report, stage, "hidden line removal",
      [&](bool on) { stage.Renderer->SetUseHiddenLineRemoval(on); }, 100);
  }
  {
    Stage stage(report, 140, 110);
    BuildScene(stage);
    AddGlass(stage);
    CheckFlag(
      report, stage, "depth peeling", [&](bool on) { stage.Renderer->SetUseDepthPeeling(on); },
      300);
  }
  // VTK looks at this flag when it peels for the first time, so each window has its own.
  Picture peeled[2];
  for (int on = 0; on < 2; ++on)
  {
    Stage stage(report, 140, 110);
    BuildScene(stage);
    AddGlass(stage);
    Grid grid(3);
    AddVolume(stage.Renderer, grid);
    // Inside the glass.
    vtkVolume::SafeDownCast(stage.Renderer->GetViewProps()->GetLastProp())
      ->AddPosition(1.0, 0.5, 0.6);
    stage.Renderer->UseDepthPeelingOn();
    stage.Renderer->SetUseDepthPeelingForVolumes(on == 1);
    vtkNew<AOPass> pass;
    ForceVisibility(pass, 1.0);
    peeled[on] = stage.Draw(nullptr);
    // The contract for V = 1.
    report.Same(
      "depth peeling of volumes " + std::to_string(on), peeled[on], stage.Draw(pass), 1.0 * Step);
  }
  report.Differ("depth peeling of volumes has an effect", peeled[0], peeled[1], 0.02, 20);
  return report.GetResult();
}
