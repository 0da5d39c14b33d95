// SPDX-License-Identifier: BSD-3-Clause

// Estimator ReflectedHemisphere: its twin in all weights, its properties, and its controls.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorReflectedHemisphere(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToReflectedHemisphere();
    pass->SetKernelSize(26);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "ReflectedHemisphere");
  for (int falloff : { 0, 1, 2 })
  {
    vtkSSAOTest::ExpectTwins(
      test,
      [&](vtkScreenSpaceAmbientOcclusionPass* pass)
      {
        setUp(pass);
        pass->SetAttenuation(0.4);
        pass->SetMinimumDifference(0.1);
        pass->SetFalloff(falloff);
      },
      "ReflectedHemisphere, weight " + std::to_string(falloff));
  }
  vtkSSAOTest::ExpectProperties(test, setUp, 1.0, 0.01, 0.1, "ReflectedHemisphere");

  vtkSSAOTestView view(test, 120, 80);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  setUp(view.Pass);
  const double usual = view.MeasureSurfaces(view.Visibility()).Mean;
  view.Pass->SetAttenuation(2.0);
  test.ExpectAtMost(view.MeasureSurfaces(view.Visibility()).Mean, usual - 0.005,
    "mean V with attenuation 2, below the one with 1");
  view.Pass->SetAttenuation(1.0);
  view.Pass->SetMinimumDifference(0.5);
  test.ExpectAtLeast(view.MeasureSurfaces(view.Visibility()).Mean, usual + 0.01,
    "mean V with a minimum difference of 0.5, above the one with 0.01");
  view.Pass->SetMinimumDifference(1.0);
  test.ExpectEqual(
    view.MeasureSurfaces(view.Visibility()).Mean, 1.0, "mean V with a minimum difference of 1");
  return test.GetResult();
}
