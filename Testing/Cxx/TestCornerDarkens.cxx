// SPDX-License-Identifier: BSD-3-Clause

// Visibility falls steadily towards the crease of a right angle, from 1 beyond the radius to the
// hemisphere's share that the other wall leaves, in any preset, in both projections.

#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <algorithm>

//------------------------------------------------------------------------------
int TestCornerDarkens(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 150, 150);
  vtkSSAOAddCorner(view);
  view.Pass->SetRadius(2.0);

  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    view.SetPreset(preset);
    for (bool parallel : { false, true })
    {
      vtkSSAOLookAtCorner(view, parallel);
      const vtkSSAOTestImage v = view.Visibility();
      // The crease is the horizontal line through the middle; averaged along it, away from the
      // sides of the picture.
      std::vector<double> profile;
      for (int y = 0; y < v.Height; ++y)
      {
        profile.push_back(
          vtkSSAOMeasure(v, [&](int x, int row) { return row == y && x >= 30 && x < 120; }).Mean);
      }
      const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) +
        (parallel ? ", parallel: " : ", perspective: ");
      const int middle = v.Height / 2;
      double rise = 0.0;
      for (int y = 1; y < v.Height; ++y)
      {
        const double towards =
          y < middle ? profile[y] - profile[y - 1] : profile[y - 1] - profile[y];
        if (y != middle)
        {
          rise = std::max(rise, towards);
        }
      }
      // All pixels of a row have the same samples but for 16 rotations; what a step of one pixel
      // changes in them is noise of a fraction of one sample: 1/16 in Fast.
      test.ExpectAtMost(rise, 0.01, what + "largest rise of V towards the crease");
      const double atCrease = std::min(profile[middle - 1], profile[middle]);
      // Half of the points lie behind the other wall. Half of those lie so near that the bias
      // leaves them uncounted (the points of the kernel crowd at its centre); a bias ten times as
      // large would leave all of them.
      test.ExpectAtMost(atCrease, 0.9, what + "V at the crease, below");
      test.ExpectAtLeast(atCrease, 0.5, what + "V at the crease, above");
      test.ExpectAtLeast(std::min(profile.front(), profile.back()), 0.995,
        what + "V farther from the crease than the radius");
      if (parallel)
      {
        // Seen at 45 degrees the radius spans 2 / sqrt(2) / 8 of 150 pixels, 26.5; the denoiser
        // reaches two pixels farther.
        test.ExpectAtLeast(std::min(profile[middle - 31], profile[middle + 30]), 0.9995,
          what + "V just beyond the radius");
        test.ExpectAtMost(std::max(profile[middle - 12], profile[middle + 11]), 0.999,
          what + "V at 45 % of the radius");
      }
      // Both walls are alike, so is their shade; next to the crease each has what was estimated
      // for it within a square of 2 x 2 pixels, and that is not at the same distance.
      double asymmetry = 0.0;
      for (int y = 0; y < middle - view.Pass->GetDownsampling(); ++y)
      {
        asymmetry = std::max(asymmetry, std::abs(profile[y] - profile[v.Height - 1 - y]));
      }
      test.ExpectAtMost(asymmetry, 0.03, what + "difference of the walls");
    }
  }
  return test.GetResult();
}
