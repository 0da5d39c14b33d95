// SPDX-License-Identifier: BSD-3-Clause

// One baseline for each stage of the pipeline, so that a failure names the stage.

#include "vtkImageData.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestStages(int argc, char* argv[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOImageCompare images(argc, argv, test);
  vtkSSAOTestView view(test);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);

  // Rasterised by the same rules everywhere: rounding only.
  view.Pass->SetOutputModeToDepth();
  images.Compare(view.Picture(), { 1, 0.0, 1 }, "Depth");
  view.Pass->SetOutputModeToNormal();
  images.Compare(view.Picture(), { 1, 0.0, 1 }, "Normal");

  // A sample that another rounding puts on another texel hides some sectors more or less of the 120
  // of a pixel, 2/255 each: so much for a few pixels.
  view.Pass->SetOutputModeToOcclusion();
  view.Pass->SetDenoiserToNone();
  images.Compare(view.Picture(), { 2, 0.002, 24 }, "RawOcclusion");

  // The same, spread over the 16 pixels of a tile.
  view.Pass->SetDenoiserToBox();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "Box");
  view.Pass->SetDenoiserToEdgeAware();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "EdgeAware");
  view.Pass->SetOutputModeToComposite();
  images.Compare(view.Picture(), { 1, 0.002, 4 }, "Composite");
  return test.GetResult();
}
