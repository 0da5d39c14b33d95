// SPDX-License-Identifier: BSD-3-Clause

// Under multisampling, too, every pixel of a lit prop is C - (1 - v) O. C and O are found without
// the pass, from VTK's plain multisampled pictures of the parts of the light; nothing exceeds 1
// here, so light is additive in every sample, at the silhouettes as well.
//
// Silhouettes are compared by their mean, because VTK extrapolates colours and normals to the
// middle of a pixel that a triangle covers in part: there a part of the light may be negative or
// exceed 1, and the parts' pictures are clamped.

#include "vtkSSAOTestProps.h"

namespace
{
using namespace vtkSSAOTest;
}

//------------------------------------------------------------------------------
int TestModulationMultiSamples(int, char*[])
{
  Report report;
  Stage stage(report, 300, 210, 4);
  LightParts parts;
  Grid grid(6);
  AddLitProps(stage.Renderer, grid, parts);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  grid.Look(stage.Renderer);
  // Dim enough for the brightest material.
  SetHeadlight(stage.Renderer, 0.3);
  const Picture whole = stage.Draw(nullptr);
  parts.Show(true, false, false);
  const Picture ambient = stage.Draw(nullptr);
  parts.Show(false, true, false);
  const Picture diffuse = stage.Draw(nullptr);
  parts.Show(true, true, true);

  stage.Window->SetMultiSamples(0);
  const Picture aliased = stage.Draw(nullptr);
  stage.Window->SetMultiSamples(4);
  report.Differ("the window antialiases", whole, aliased, 0.1, 500);

  vtkNew<AOPass> pass;
  for (int modulation = AOPass::Ambient; modulation <= AOPass::All; ++modulation)
  {
    pass->SetModulation(modulation);
    for (const double v : { 0.0, 0.5 })
    {
      ForceVisibility(pass, v);
      const Picture expected = Picture::Of(
        [=](float c, float a, float d)
        {
          const double part =
            modulation == AOPass::All ? c : a + (modulation == AOPass::AmbientAndDiffuse ? d : 0.0);
          return std::max(c - (1.0 - v) * part, 0.0);
        },
        whole, ambient, diffuse);
      const std::string name =
        "modulation " + std::to_string(modulation) + ", V " + std::to_string(v);
      const Picture actual = stage.Draw(pass);
      // Half a step each for the three pictures behind the expected one and for this one.
      report.Same(
        name + ", inside", expected, actual, 2.0 * Step, UntouchedPixels(whole, aliased), 20000);
      double difference = 0.0;
      int silhouette = 0;
      for (int y = 0; y < whole.Height; ++y)
      {
        for (int x = 0; x < whole.Width; ++x)
        {
          const bool edge = DifferenceAt(whole, aliased, x, y) > 0.1;
          difference += edge ? DifferenceAt(expected, actual, x, y) : 0.0;
          silhouette += edge ? 1 : 0;
        }
      }
      report.ExpectAtLeast(silhouette, 500, name + ", pixels of silhouettes");
      // As much as two pictures of random rounding differ.
      report.ExpectAtMost(
        difference / silhouette, 1.0 * Step, name + ", mean difference at silhouettes");
    }
  }
  ForceVisibility(pass, 1.0);
  report.Same("V 1", whole, stage.Draw(pass), 0.0);
  return report.GetResult();
}
