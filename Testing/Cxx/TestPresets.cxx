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
  vtkSSAOShowOcclusionOfStillLife(view);
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    view.SetPreset(preset);
    // A sample that another rounding puts on another texel changes V by some sectors of a pixel, of
    // which there are 120 or more, or by some hundredths (Fast), spread over 9 or 16 pixels.
    images.Compare(view.Picture(), { 1, 0.002, 4 }, vtkSSAOTestView::GetPresetName(preset));
  }
  return test.GetResult();
}
