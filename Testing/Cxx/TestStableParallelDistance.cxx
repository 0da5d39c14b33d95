// SPDX-License-Identifier: BSD-3-Clause

// In parallel projection the distance of the camera changes nothing that is seen, so it does not
// change visibility either.

#include "vtkCamera.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestImpostors.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>
#include <vector>

namespace
{
// In radii. Beyond, single samples begin to fall to the other side of the radius (4.2/255 in 0.14 %
// of the pixels at 300,000), and from 10,000,000 on the depth test does not tell surfaces apart:
// VTK's clipping range is at least a fiftieth of the distance deep, of which float32 tells 2^24
// places.
constexpr double FarthestPicture = 100000.0;
// Where VTK itself computes depths from the camera on, in steps of 1/500 of the radius here.
constexpr double FarthestImpostor = 20000.0;

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

//------------------------------------------------------------------------------
// A plate whose faces are there twice, wound both ways, across the bodies of the still life.
void AddDoublyWoundPlate(vtkSSAOTestView& view)
{
  view.Add(vtkSSAOQuad({ -1, 0.4, 1 }, { 2, 0, 0 }, { 0, 0, -2 }));
  view.Add(vtkSSAOQuad({ -1, 0.4, -1 }, { 2, 0, 0 }, { 0, 0, 2 }));
}

//------------------------------------------------------------------------------
void AddSpheres(vtkSSAOTestView& view)
{
  vtkSSAOTest::AddImpostors(view);
}

//------------------------------------------------------------------------------
// What rounding decides: which of two faces in one place is seen, and where impostors are.
void CompareTies(vtkSSAOTestMonitor& test, const char* name, void (*add)(vtkSSAOTestView&),
  int samples, double farthest, double most)
{
  vtkSSAOStability row(test, name, "% of the pixels whose V differs by more than 3/255",
    vtkSSAOStability::AtMost, most);
  vtkSSAOTestView view(test, 150, 100, samples);
  vtkSSAOAddStillLife(view);
  add(view);
  vtkSSAOLookAtStillLife(view, true);
  view.Pass->SetRadius(0.5);
  std::vector<vtkSSAOTestImage> near;
  vtkSSAOTestImage ofVTK;
  for (double radii : { 10.0, 1000.0, farthest })
  {
    MoveAway(view, 0.5 * radii);
    std::ostringstream what;
    what << radii << " R";
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const vtkSSAOTestImage v = view.Visibility();
      if (static_cast<int>(near.size()) == preset)
      {
        near.push_back(v);
      }
      row.Ours(preset, 100.0 * vtkSSAOShareBeyond(v, near[preset], 3.0 / 255.0), what.str());
    }
    const vtkSSAOTestImage v = view.VisibilityOfVTK(0.5);
    ofVTK = ofVTK.Width ? ofVTK : v;
    row.VTK(100.0 * vtkSSAOShareBeyond(v, ofVTK, 3.0 / 255.0), what.str());
  }
}
}

//------------------------------------------------------------------------------
int TestStableParallelDistance(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability same(test, "Parallel projection, camera 10 R to 100,000 R away",
    "largest difference of V in 1/255", vtkSSAOStability::AtMost, 3.0);
  vtkSSAOStability open(test, "Parallel projection, camera 10 R to 1,000,000 R away, open floor",
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
  for (double radii : { 10.0, 30.0, 1000.0, 20000.0, 100000.0, 1000000.0 })
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
  CompareTies(
    test, "The same, a plate wound both ways", AddDoublyWoundPlate, 0, FarthestPicture, 1.0);
  CompareTies(
    test, "The same plate, 4 samples per pixel", AddDoublyWoundPlate, 4, FarthestPicture, 1.0);
  CompareTies(test,
    "Parallel projection, camera 10 R to 20,000 R away, spheres of vtkOpenGLSphereMapper",
    AddSpheres, 0, FarthestImpostor, 1.0);
  return test.GetResult();
}
