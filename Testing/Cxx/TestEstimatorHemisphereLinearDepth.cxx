// SPDX-License-Identifier: BSD-3-Clause

// Estimator HemisphereLinearDepth: its twin, its properties, and the acne that a bias cures.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorHemisphereLinearDepth(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToHemisphereLinearDepth();
    pass->SetKernelSize(64);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "HemisphereLinearDepth");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->RangeCheckOff();
      pass->SetKernelSize(13);
    },
    "HemisphereLinearDepth, range check off");
  // It hides itself.
  vtkSSAOTest::ExpectProperties(test, setUp, 0.9, 0.1, 0.15, "HemisphereLinearDepth");

  // Acne: points of an open floor that lie just above it are hidden by the stored depth of the next
  // pixel, more of them where the floor is steep.
  vtkSSAOTestView view(test, 240, 160);
  vtkSSAOAddFloor(view);
  view.Pass->SetRadius(0.8);
  setUp(view.Pass);
  view.Pass->SetDenoiserToNone();
  const vtkSSAOStatistics acne = vtkSSAOTest::OpenFloor(view, 30.0, false);
  test.ExpectAtMost(acne.Mean, 0.95, "V of an open floor without bias");
  test.ExpectAtLeast(acne.Deviation, 0.02, "Its deviation");
  view.Pass->SetBias(0.05 * 0.8);
  const vtkSSAOStatistics biased = vtkSSAOTest::OpenFloor(view, 30.0, false);
  test.ExpectAtMost(
    (1.0 - biased.Mean) / (1.0 - acne.Mean), 0.5, "Share of the acne that a bias of .05 R leaves");
  view.Pass->SetBiasToAutomatic();
  view.Pass->SetEstimatorToHemisphere();
  const vtkSSAOStatistics cured = vtkSSAOTest::OpenFloor(view, 30.0, false);
  test.ExpectAtLeast(cured.Mean, 0.999, "V with Hemisphere, whose bias knows the slope");
  test.ExpectAtMost(cured.Deviation, 0.002, "Its deviation");
  return test.GetResult();
}
