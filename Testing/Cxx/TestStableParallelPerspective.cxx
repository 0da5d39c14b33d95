// SPDX-License-Identifier: BSD-3-Clause

// Parallel projection is the limit of a narrow perspective: either is as near to its own ray-traced
// truth as the other.

#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestTruth.h"
#include "vtkSSAOTestView.h"

#include <array>
#include <cmath>
#include <vector>

//------------------------------------------------------------------------------
int TestStableParallelPerspective(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(test, "Parallel against perspective of 1 degree",
    "difference of the RMSE against each one's truth", vtkSSAOStability::AtMost, 0.005);
  vtkSSAOTestView view(test, 200, 150);
  vtkSSAOAddStillLife(view);
  view.Pass->SetRadius(0.5);
  std::vector<std::array<double, 4>> errors; // of the presets and of VTK's pass
  for (bool parallel : { true, false })
  {
    const double height = 1.3; // half of it
    const std::vector<double> at = { -0.1, 0.5, 0.0 };
    const std::vector<double> direction = { 0.25, 0.4, 0.8818 };
    const double away = height / std::tan(0.5 * std::acos(-1.0) / 180.0);
    const std::vector<double> from = { at[0] + away * direction[0], at[1] + away * direction[1],
      at[2] + away * direction[2] };
    if (parallel)
    {
      view.LookParallel(from, at, { 0, 1, 0 }, height);
    }
    else
    {
      view.Look(from, at, { 0, 1, 0 }, 1.0);
    }
    const vtkSSAOTruthImage truth = vtkSSAOTest::TraceTruth(view, 0.5, 64);
    errors.emplace_back();
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      errors.back()[preset] = vtkSSAOTest::ErrorAgainst(truth, view.Visibility());
      // Something is there to be wrong about, and is about right.
      test.ExpectAtMost(errors.back()[preset], 0.15,
        std::string(vtkSSAOTestView::GetPresetName(preset)) + ": RMSE against the truth");
    }
    errors.back()[3] = vtkSSAOTest::ErrorAgainst(truth, view.VisibilityOfVTK(0.5));
  }
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    row.Ours(preset, std::abs(errors[0][preset] - errors[1][preset]), "still life");
  }
  row.VTK(std::abs(errors[0][3] - errors[1][3]), "still life");
  return test.GetResult();
}
