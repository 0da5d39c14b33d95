// SPDX-License-Identifier: BSD-3-Clause

// One baseline for each denoiser that TestStages has none for: V of the still life.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestDenoiserImages(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOShowOcclusionOfStillLife(view);
  view.Pass->SetDenoiserToBoxCentered();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "BoxCentered");
  view.Pass->SetDenoiserToSeparableGaussian();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "SeparableGaussian");
  return test.GetResult();
}
