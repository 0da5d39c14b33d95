// SPDX-License-Identifier: BSD-3-Clause

// Estimator DepthSphere: its twin, its properties, and that it equals PositionSphere.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorDepthSphere(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToDepthSphere();
    pass->SetKernelSize(128);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "DepthSphere");
  vtkSSAOTest::ExpectProperties(test, setUp, 0.25, 0.07, 0.04, "DepthSphere");

  for (bool parallel : { false, true })
  {
    vtkSSAOTestView view(test, 240, 160);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, parallel);
    view.Renderer->GetActiveCamera()->SetClippingRange(2.0, 20.0);
    view.Pass->SetRadius(0.5);
    view.Pass->SetKernelSize(128);
    const std::string projection = parallel ? ", parallel" : ", perspective";
    for (int denoiser : { 4, 0 })
    {
      view.Pass->SetDenoiser(denoiser);
      view.Pass->SetEstimatorToPositionSphere();
      const vtkSSAOTestImage position = view.Visibility();
      view.Pass->SetEstimatorToDepthSphere();
      const vtkSSAOTestImage depth = view.Visibility();
      if (denoiser)
      {
        test.ExpectAtMost(255.0 * vtkSSAOLargestDifference(position, depth), 1.0,
          "PositionSphere and DepthSphere, denoised, largest difference in 1/255" + projection);
        continue;
      }
      // One of the 128 points within rounding of the surface changes a raw pixel by up to 4/255.
      int above = 0;
      for (std::size_t i = 0; i < position.Values.size(); ++i)
      {
        above += std::abs(position.Values[i] - depth.Values[i]) > 1.0F / 255.0F ? 1 : 0;
      }
      test.ExpectAtMost(static_cast<double>(above) / position.Values.size(), 0.002,
        "PositionSphere and DepthSphere, share of raw pixels where rounding decides" + projection);
      test.ExpectAtMost(255.0 * vtkSSAOLargestDifference(position, depth), 8.5,
        "PositionSphere and DepthSphere, raw, largest difference in 1/255" + projection);
    }
  }
  return test.GetResult();
}
