// SPDX-License-Identifier: BSD-3-Clause

// A camera that moves by less than a pixel changes the shade of the whole by next to nothing, in
// any preset and projection: animations do not flicker.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <algorithm>
#include <cmath>
#include <string>

//------------------------------------------------------------------------------
int TestSmallMoves(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (bool parallel : { false, true })
  {
    vtkSSAOTestView view(test, 150, 100);
    vtkSSAOAddStillLife(view);
    view.Pass->SetRadius(0.5);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      vtkSSAOLookAtStillLife(view, parallel);
      // Upright edges would lie along columns of pixels in parallel projection and change as one.
      view.Renderer->GetActiveCamera()->Roll(17.0);
      double before = view.MeasureSurfaces(view.Visibility()).Mean;
      double largest = 0.0;
      for (int step = 0; step < 8; ++step)
      {
        // A pixel is about .026 at the still life: a seventh of it each time, askew.
        vtkCamera* camera = view.Renderer->GetActiveCamera();
        double from[3];
        double at[3];
        camera->GetPosition(from);
        camera->GetFocalPoint(at);
        camera->SetPosition(from[0] + 0.0037, from[1] + 0.0011, from[2] - 0.0005);
        camera->SetFocalPoint(at[0] + 0.0037, at[1] + 0.0011, at[2] - 0.0005);
        const double mean = view.MeasureSurfaces(view.Visibility()).Mean;
        largest = std::max(largest, std::abs(mean - before));
        before = mean;
      }
      // Half of a step of 8 bits; what comes into the picture and leaves it is part of it.
      test.ExpectAtMost(largest, 0.002,
        std::string(vtkSSAOTestView::GetPresetName(preset)) +
          (parallel ? ", parallel" : ", perspective") +
          ": change of the mean V by a seventh of a pixel");
    }
  }
  return test.GetResult();
}
