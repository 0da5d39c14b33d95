// SPDX-License-Identifier: BSD-3-Clause

// Estimator CrytekSphere: its twin, its properties, and the grey walls that the half rule cures.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorCrytekSphere(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToCrytekSphere();
    pass->SetKernelSize(32);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "CrytekSphere");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->HalfRuleOff();
      pass->RangeCheckOff();
      pass->SetBias(0.02);
      pass->SetKernelSize(17);
      pass->SetNoiseSize(3);
    },
    "CrytekSphere, half rule and range check off, bias");
  vtkSSAOTest::ExpectProperties(test, setUp, 1.0, 0.03, 0.2, "CrytekSphere");

  // Half of the ball lies behind any open wall.
  vtkSSAOTestView view(test, 240, 160);
  vtkSSAOAddFloor(view);
  view.Pass->SetRadius(0.8);
  setUp(view.Pass);
  for (double elevation : { 89.0, 60.0, 30.0 })
  {
    const std::string where =
      "an open wall at " + std::to_string(static_cast<int>(elevation)) + " degrees, half rule ";
    view.Pass->HalfRuleOff();
    test.ExpectNear(
      vtkSSAOTest::OpenFloor(view, elevation, false).Mean, 0.5, 0.02, "V of " + where + "off");
    view.Pass->HalfRuleOn();
    test.ExpectAtLeast(
      vtkSSAOTest::OpenFloor(view, elevation, false).Mean, 0.97, "V of " + where + "on");
  }
  return test.GetResult();
}
