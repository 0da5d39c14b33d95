// SPDX-License-Identifier: BSD-3-Clause

// Estimator PositionSphere: its twin and its properties.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorPositionSphere(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToPositionSphere();
    pass->SetKernelSize(128);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "PositionSphere");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->RangeCheckOff();
      pass->SetBias(0.02);
    },
    "PositionSphere, range check off, bias");
  // Half of the points lie behind an open floor, and the visible half is squared.
  vtkSSAOTest::ExpectProperties(test, setUp, 0.25, 0.07, 0.04, "PositionSphere");

  // The same points for every pixel: the noise tile plays no part.
  vtkSSAOTestView view(test, 120, 80);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  setUp(view.Pass);
  view.Pass->SetDenoiserToNone();
  const vtkSSAOTestImage before = view.Visibility();
  view.Pass->SetNoiseSize(1);
  test.Expect(view.Visibility() == before, "PositionSphere: the same for any NoiseSize");
  return test.GetResult();
}
