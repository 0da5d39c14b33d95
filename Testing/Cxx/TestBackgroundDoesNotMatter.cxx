// SPDX-License-Identifier: BSD-3-Clause

// The colour of the background, a gradient or its depth do not change the visibility of any
// surface by a single bit, and the background itself has visibility 1.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestBackgroundDoesNotMatter(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  view.Pass->SetRadius(0.5);

  for (bool parallel : { false, true })
  {
    vtkSSAOLookAtStillLife(view, parallel);
    for (int denoiser : { 0, 1, 4 })
    {
      const std::string what = std::string(parallel ? "Parallel" : "Perspective") + ", denoiser " +
        std::to_string(denoiser) + ": ";
      view.Pass->SetDenoiser(denoiser);
      view.Renderer->GradientBackgroundOff();
      view.Renderer->SetBackground(0, 0, 0);
      const vtkSSAOTestImage black = view.Visibility();
      const vtkSSAOTestImage surfaces = view.Surfaces();
      const vtkSSAOStatistics open =
        vtkSSAOMeasure(black, [&](int x, int y) { return surfaces.At(x, y) == 0.0F; });
      test.ExpectAtLeast(open.Count, 100, what + "pixels of the background");
      test.ExpectEqual(open.Minimum, 1.0, what + "smallest V of the background");
      test.ExpectAtMost(view.MeasureSurfaces(black).Minimum, 0.8, what + "smallest V of a surface");

      view.Renderer->SetBackground(1, 1, 1);
      test.Expect(view.Visibility() == black, what + "white background");
      view.Renderer->SetBackground2(1, 0.2, 0);
      view.Renderer->GradientBackgroundOn();
      test.Expect(view.Visibility() == black, what + "gradient background");
      view.Renderer->SetBackgroundAlpha(1.0);
      test.Expect(view.Visibility() == black, what + "opaque background");
      view.Renderer->SetBackgroundAlpha(0.0);
    }
  }
  return test.GetResult();
}
