// SPDX-License-Identifier: BSD-3-Clause

// One baseline of the visibility for each preset.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestPresets(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  view.Pass->SetOutputModeToOcclusion();
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    view.SetPreset(preset);
    // A sample that another rounding puts on the other side changes V by 1/16 (Fast) or less in one
    // pixel of a tile of 16: 1/255.
    images.Compare(view.Picture(), { 1, 0.002, 4 }, vtkSSAOTestView::GetPresetName(preset));
  }
  return test.GetResult();
}
