// SPDX-License-Identifier: BSD-3-Clause

// The controls at both ends of their range: V stays a number from 0 to 1, and the larger the
// radius, the darker the picture.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
double BadPixels(const vtkSSAOTestImage& v)
{
  return vtkSSAOMeasure(
    v, [&](int x, int y) { return !(v.At(x, y) >= 0.0F && v.At(x, y) <= 1.0F); })
    .Count;
}

//------------------------------------------------------------------------------
// From a tenth of a pixel to three times the scene, and far beyond in both directions.
void TestRadius(vtkSSAOTestMonitor& test)
{
  vtkSSAOStability rise(test, "Radius from below a pixel to beyond the scene",
    "largest rise of the mean V", vtkSSAOStability::AtMost,
    4.5e-6); // a sector of one side, 1/60 of V, of one estimated pixel, which stands for four of
             // 15,000
  vtkSSAOStability bad(
    test, "Radius 1e-30 to 1e30", "pixels with V not from 0 to 1", vtkSSAOStability::AtMost, 0.0);
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  for (bool parallel : { false, true })
  {
    vtkSSAOLookAtStillLife(view, parallel);
    for (int method = 0; method <= vtkSSAOTestView::NumberOfPresets; ++method)
    {
      const bool ours = method < vtkSSAOTestView::NumberOfPresets;
      double before = 1.0;
      for (double radius :
        { 1.0e-30, 1.0e-9, 0.0025, 0.02, 0.06, 0.2, 0.6, 2.0, 6.0, 40.0, 1.0e9, 1.0e30 })
      {
        std::ostringstream what;
        what << (parallel ? "parallel" : "perspective") << ", radius " << radius;
        if (ours)
        {
          view.SetPreset(method);
          view.Pass->SetRadius(radius);
          const vtkSSAOTestImage v = view.Visibility();
          bad.Ours(method, BadPixels(v), what.str());
          const double mean = view.MeasureSurfaces(v).Mean;
          if (radius <= 40.0)
          {
            rise.Ours(method, std::max(mean - before, 0.0), what.str());
            before = mean;
          }
          if (radius < 0.0001)
          {
            test.ExpectNear(mean, 1.0, 1.0e-7, what.str() + ": mean V");
          }
        }
        else if (radius >= 0.0025 && radius <= 40.0)
        {
          const double mean = view.MeasureSurfaces(view.VisibilityOfVTK(radius)).Mean;
          rise.VTK(std::max(mean - before, 0.0), what.str());
          before = mean;
        }
      }
      if (ours)
      {
        test.ExpectAtMost(before, 0.8, "mean V with a radius larger than the scene");
      }
    }
  }
}

//------------------------------------------------------------------------------
void TestEnds(vtkSSAOTestMonitor& test)
{
  using Pass = vtkScreenSpaceAmbientOcclusionPass;
  const std::vector<std::pair<std::string, std::function<void(Pass*)>>> ends = {
    { "1 direction", [](Pass* pass) { pass->SetDirections(1); } },
    { "64 directions", [](Pass* pass) { pass->SetDirections(64); } },
    { "1 step", [](Pass* pass) { pass->SetSteps(1); } },
    { "64 steps", [](Pass* pass) { pass->SetSteps(64); } },
    { "1 layer", [](Pass* pass) { pass->SetLayers(1); } },
    { "9 layers", [](Pass* pass) { pass->SetLayers(9); } },
    { "noise size 1", [](Pass* pass) { pass->SetNoiseSize(1); } },
    { "noise size 64", [](Pass* pass) { pass->SetNoiseSize(64); } },
    { "downsampling 1", [](Pass* pass) { pass->SetDownsampling(1); } },
    { "downsampling 4", [](Pass* pass) { pass->SetDownsampling(4); } },
    { "thickness 1e-30", [](Pass* pass) { pass->SetThickness(1.0e-30); } },
    { "thickness 1e30", [](Pass* pass) { pass->SetThickness(1.0e30); } },
    { "kernel size 1", [](Pass* pass) { pass->SetKernelSize(1); } },
    { "kernel size 1024", [](Pass* pass) { pass->SetKernelSize(1024); } },
    { "Hemisphere, kernel size 1",
      [](Pass* pass)
      {
        pass->SetEstimatorToHemisphere();
        pass->SetKernelSize(1);
      } },
    { "Hemisphere, kernel size 1024",
      [](Pass* pass)
      {
        pass->SetEstimatorToHemisphere();
        pass->SetKernelSize(1024);
      } },
    { "Hemisphere, bias 0",
      [](Pass* pass)
      {
        pass->SetEstimatorToHemisphere();
        pass->SetBias(0.0);
      } },
    { "Hemisphere, bias 1e30",
      [](Pass* pass)
      {
        pass->SetEstimatorToHemisphere();
        pass->SetBias(1.0e30);
      } },
  };
  vtkSSAOStability bad(test, "Directions, steps, layers, kernel, noise, bias at both ends",
    "pixels with V not from 0 to 1", vtkSSAOStability::AtMost, 0.0);
  for (const auto& end : ends)
  {
    vtkSSAOTestView view(test, 60, 40);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, false);
    view.Pass->SetRadius(0.5);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      end.second(view.Pass);
      const vtkSSAOTestImage v = view.Visibility();
      bad.Ours(preset, BadPixels(v), end.first);
      const double smallest = view.MeasureSurfaces(v).Minimum;
      if (end.first == "Hemisphere, bias 1e30")
      {
        test.ExpectEqual(smallest, 1.0, "smallest V under a huge bias");
      }
      else if (end.first == "64 directions" || end.first == "64 steps" || end.first == "9 layers")
      {
        test.ExpectAtMost(smallest, 0.8, end.first + ": smallest V");
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableControls(int, char*[])
{
  vtkSSAOTestMonitor test;
  TestRadius(test);
  TestEnds(test);
  return test.GetResult();
}
