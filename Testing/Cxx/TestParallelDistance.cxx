// SPDX-License-Identifier: BSD-3-Clause

// In parallel projection the distance of the camera changes nothing that is seen, so it does not
// change visibility either.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>

//------------------------------------------------------------------------------
int TestParallelDistance(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, true);
  view.Pass->SetRadius(0.5);
  const vtkSSAOTestImage near = view.Visibility();
  test.ExpectAtMost(view.MeasureSurfaces(near).Minimum, 0.8, "smallest V");

  vtkCamera* camera = view.Renderer->GetActiveCamera();
  double toCamera[3];
  camera->GetDirectionOfProjection(toCamera);
  const double distance = camera->GetDistance();
  for (double factor : { 0.5, 3.0, 30.0, 300.0 })
  {
    const double* at = camera->GetFocalPoint();
    camera->SetPosition(at[0] - toCamera[0] * distance * factor,
      at[1] - toCamera[1] * distance * factor, at[2] - toCamera[2] * distance * factor);
    view.Renderer->ResetCameraClippingRange();
    const vtkSSAOTestImage v = view.Visibility();
    std::ostringstream what;
    what << factor << " times the distance: ";
    // Depth in float32 loses two decimal digits at the largest distance: it is off by up to 6e-5
    // there, and a sample at a twentieth of the radius by three thousandths of a radian.
    test.ExpectAtMost(vtkSSAOMeanDifference(v, near), 2.0e-4, what.str() + "mean difference of V");
    const vtkSSAOStatistics beyond = vtkSSAOMeasure(
      v, [&](int x, int y) { return std::abs(v.At(x, y) - near.At(x, y)) > 2.0 / 255.0; });
    test.ExpectAtMost(beyond.Count, 2, what.str() + "pixels that differ by more than 2/255");
  }
  return test.GetResult();
}
