// SPDX-License-Identifier: BSD-3-Clause

// Picture in picture, and several windows that take turns, each with a pass.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// A second renderer in a corner of the first, on its layer or on one above.
void CheckPictureInPicture(Report& report, int multiSamples, bool layer)
{
  constexpr int width = 160;
  constexpr int height = 120;
  const auto setInner = [](vtkRenderer* renderer)
  {
    vtkSSAOAddFloorAndSpheres(renderer, 4, 0.6);
    renderer->GetActiveCamera()->SetPosition(-1.0, 2.0, 7.0);
    renderer->SetBackground(0.5, 0.1, 0.1);
  };
  Stage both(report, width, height, multiSamples);
  vtkSSAOAddFloorAndSpheres(both.Renderer, 9, 0.5);
  vtkNew<vtkRenderer> inner;
  setInner(inner);
  inner->SetViewport(0.55, 0.5, 0.95, 0.9);
  both.Window->AddRenderer(inner);
  if (layer)
  {
    both.Window->SetNumberOfLayers(2);
    inner->SetLayer(1);
  }
  Stage outerAlone(report, width, height, multiSamples);
  vtkSSAOAddFloorAndSpheres(outerAlone.Renderer, 9, 0.5);
  Stage innerAlone(report, 64, 48, multiSamples);
  setInner(innerAlone.Renderer);

  const std::string name = std::string("picture in picture, ") + (layer ? "layer, " : "") +
    std::to_string(multiSamples) + " samples";
  const Mask inside = [](int x, int y) { return x >= 88 && x < 152 && y >= 60 && y < 108; };
  const Mask outside = [&](int x, int y) { return !inside(x, y); };
  vtkNew<AOPass> outerPass;
  vtkNew<AOPass> innerPass;
  const Picture plain = both.Draw(nullptr);
  inner->SetPass(innerPass);
  const Picture shown = both.Draw(outerPass);
  const Picture outerPicture = outerAlone.Draw(vtkNew<AOPass>());
  const Picture innerPicture = innerAlone.Draw(vtkNew<AOPass>());
  report.Same(name + ", outer as alone", outerPicture, shown, 0.0, outside, 10000);
  if (!layer) // a layer above does not clear what is below
  {
    // Window positions differ in their last bits, which rounding of depth to a pixel may show.
    report.Same(name + ", inner as alone", innerPicture, shown.Part(88, 60, 64, 48), 1.0 * Step);
  }
  report.Differ(name + ", there is occlusion inside", plain, shown, 0.1, 50, inside);
  report.Differ(name + ", there is occlusion outside", plain, shown, 0.1, 50, outside);
  ForceVisibility(outerPass, 1.0);
  ForceVisibility(innerPass, 1.0);
  const Picture open = both.Draw(outerPass);
  report.Same(name + ", V 1", plain, open, 1.0 * Step);

  report.SetListening(false);
  vtkSmartPointer<vtkSSAOPass> vtks[2] = { MakeVTKPass(), MakeVTKPass() };
  inner->SetPass(vtks[0]);
  const Picture vtksPicture = both.Draw(vtks[1]);
  inner->SetPass(nullptr);
  both.Renderer->SetPass(nullptr);
  for (vtkSSAOPass* pass : vtks)
  {
    pass->ReleaseGraphicsResources(both.Window);
  }
  report.SetListening(true);
  PrintRow(name, std::to_string(LargestDifference(plain, open)),
    std::to_string(LargestDifference(plain, vtksPicture)));
}

//------------------------------------------------------------------------------
// Three windows of different sizes, scenes and samples.
void CheckWindows(Report& report)
{
  std::vector<std::unique_ptr<Stage>> stages;
  std::vector<vtkSmartPointer<AOPass>> passes;
  std::vector<Picture> first;
  for (int i = 0; i < 3; ++i)
  {
    stages.push_back(std::make_unique<Stage>(report, 80 + 30 * i, 90 - 20 * i, i == 1 ? 4 : 0));
    vtkSSAOAddFloorAndSpheres(stages[i]->Renderer, 3 + 3 * i, 0.5);
    passes.push_back(vtkSmartPointer<AOPass>::New());
    first.push_back(stages[i]->Draw(passes[i]));
  }
  for (int round = 0; round < 4; ++round)
  {
    for (int i : { 2, 0, 1 })
    {
      report.Same("window " + std::to_string(i) + ", round " + std::to_string(round), first[i],
        stages[i]->Draw(passes[i]), 0.0);
    }
  }
  // One window dies, the others go on.
  stages[0]->Renderer->SetPass(nullptr);
  passes[0] = nullptr;
  stages[0] = nullptr;
  for (int i : { 1, 2 })
  {
    report.Same("window " + std::to_string(i) + " after another's death", first[i],
      stages[i]->Draw(passes[i]), 0.0);
  }
}
}

//------------------------------------------------------------------------------
int TestHarmlessWindows(int, char*[])
{
  Report report;
  CheckPictureInPicture(report, 0, false);
  CheckPictureInPicture(report, 4, false);
  CheckPictureInPicture(report, 0, true);
  CheckWindows(report);
  return report.GetResult();
}
