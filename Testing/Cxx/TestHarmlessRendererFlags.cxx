// SPDX-License-Identifier: BSD-3-Clause

// Without a delegate the pass honours the flags of the renderer: FXAA, hidden line removal,
// shadows, depth peeling of surfaces and volumes. Where VTK draws the flag by a pass of its own
// there is one warning and no occlusion.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestShapes.h"

#include "vtkFXAAOptions.h"

namespace
{
using namespace vtkSSAOTest;

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
  const std::function<void(bool)>& set, int changed, int warnings = 0)
{
  vtkNew<AOPass> pass;
  vtkSSAOErrorObserver observer(pass);
  ForceVisibility(pass, 1.0);
  const Picture off = stage.Draw(nullptr);
  set(true);
  const Picture on = stage.Draw(nullptr);
  report.Differ(name + " has an effect", off, on, 0.02, changed);
  // The contract for V = 1.
  report.Same(name + " on", on, stage.Draw(pass), 1.0 * Step);
  stage.Draw(pass);
  report.Equal(name + ", warnings", warnings, observer.GetWarnings());
  report.Equal(name + ", errors", 0, observer.GetErrors());
  if (warnings > 0)
  {
    ForceVisibility(pass, 0.0);
    report.Same(name + " on, V 0", on, stage.Draw(pass), 0.0);
    ForceVisibility(pass, 1.0);
  }
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
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
    CheckFlag(
      report, stage, "FXAA", [&](bool on) { stage.Renderer->SetUseFXAA(on); }, 200);
    // VTK does not apply it to a picture without props.
    {
      Stage empty(report, 140, 110);
      empty.Renderer->SetBackgroundTexture(MakeWavesTexture());
      empty.Renderer->TexturedBackgroundOn();
      empty.Renderer->UseFXAAOn();
      const Picture background = empty.Draw(nullptr);
      report.Same("FXAA without props", background, empty.Draw(vtkNew<AOPass>()), 0.0);
      empty.Renderer->SetPass(nullptr);
    }
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
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
    vtkSmartPointer<vtkActor> wires = MakeActor(MakeSphere(1.0, 12));
    wires->SetPosition(1.0, 1.0, 1.0);
    wires->GetProperty()->SetRepresentationToWireframe();
    stage.Renderer->AddActor(wires);
    CheckFlag(
      report, stage, "hidden line removal",
      [&](bool on) { stage.Renderer->SetUseHiddenLineRemoval(on); }, 100, 1);
  }
  for (const bool glass : { false, true })
  {
    Stage stage(report, 140, 110);
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
    stage.Renderer->RemoveAllLights();
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToSceneLight();
    lamp->SetPosition(4.0, 4.0, 4.0);
    lamp->SetFocalPoint(1.0, 1.0, 0.0);
    stage.Renderer->AddLight(lamp);
    if (glass)
    {
      AddGlass(stage);
    }
    CheckFlag(
      report, stage, std::string("shadows") + (glass ? " and glass" : ""),
      [&](bool on) { stage.Renderer->SetUseShadows(on); }, 100, 1);
  }
  {
    Stage stage(report, 140, 110);
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
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
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
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
