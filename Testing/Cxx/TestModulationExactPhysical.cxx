// SPDX-License-Identifier: BSD-3-Clause

// With the visibility forced to v, every pixel of a physically based prop is C - (1 - v) O in
// linear light, before clamping: O is the image-based light (Ambient), that and the direct Lambert
// light (AmbientAndDiffuse), or, in the picture's own encoding, C (All).
//
// O is found without the pass, from VTK's plain rendering in float: image-based light is what is
// lost without the environment, direct Lambert light is what is lost with black base colour where
// nothing is metallic. For a half metallic plane it is in closed form.

#include "vtkSSAOTestProps.h"

#include "vtkPlaneSource.h"

namespace
{
using namespace vtkSSAOTest;

// One step for the rounding of the picture before and one for that of what is subtracted.
constexpr double Tolerance = 2.0 * Step;

//------------------------------------------------------------------------------
// VTK's encoding of linear light.
double Encode(double linear)
{
  return std::pow(std::max(linear, 0.0), 1.0 / 2.2);
}

double Decode(double encoded)
{
  return std::pow(encoded, 2.2);
}

//------------------------------------------------------------------------------
// The renderer's picture in linear light, before clamping.
Picture DrawLinear(Stage& stage)
{
  return Picture::Of([](float encoded) { return Decode(encoded); }, stage.DrawUnclamped());
}

//------------------------------------------------------------------------------
Picture Expected(
  const Picture& whole, const Picture& ambient, const Picture& diffuse, int modulation, double v)
{
  return Picture::Of(
    [=](float c, float a, float d)
    {
      if (modulation == AOPass::All)
      {
        return std::min(v * Encode(c), 1.0);
      }
      const double part = a + (modulation == AOPass::AmbientAndDiffuse ? d : 0.0);
      return std::min(Encode(c - (1.0 - v) * part), 1.0);
    },
    whole, ambient, diffuse);
}

//------------------------------------------------------------------------------
void Check(Report& report, Stage& stage, const std::string& name, const Picture& whole,
  const Picture& ambient, const Picture& diffuse)
{
  const char* const names[] = { ", Ambient", ", AmbientAndDiffuse", ", All" };
  vtkNew<AOPass> pass;
  for (int modulation = AOPass::Ambient; modulation <= AOPass::All; ++modulation)
  {
    pass->SetModulation(modulation);
    for (const double v : { 0.0, 0.25, 0.5, 0.9 })
    {
      ForceVisibility(pass, v);
      report.Same(name + names[modulation] + ", V " + std::to_string(v),
        Expected(whole, ambient, diffuse, modulation, v), stage.Draw(pass), Tolerance);
    }
  }
}

//------------------------------------------------------------------------------
// Base colour black wherever it is not that of a metal.
void SetBlack(const std::vector<vtkSmartPointer<vtkActor>>& actors, bool black)
{
  for (vtkActor* actor : actors)
  {
    vtkProperty* property = actor->GetProperty();
    if (property->GetMetallic() == 0.0)
    {
      property->SetColor(black ? 0.0 : 0.8, black ? 0.0 : 0.5, black ? 0.0 : 0.3);
    }
    if (vtkDataSet* data = actor->GetMapper()->GetInput())
    {
      actor->GetMapper()->SetScalarVisibility(!black && data->GetPointData()->GetScalars());
    }
    // The glyph mapper keeps colours of its own.
    actor->GetMapper()->Modified();
  }
}

//------------------------------------------------------------------------------
// Many materials, with and without environment, under several kinds of lights.
void CheckMaterials(Report& report)
{
  Stage stage(report, 260, 140);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  SetEnvironment(stage.Renderer);
  Grid grid(5);
  const std::vector<vtkSmartPointer<vtkActor>> actors = AddPhysicalActors(stage.Renderer, grid);
  grid.Look(stage.Renderer);

  const struct
  {
    const char* Name;
    std::function<void()> Set;
    bool AlsoAlone; // also without the environment
  } lights[] = {
    { "headlight", [&] { SetHeadlight(stage.Renderer, 4.0); }, true },
    { "distant lights", [&] { SetDistantLights(stage.Renderer); }, false },
    { "positional lights", [&] { SetBrightLights(stage.Renderer); }, false },
  };
  for (const auto& light : lights)
  {
    light.Set();
    stage.Renderer->UseImageBasedLightingOff();
    const Picture direct = DrawLinear(stage);
    SetBlack(actors, true);
    const Picture specular = DrawLinear(stage);
    SetBlack(actors, false);
    const auto without = [](float a, float b) { return a - b; };
    const Picture none = Picture::Of(without, direct, direct);
    const Picture diffuse = Picture::Of(without, direct, specular);
    if (light.AlsoAlone)
    {
      Check(report, stage, light.Name, direct, none, diffuse);
    }

    stage.Renderer->UseImageBasedLightingOn();
    const Picture whole = DrawLinear(stage);
    const Picture ambient = Picture::Of(without, whole, direct);
    report.Differ(
      std::string(light.Name) + ", the environment gives light", whole, direct, 0.05, 3000);
    report.Differ(std::string(light.Name) + ", Lambert light", diffuse, none, 0.01, 2500);
    Check(report, stage, std::string(light.Name) + " and environment", whole, ambient, diffuse);
  }
}

//------------------------------------------------------------------------------
// Half metallic, seen and lit head on in parallel projection: N.V is 1 at the middle.
void CheckMetallicPlane(Report& report)
{
  Stage stage(report, 60, 60);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  SetHeadlight(stage.Renderer, 2.0);
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  vtkSmartPointer<vtkActor> actor = MakeActor(plane->GetOutput());
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPBR();
  const double albedo[3] = { 0.9, 0.5, 0.2 };
  const double metallic = 0.5;
  property->SetColor(albedo[0], albedo[1], albedo[2]);
  property->SetMetallic(metallic);
  property->SetRoughness(0.6);
  stage.Renderer->AddActor(actor);
  // So far away that all rays are parallel to six digits.
  stage.Camera()->SetPosition(0.0, 0.0, 1000.0);
  stage.Camera()->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Camera()->SetParallelProjection(1);
  stage.Camera()->SetParallelScale(0.4);
  stage.Camera()->SetClippingRange(999.0, 1001.0);

  const Picture whole = DrawLinear(stage);
  const Picture none = Picture::Of([](float a) { return 0.0F * a; }, whole);
  Picture diffuse = none;
  for (std::size_t i = 0; i < diffuse.Values.size(); ++i)
  {
    // Index of refraction 1.5; the half vector is the light's direction, so F is F0.
    const double a = albedo[i % 3];
    const double f0 = (1.0 - metallic) * 0.04 + metallic * a;
    diffuse.Values[i] =
      static_cast<float>(2.0 * (1.0 - metallic) * (1.0 - f0) * a / (4.0 * std::atan(1.0)));
  }
  Check(report, stage, "half metallic plane", whole, none, diffuse);
}
}

//------------------------------------------------------------------------------
int TestModulationExactPhysical(int, char*[])
{
  Report report;
  CheckMaterials(report);
  CheckMetallicPlane(report);
  return report.GetResult();
}
