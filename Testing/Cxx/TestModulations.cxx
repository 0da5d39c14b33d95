// SPDX-License-Identifier: BSD-3-Clause

// One baseline for each way in which visibility changes the light.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestModulations(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  view.Pass->SetIntensity(1.5); // so that Ambient shows as well

  // V differs by 1/255 at most where a rounding moves a sample (see TestPresets), and is multiplied
  // with light of at most 1, and with 1.5.
  const vtkSSAOTolerance rounding = { 2, 0.002, 6 };
  view.Pass->SetModulationToAmbient();
  images.Compare(view.Picture(), rounding, "Ambient");
  view.Pass->SetModulationToAmbientAndDiffuse();
  images.Compare(view.Picture(), rounding, "AmbientAndDiffuse");
  view.Pass->SetModulationToAll();
  images.Compare(view.Picture(), rounding, "All");
  return test.GetResult();
}
