// SPDX-License-Identifier: BSD-3-Clause

// Samples outside the picture say nothing: where a crease runs out of the picture its shade does
// not change, and an open plane is not darkened at the border.

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestPictureBorder(int, char*[])
{
  vtkSSAOTestMonitor test;
  {
    vtkSSAOTestView view(test, 120, 120);
    vtkSSAOAddCorner(view);
    vtkSSAOLookAtCorner(view, true);
    view.Pass->SetRadius(2.0); // 30 pixels
    view.Pass->SetBias(0.02);  // deep shade
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const vtkSSAOTestImage v = view.Visibility();
      // Within the radius of the crease.
      const auto mean = [&](int from, int to)
      {
        return vtkSSAOMeasure(
          v, [=](int x, int y) { return x >= from && x < to && std::abs(y - 60) < 5; })
          .Mean;
      };
      const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) + ": ";
      const double middle = mean(44, 76);
      test.ExpectAtMost(middle, 0.93, what + "V at the crease in the middle");
      // What lies beyond the border is not known; counting it as open would give +.1 in all
      // presets.
      test.ExpectNear(mean(0, 8), middle, 0.03, what + "V at the left border");
      test.ExpectNear(mean(112, 120), middle, 0.03, what + "V at the right border");
    }
  }
  {
    vtkSSAOTestView view(test, 120, 120);
    vtkSSAOAddFloor(view);
    view.LookParallel({ 0, 10, 10 }, { 0, 0, 0 }, { 0, 1, 0 }, 4.0);
    view.Pass->SetRadius(2.0);
    const vtkSSAOTestImage v = view.Visibility();
    const vtkSSAOStatistics border =
      vtkSSAOMeasure(v, [](int x, int y) { return x < 3 || y < 3 || x >= 117 || y >= 117; });
    test.ExpectAtLeast(border.Minimum, 0.995, "smallest V at the border of an open plane");
  }
  return test.GetResult();
}
