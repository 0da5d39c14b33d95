// SPDX-License-Identifier: BSD-3-Clause

// Strong occlusion changes the lit surfaces and nothing else: background, unlit props, lines,
// wireframe, visible edges, text, overlays and specular light stay as they are.

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkSSAOTestEverything.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
void SetStrong(AOPass* pass)
{
  pass->SetRadius(1.0);
  pass->SetIntensity(5.0);
  pass->SetPower(3.0);
}

//------------------------------------------------------------------------------
// A floor and spheres, one material for all.
vtkSmartPointer<vtkProperty> AddLitScene(Stage& stage)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetAmbient(0.2);
  property->SetSpecular(0.3);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.3);
  floor->SetPoint1(4.5, -1.0, -0.3);
  floor->SetPoint2(-1.0, 4.5, -0.3);
  floor->Update();
  vtkSmartPointer<vtkActor> ground = MakeActor(floor->GetOutput());
  ground->SetProperty(property);
  stage.Renderer->AddActor(ground);
  for (int i = 0; i < 16; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5));
    sphere->SetPosition(i % 4 + 0.5, i / 4 + 0.5, -0.1);
    sphere->SetProperty(property);
    stage.Renderer->AddActor(sphere);
  }
  return property;
}

//------------------------------------------------------------------------------
void CheckOthers(Report& report, int multiSamples, bool gradient)
{
  Stage stage(report, 220, 180, multiSamples);
  vtkSmartPointer<vtkProperty> property = AddLitScene(stage);
  Grid grid(4);
  AddUnlitProps(stage.Renderer, grid);
  AddAnnotations(stage.Renderer, grid);
  grid.Look(stage.Renderer);
  stage.Camera()->SetFocalPoint(1.5, 1.5, 0.0);
  stage.Camera()->SetPosition(1.2, -2.0, 12.0);
  stage.Camera()->SetViewAngle(33.0);
  stage.Renderer->SetGradientBackground(gradient);
  stage.Renderer->SetBackground2(0.9, 0.4, 0.1);

  // A pixel that shows no lit surface is one that does not depend on the surfaces' colours.
  property->SetColor(0.9, 0.8, 0.7);
  const Picture plain = stage.Draw(nullptr);
  property->SetColor(0.1, 0.2, 0.9);
  const Picture recoloured = stage.Draw(nullptr);
  property->SetColor(0.9, 0.8, 0.7);
  const Mask others = [&](int x, int y) { return DifferenceAt(plain, recoloured, x, y) == 0.0; };
  const Mask surfaces = [&](int x, int y) { return !others(x, y); };

  const std::string name =
    (gradient ? "gradient, " : "") + std::to_string(multiSamples) + " samples, modulation ";
  for (int modulation = AOPass::Ambient; modulation <= AOPass::All; ++modulation)
  {
    vtkNew<AOPass> pass;
    SetStrong(pass);
    pass->SetModulation(modulation);
    const Picture actual = stage.Draw(pass);
    report.Same(name + std::to_string(modulation) + ", others", plain, actual, 0.0, others, 10000);
    report.Differ(
      name + std::to_string(modulation) + ", surfaces", plain, actual, 0.05, 2000, surfaces);
    ForceVisibility(pass, 0.0);
    report.Same(name + std::to_string(modulation) + ", V 0, others", plain, stage.Draw(pass), 0.0,
      others, 10000);
  }
}

//------------------------------------------------------------------------------
// Specular and diffuse light under Ambient, specular light under AmbientAndDiffuse.
void CheckOtherLight(Report& report)
{
  Stage stage(report, 120, 100);
  vtkSmartPointer<vtkProperty> property = AddLitScene(stage);
  Grid(4).Look(stage.Renderer);
  stage.Camera()->SetFocalPoint(1.5, 1.5, 0.0);
  stage.Camera()->SetPosition(1.5, 1.5, 12.0);
  vtkNew<AOPass> pass;
  SetStrong(pass);
  property->SetAmbient(0.0);
  pass->SetModulationToAmbient();
  const Picture plain = stage.Draw(nullptr);
  report.Same("Ambient, no ambient light", plain, stage.Draw(pass), 0.0);
  pass->SetModulationToAmbientAndDiffuse();
  report.Differ("AmbientAndDiffuse", plain, stage.Draw(pass), 0.1, 1000);
  property->SetDiffuse(0.0);
  property->SetSpecular(1.0);
  const Picture glossy = stage.Draw(nullptr);
  report.Same("AmbientAndDiffuse, specular light only", glossy, stage.Draw(pass), 0.0);
  pass->SetModulationToAll();
  report.Differ("All", glossy, stage.Draw(pass), 0.1, 300);
}

