// SPDX-License-Identifier: BSD-3-Clause

// In parallel projection the distance of the camera changes nothing that is seen, so it does not
// change visibility either.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>
#include <vector>

namespace
{
// In radii. VTK's clipping range is at least a fiftieth of the distance deep, and float32 tells
// 2^24 places in it: here steps of 1/40,000 of the radius. On the way to 100,000 single samples
// begin to fall to the other side of a surface.
constexpr double FarthestPicture = 20000.0;

//------------------------------------------------------------------------------
void MoveAway(vtkSSAOTestView& view, double distance)
{
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  const double* at = camera->GetFocalPoint();
  camera->SetPosition(at[0] - direction[0] * distance, at[1] - direction[1] * distance,
    at[2] - direction[2] * distance);
  view.Renderer->ResetCameraClippingRange();
}
}

//------------------------------------------------------------------------------
int TestStableParallelDistance(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability same(test, "Parallel projection, camera 10 R to 20,000 R away",
    "largest difference of V in 1/255", vtkSSAOStability::AtMost, 3.0);
  vtkSSAOStability open(test, "Parallel projection, camera 10 R to 100,000 R away, open floor",
    "mean V", vtkSSAOStability::AtLeast, 0.998);
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, true);
  view.Pass->SetRadius(0.5);
  vtkSSAOTestView plane(test, 150, 100);
  vtkSSAOAddFloor(plane);
  vtkSSAOLookAtCorner(plane, true);
  plane.Pass->SetRadius(1.0);

  std::vector<vtkSSAOTestImage> near;
  vtkSSAOTestImage ofVTK;
  for (double radii : { 10.0, 30.0, 1000.0, 20000.0, 100000.0 })
  {
    MoveAway(view, 0.5 * radii);
    MoveAway(plane, radii);
    std::ostringstream what;
    what << radii << " R";
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const vtkSSAOTestImage v = view.Visibility();
      if (static_cast<int>(near.size()) == preset)
      {
        test.ExpectAtMost(view.MeasureSurfaces(v).Minimum, 0.8, what.str() + ": smallest V");
        near.push_back(v);
      }
      if (radii <= FarthestPicture)
      {
        same.Ours(preset, 255.0 * vtkSSAOLargestDifference(v, near[preset]), what.str());
      }
      plane.SetPreset(preset);
      open.Ours(preset, plane.MeasureSurfaces(plane.Visibility()).Mean, what.str());
    }
    const vtkSSAOTestImage v = view.VisibilityOfVTK(0.5);
    ofVTK = ofVTK.Width ? ofVTK : v;
    if (radii <= FarthestPicture)
    {
      same.VTK(255.0 * vtkSSAOLargestDifference(v, ofVTK), what.str());
    }
    open.VTK(plane.MeasureSurfaces(plane.VisibilityOfVTK(1.0)).Mean, what.str());
  }
  return test.GetResult();
}
