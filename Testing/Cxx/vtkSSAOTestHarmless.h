// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The check that the pass does no harm to a scene, beside VTK's own pass, and the line it prints
 * for the table in Testing/README.md.
 */

#ifndef vtkSSAOTestHarmless_h
#define vtkSSAOTestHarmless_h

#include "vtkSSAOTestScenes.h"

#include "vtkSSAOPass.h"
#include "vtkSSAOTestShapes.h"

#include <iostream>

namespace vtkSSAOTest
{
//------------------------------------------------------------------------------
/// Adds the props of a case to a stage.
using BuildFunction = std::function<void(Stage&)>;

/// Draws a stage with a pass; nullptr: without.
using DrawFunction = std::function<Picture(Stage&, vtkRenderPass*)>;

struct HarmlessOptions
{
  int Width = 160;
  int Height = 120;
  int MultiSamples = 0;
  bool Floor = true;        ///< with a floor and spheres
  bool OnlySurfaces = true; ///< check with V 0 that nothing but lit opaque surfaces changes
  bool BesideVTK = true;    ///< draw the same with VTK's own pass, for the table
  bool Quiet = false;       ///< VTK's messages do not count: it has them without any pass too
  bool FirstFrame = true;   ///< in a window that was never drawn without the pass, too
  int Changed = 20;         ///< so many pixels at least must show that the case is there
  DrawFunction Draw = [](Stage& stage, vtkRenderPass* pass) { return stage.Draw(pass); };
};

//------------------------------------------------------------------------------
/// Largest difference of two pictures in 1/255, -1 for different sizes.
inline int LargestDifference(const Picture& a, const Picture& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return -1;
  }
  double largest = 0.0;
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      largest = std::max(largest, DifferenceAt(a, b, x, y));
    }
  }
  return static_cast<int>(std::lround(255.0 * largest));
}

//------------------------------------------------------------------------------
/// A line of the table: what the pass and VTK's own change in the picture, in 1/255.
inline void PrintRow(const std::string& name, const std::string& ours, const std::string& vtks)
{
  std::cout << "NO HARM | " << name << " | " << ours << " | " << vtks << " |" << std::endl;
}

//------------------------------------------------------------------------------
/// VTK's own pass with no effect: nothing lies in front of a sample by so much.
inline vtkSmartPointer<vtkSSAOPass> MakeVTKPass()
{
  auto pass = vtkSmartPointer<vtkSSAOPass>::New();
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  pass->SetRadius(0.5);
  pass->SetBias(1.0e6);
  pass->SetKernelSize(8);
  return pass;
}

//------------------------------------------------------------------------------
/// Intensity 0, and all stages with V 1, give the picture without the pass; with V 0 nothing but
/// lit opaque surfaces changes.
inline void CheckHarmless(Report& report, const std::string& name, const BuildFunction& build,
  const HarmlessOptions& options = HarmlessOptions())
{
  vtkNew<vtkProperty> lit;
  lit->SetAmbient(0.2);
  lit->SetColor(0.9, 0.8, 0.7);
  const auto prepare = [&](Stage& stage)
  {
    if (options.Floor)
    {
      vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45, lit);
    }
    build(stage);
  };

  int ours = 0;
  report.SetListening(!options.Quiet);
  {
    Stage stage(report, options.Width, options.Height, options.MultiSamples);
    prepare(stage);
    const Picture plain = options.Draw(stage, nullptr);
    if (options.Changed > 0)
    {
      Stage bare(report, options.Width, options.Height, options.MultiSamples);
      if (options.Floor)
      {
        vtkSSAOAddFloorAndSpheres(bare.Renderer, 6, 0.45, lit);
      }
      report.Differ(name + ", is there", options.Draw(bare, nullptr), plain, 0.1, options.Changed);
    }
    vtkNew<AOPass> pass;
    pass->SetIntensity(0.0);
    const Picture zero = options.Draw(stage, pass);
    pass->SetIntensity(1.0);
    ForceVisibility(pass, 1.0);
    const Picture open = options.Draw(stage, pass);
    // The contract.
    report.Same(name + ", Intensity 0", plain, zero, 1.0 * Step);
    report.Same(name + ", V 1", plain, open, 1.0 * Step);
    ours = std::max(LargestDifference(plain, zero), LargestDifference(plain, open));
    if (options.FirstFrame)
    {
      // VTK sets up much of its own when it draws first, so the pass is there from the first frame.
      Stage fresh(report, options.Width, options.Height, options.MultiSamples);
      prepare(fresh);
      vtkNew<AOPass> first;
      ForceVisibility(first, 1.0);
      const Picture fromStart = options.Draw(fresh, first);
      report.Same(name + ", V 1 from the first frame", plain, fromStart, 1.0 * Step);
      ours = std::max(ours, LargestDifference(plain, fromStart));
      fresh.Renderer->SetPass(nullptr);
      first->ReleaseGraphicsResources(fresh.Window);
    }

    if (options.OnlySurfaces && options.Floor)
    {
      // A pixel that shows no lit surface is one that does not depend on the surfaces' colours.
      lit->SetColor(0.1, 0.2, 0.9);
      const Picture recoloured = options.Draw(stage, nullptr);
      lit->SetColor(0.9, 0.8, 0.7);
      const Mask others = [&](int x, int y)
      { return DifferenceAt(plain, recoloured, x, y) == 0.0; };
      const Mask surfaces = [&](int x, int y) { return !others(x, y); };
      pass->SetModulationToAll();
      ForceVisibility(pass, 0.0);
      const Picture dark = options.Draw(stage, pass);
      report.Same(name + ", V 0, others", plain, dark, 0.0, others, 100);
      report.Differ(name + ", V 0, surfaces", plain, dark, 0.1, 500, surfaces);
    }
    report.Same(name + ", without the pass again", plain, options.Draw(stage, nullptr), 0.0);
    pass->ReleaseGraphicsResources(stage.Window);
  }

  std::string vtks = "-";
  report.SetListening(false);
  if (options.BesideVTK)
  {
    Stage stage(report, options.Width, options.Height, options.MultiSamples);
    prepare(stage);
    const Picture plain = options.Draw(stage, nullptr);
    vtkSmartPointer<vtkSSAOPass> pass = MakeVTKPass();
    vtks = std::to_string(LargestDifference(plain, options.Draw(stage, pass)));
    stage.Renderer->SetPass(nullptr);
    pass->ReleaseGraphicsResources(stage.Window);
  }
  report.SetListening(true);
  PrintRow(name, std::to_string(ours), vtks);
}
}

#endif
