// SPDX-License-Identifier: BSD-3-Clause

// One baseline for each estimator: V of the still life with the samples that its source uses.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestEstimatorImages(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOShowOcclusionOfStillLife(view);
  const int kernelSizes[] = { 32, 128, 128, 64, 64, 26, 24, 24, 24 };
  for (int estimator = 0; estimator < vtkSSAOTest::NumberOfEstimators; ++estimator)
  {
    view.Pass->SetEstimator(estimator);
    view.Pass->SetKernelSize(kernelSizes[estimator]);
    // A sample that another rounding puts on the other side of a threshold changes V by up to 1/6,
    // spread over the 16 pixels of a tile.
    images.Compare(view.Picture(), { 1, 0.004, 6 }, vtkSSAOTest::EstimatorNames[estimator]);
  }
  return test.GetResult();
}