//------------------------------------------------------------------------------
// Edges drawn on a surface, as they are and as tubes: with the surface black, everything that is
// not black is edge.
void CheckEdges(Report& report)
{
  Stage stage(report, 120, 100);
  vtkSmartPointer<vtkActor> actor = MakeActor(MakeSphere(0.5, 8));
  vtkProperty* property = actor->GetProperty();
  property->EdgeVisibilityOn();
  property->SetEdgeColor(0.9, 0.3, 0.1);
  property->SetLineWidth(4.0F);
  property->SetDiffuse(1.0);
  property->SetColor(0.0, 0.0, 0.0);
  stage.Renderer->AddActor(actor);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  stage.Camera()->SetPosition(0.3, 0.4, 2.5);
  stage.Camera()->SetClippingRange(1.0, 4.0);
  vtkNew<AOPass> pass;
  for (int modulation = AOPass::Ambient; modulation <= AOPass::All; ++modulation)
  {
    pass->SetModulation(modulation);
    ForceVisibility(pass, 0.0);
    const std::string name = "edges, modulation " + std::to_string(modulation);
    const Picture plain = stage.Draw(nullptr);
    report.Differ(
      name + ", are there", plain, Picture::Of([](float) { return 0.0; }, plain), 0.2, 1000);
    // A step for rounding, at the soft borders of the edges.
    report.Same(name, plain, stage.Draw(pass), 1.0 * Step);
  }
}

//------------------------------------------------------------------------------
// A plate over the spheres in three blocks: one hidden, one of glass, one shown far away.
void AddBlocksOfNoEffect(vtkRenderer* renderer)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkNew<vtkPlaneSource> plate;
    const double z = i < 2 ? 0.6 : -50.0;
    plate->SetOrigin(-0.5, -0.5, z);
    plate->SetPoint1(3.0, -0.5, z);
    plate->SetPoint2(-0.5, 3.0, z);
    plate->Update();
    blocks->SetBlock(i, plate->GetOutput());
  }
  vtkNew<vtkSSAOTestCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockVisibility(1, false);
  mapper->SetBlockOpacity(2, 0.4);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
// What is no opaque lit surface, or is hidden, changes V nowhere.
void CheckCastsNothing(Report& report)
{
  const std::pair<const char*, std::function<void(vtkRenderer*)>> kinds[] = {
    { "glass",
      [](vtkRenderer* renderer)
      {
        Grid grid(3);
        AddTranslucentProps(renderer, grid);
      } },
    { "volume",
      [](vtkRenderer* renderer)
      {
        Grid grid(3);
        AddVolume(renderer, grid);
      } },
    { "annotations",
      [](vtkRenderer* renderer)
      {
        Grid grid(3);
        AddAnnotations(renderer, grid);
      } },
    { "hidden actor",
      [](vtkRenderer* renderer)
      {
        vtkSmartPointer<vtkActor> actor = MakeActor(MakeSphere(1.0));
        actor->VisibilityOff();
        renderer->AddActor(actor);
      } },
    { "blocks that are hidden, of glass or far away", AddBlocksOfNoEffect },
  };
  for (int preset = 0; preset < 3; ++preset)
  {
    vtkNew<AOPass> pass;
    preset == 0 ? pass->SetQualityToFast()
                : (preset == 1 ? pass->SetQualityToBalanced() : pass->SetQualityToAccurate());
    pass->SetRadius(0.7);
    pass->SetOutputModeToOcclusion();
    const auto draw = [&](const std::function<void(vtkRenderer*)>& add)
    {
      Stage stage(report, 160, 120);
      AddLitScene(stage);
      Grid(4).Look(stage.Renderer);
      stage.Camera()->SetFocalPoint(1.5, 1.5, 0.0);
      if (add)
      {
        add(stage.Renderer);
      }
      const Picture picture = stage.Draw(pass);
      stage.Renderer->SetPass(nullptr);
      pass->ReleaseGraphicsResources(stage.Window);
      return picture;
    };
    const Picture alone = draw(nullptr);
    const std::string name = "V, preset " + std::to_string(preset) + ", ";
    report.Differ(
      name + "there is occlusion", alone, Picture::Of([](float) { return 1.0; }, alone), 0.1, 2000);
    // A plate that is there does change it.
    report.Differ(name + "a plate", alone,
      draw(
        [](vtkRenderer* renderer)
        {
          AddBlocksOfNoEffect(renderer);
          auto* actor = vtkActor::SafeDownCast(renderer->GetViewProps()->GetLastProp());
          vtkSSAOTestCompositeMapper::SafeDownCast(actor->GetMapper())->RemoveBlockVisibility(1);
        }),
      0.1, 1000);
    for (const auto& kind : kinds)
    {
      report.Same(name + kind.first, alone, draw(kind.second), 0.0);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestHarmlessProps(int, char*[])
{
  Report report;
  CheckCastsNothing(report);
  CheckOthers(report, 0, false);
  CheckOthers(report, 0, true);
  CheckOthers(report, 4, true);
  CheckOtherLight(report);
  CheckEdges(report);
  return report.GetResult();
}
