// SPDX-License-Identifier: BSD-3-Clause

// Estimator ExactHorizon: its twin, its properties, and V of corners against rays.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestBoxes.h"

#include <sstream>

//------------------------------------------------------------------------------
int TestEstimatorExactHorizon(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetQualityToFast();
    pass->SetEstimatorToExactHorizon();
  };
  const auto many = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToExactHorizon();
    pass->SetDownsampling(1);
    pass->SetDirections(16);
    pass->SetSteps(24);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "ExactHorizon");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->SetDirections(5);
      pass->SetSteps(9);
      pass->SetNoiseSize(5);
    },
    "ExactHorizon 5x9");
  // V of an open surface is 1 exactly.
  vtkSSAOTest::ExpectProperties(test, setUp, 1.0, 0.0, 0.1, "ExactHorizon");
  vtkSSAOTest::ExpectProperties(test, many, 1.0, 0.0, 0.1, "ExactHorizon 16x24");

  // Before a wall nothing is hidden behind the horizon that is not solid: the method is exact but
  // for its samples.
  for (double height : { 0.3, 1.0, 3.0 })
  {
    vtkSSAOTestView view(test, 300, 240);
    vtkSSAOAddFloor(view);
    const std::vector<vtkSSAOTest::Box> wall = { { -20.0, 20.0, 0.0, height, -1.0, 0.0 } };
    vtkSSAOTest::AddBox(view, wall[0]);
    view.Look({ 0.0, 6.0, 6.0 }, { 0.0, 0.3, 0.6 }, { 0, 1, 0 });
    view.Pass->SetRadius(1.2);
    many(view.Pass);
    std::ostringstream what;
    what << "Floor before a wall of height " << height << ": ";
    const vtkSSAOTest::ErrorOfV error = vtkSSAOTest::ErrorAlongFloor(view, wall, 0.06, 1.5, 1.2);
    test.ExpectAtLeast(error.Points, 12, what.str() + "points");
    // 24 samples are on average 1/48 of the radius short of the wall, and so is the horizon of the
    // ball's edge on it.
    test.ExpectAtMost(error.Largest, 0.03, what.str() + "largest difference of V from rays");
    test.ExpectNear(error.Bias, 0.0, 0.015, what.str() + "mean difference of V from rays");
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const vtkSSAOTest::ErrorOfV ofPreset =
        vtkSSAOTest::ErrorAlongFloor(view, wall, 0.06, 1.5, 1.2);
      // Besides the samples, 6 or 8 a side, the denoiser takes the mean over 6 or 8 pixels, in
      // which V changes by up to .1 next to the lowest wall.
      const double largest[] = { 0.1, 0.1, 0.06 };
      test.ExpectAtMost(ofPreset.Largest, largest[preset],
        what.str() + vtkSSAOTestView::GetPresetName(preset) +
          ", largest difference of V from rays");
    }
  }

  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOShowOcclusionOfStillLife(view);
  many(view.Pass);
  view.Pass->SetNoiseSize(1);
  // A sample that another rounding puts on another texel moves one of 32 horizons.
  images.Compare(view.Picture(), { 1, 0.002, 6 });
  return test.GetResult();
}
