// SPDX-License-Identifier: BSD-3-Clause

// With the visibility forced to v, every pixel of a lit prop is C - (1 - v) O, per channel and
// before clamping. C and O are found without the pass: VTK's plain rendering in float of the same
// scene with the ambient, the diffuse or the specular light of all materials only.

#include "vtkSSAOTestProps.h"

namespace
{
using namespace vtkSSAOTest;

// One step for the rounding of the picture before and one for that of what is subtracted.
constexpr double Tolerance = 2.0 * Step;

//------------------------------------------------------------------------------
// The parts of the light, before clamping.
struct Light
{
  Picture Whole;
  Picture Ambient;
  Picture Diffuse;

  Light(Stage& stage, LightParts& parts, Report& report, const std::string& name)
  {
    parts.Show(true, false, false);
    this->Ambient = stage.DrawUnclamped();
    parts.Show(false, true, false);
    this->Diffuse = stage.DrawUnclamped();
    parts.Show(false, false, true);
    const Picture specular = stage.DrawUnclamped();
    parts.Show(true, true, true);
    this->Whole = stage.DrawUnclamped();
    const Picture sum = Picture::Of(
      [](float a, float d, float s) { return a + d + s; }, this->Ambient, this->Diffuse, specular);
    // The reference agrees with itself: light is additive. Single precision.
    report.Same(name + ", parts add up to the whole", this->Whole, sum, 1.0e-4);
  }

  Picture Expected(int modulation, double v) const
  {
    const bool all = modulation == AOPass::All;
    const bool diffuse = modulation == AOPass::AmbientAndDiffuse;
    return Picture::Of(
      [=](float whole, float a, float d)
      {
        const double part = all ? whole : a + (diffuse ? d : 0.0);
        return std::min(std::max(whole - (1.0 - v) * part, 0.0), 1.0);
      },
      this->Whole, this->Ambient, this->Diffuse);
  }
};

const char* const ModulationNames[] = { "Ambient", "AmbientAndDiffuse", "All" };
}

//------------------------------------------------------------------------------
int TestModulationExact(int, char*[])
{
  Report report;
  Stage stage(report, 300, 210);
  LightParts parts;
  Grid grid(6);
  AddLitProps(stage.Renderer, grid, parts);
  // Black, so that the background is no part of the reference.
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  grid.Look(stage.Renderer);

  vtkNew<AOPass> pass;
  const struct
  {
    const char* Name;
    std::function<void()> Set;
    bool Overbright;
  } lights[] = {
    { "headlight", [&] { SetHeadlight(stage.Renderer, 1.2); }, true },
    { "distant lights", [&] { SetDistantLights(stage.Renderer); }, false },
    { "positional lights", [&] { SetBrightLights(stage.Renderer); }, true },
  };
  for (const auto& light : lights)
  {
    light.Set();
    const Light reference(stage, parts, report, light.Name);
    const Picture plain = reference.Expected(AOPass::Ambient, 1.0);
    if (light.Overbright)
    {
      report.Differ(std::string(light.Name) + ", the picture is clamped", plain, reference.Whole,
        20.0 * Step, 100);
    }
    for (int modulation = AOPass::Ambient; modulation <= AOPass::All; ++modulation)
    {
      pass->SetModulation(modulation);
      const std::string name = std::string(light.Name) + ", " + ModulationNames[modulation];
      // The reference itself is far from the plain picture.
      report.Differ(name + ", V 0, is dark", plain, reference.Expected(modulation, 0.0), 0.1, 8000);
      for (const double v : { 0.0, 0.25, 0.5, 0.9 })
      {
        ForceVisibility(pass, v);
        report.Same(name + ", V " + std::to_string(v), reference.Expected(modulation, v),
          stage.Draw(pass), Tolerance);
      }
    }
  }
  return report.GetResult();
}
