// SPDX-License-Identifier: BSD-3-Clause

// An open floor stays open from any distance: 10 to 20,000 radii away, with a lens that keeps the
// framing.

#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
int TestStableTelephoto(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(test, "Camera 10 R to 20,000 R away, same framing",
    "mean V of an open floor", vtkSSAOStability::AtLeast, 0.998);
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddFloor(view);
  view.Pass->SetRadius(1.0);
  const double degree = std::acos(-1.0) / 180.0;
  for (double elevation : { 60.0, 30.0 })
  {
    for (double distance : { 10.0, 100.0, 2000.0, 20000.0 })
    {
      view.Look(
        { 0.0, distance * std::sin(elevation * degree), distance * std::cos(elevation * degree) },
        { 0, 0, 0 }, { 0, 1, 0 }, 2.0 * std::atan(3.0 / distance) / degree);
      std::ostringstream what;
      what << elevation << " degrees, " << distance << " R";
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
        row.Ours(preset, v.Mean, what.str());
        // At 20,000 R float32 tells depths in steps of a thirtieth of a pixel's width.
        test.ExpectAtLeast(v.Minimum, 0.998, what.str() + ": smallest V");
        test.ExpectAtLeast(v.Count, 5000, what.str() + ": pixels of the floor");
      }
      row.VTK(view.MeasureSurfaces(view.VisibilityOfVTK(1.0)).Mean, what.str());
    }
  }
  return test.GetResult();
}
