// SPDX-License-Identifier: BSD-3-Clause

// Estimator HorizonAngle: its twin, its properties, its controls, and the number of samples under
// the name of vtkSSAOPass.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorHorizonAngle(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  { pass->SetEstimatorToHorizonAngle(); };
  vtkSSAOTest::ExpectTwins(test, setUp, "HorizonAngle");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->SetDirections(7);
      pass->SetSteps(9);
      pass->SetAngleBias(5.0);
    },
    "HorizonAngle 7x9, bias 5 degrees");
  vtkSSAOTest::ExpectProperties(test, setUp, 1.0, 0.005, 0.1, "HorizonAngle");

  // In a corner the wall rises upright from every point of the floor.
  vtkSSAOTestView view(test, 120, 80);
  vtkSSAOAddCorner(view);
  vtkSSAOLookAtCorner(view, false);
  view.Pass->SetRadius(2.0);
  setUp(view.Pass);
  double last = 0.0;
  for (double degrees : { 0.0, 15.0, 30.0, 60.0, 89.0 })
  {
    view.Pass->SetAngleBias(degrees);
    const double mean = view.MeasureSurfaces(view.Visibility()).Mean;
    test.ExpectAtLeast(mean, last,
      "Corner, mean V with an angle bias of " + std::to_string(static_cast<int>(degrees)) +
        " degrees, not below the one before");
    last = mean;
  }
  test.ExpectAtLeast(last, 0.999, "With 89 degrees nothing occludes: mean V");

  auto pass = view.Pass;
  const int wanted[][3] = { { 1, 1, 1 }, { 24, 6, 4 }, { 32, 8, 4 }, { 64, 8, 8 }, { 96, 12, 8 },
    { 256, 16, 16 } };
  for (const int(&product)[3] : wanted)
  {
    pass->SetKernelSize(product[0]);
    const std::string what = "KernelSize " + std::to_string(product[0]) + ": ";
    test.ExpectEqual(pass->GetDirections() * pass->GetSteps(), product[0], what + "samples");
    test.ExpectEqual(pass->GetDirections(), product[1], what + "directions");
    test.ExpectEqual(pass->GetSteps(), product[2], what + "steps");
  }
  double farthest = 0.0;
  for (int size = 1; size <= 1024; ++size)
  {
    pass->SetKernelSize(size);
    const int distance = std::abs(pass->GetDirections() * pass->GetSteps() - size);
    farthest = std::max(farthest, distance > 1 ? static_cast<double>(distance) / size : 0.0);
  }
  test.ExpectAtMost(
    farthest, 0.02, "Directions x steps, largest relative distance from KernelSize beyond 1");
  pass->SetEstimatorToHemisphere();
  pass->SetDirections(3);
  pass->SetKernelSize(64);
  test.ExpectEqual(pass->GetDirections(), 3, "Directions after SetKernelSize with a kernel");
  return test.GetResult();
}
