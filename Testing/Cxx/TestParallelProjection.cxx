// SPDX-License-Identifier: BSD-3-Clause

// Baselines in parallel projection.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestParallelProjection(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, true);
  view.Pass->SetRadius(0.5);
  // Rounding: as in TestStages.
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "Composite");
  view.Pass->SetOutputModeToOcclusion();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "Occlusion");
  view.Pass->SetOutputModeToDepth();
  images.Compare(view.Picture(), { 1, 0.0, 1 }, "Depth");
  return test.GetResult();
}
