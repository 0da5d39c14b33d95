// SPDX-License-Identifier: BSD-3-Clause

// Baselines with four samples per pixel; and away from the edges the picture is the one without.

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestMultiSamples(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test, 300, 200, 4);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);

  vtkSmartPointer<vtkImageData> smooth = view.Picture();
  test.ExpectEqual(view.Window->GetMultiSamples(), 4, "samples");
  // The pixel's centre decides what a lit pixel shows, rounding as in TestStages; the four places
  // of the samples are Mesa's.
  images.Compare(smooth, { 1, 0.002, 8 }, "Composite");
  view.Pass->SetOutputModeToOcclusion();
  images.Compare(view.Picture(), { 1, 0.002, 8 }, "Occlusion");

  vtkSSAOTestView aliased(test, 300, 200, 0);
  vtkSSAOAddStillLife(aliased);
  vtkSSAOLookAtStillLife(aliased, false);
  aliased.Pass->SetRadius(0.5);
  const vtkSSAODifference difference =
    vtkSSAOImageCompare::Difference(smooth, aliased.Picture(), 4);
  // About 700 pixels of silhouettes and creases are smoothed, and V changes in up to two pixels on
  // each side of them, because one of four is estimated: up to 2,800 of 60,000.
  test.ExpectAtMost(
    difference.Fraction, 0.047, "share of pixels that differ from the picture without samples");
  test.ExpectAtLeast(difference.Largest, 20, "edges are smooth: largest difference");
  return test.GetResult();
}
