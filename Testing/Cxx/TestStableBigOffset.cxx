// SPDX-License-Identifier: BSD-3-Clause

// Visibility does not depend on where in the world a scene is: points in double far from the
// origin, as in map coordinates, with the camera along.

#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <array>
#include <string>
#include <vector>

namespace
{
using Offset = std::array<double, 3>;
}

//------------------------------------------------------------------------------
int TestStableBigOffset(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability same(test, "Scene moved by (2.683e6, 1.247e6, 400) and by 1e7",
    "largest difference of V from the scene at the origin in 1/255", vtkSSAOStability::AtMost, 2.0);
  vtkSSAOStability open(
    test, "Open floor moved likewise", "smallest V", vtkSSAOStability::AtLeast, 0.99);
  const std::vector<Offset> offsets = { { 0.0, 0.0, 0.0 }, { 2.683e6, 1.247e6, 400.0 },
    { 1.0e7, 1.0e7, 1.0e7 } };
  for (bool parallel : { false, true })
  {
    std::vector<vtkSSAOTestImage> atOrigin;
    vtkSSAOTestImage ofVTK;
    for (const Offset& offset : offsets)
    {
      const std::string what =
        std::string(parallel ? "parallel, x " : "perspective, x ") + std::to_string(offset[0]);
      vtkSSAOTestView view(test, 150, 100);
      vtkSSAOAddStillLife(view);
      vtkSSAOLookAtStillLife(view, parallel);
      vtkSSAOMoveScene(view, offset);
      view.Pass->SetRadius(0.5);
      vtkSSAOTestView plane(test, 150, 100);
      vtkSSAOAddFloor(plane);
      vtkSSAOLookAtCorner(plane, parallel);
      vtkSSAOMoveScene(plane, offset);
      plane.Pass->SetRadius(1.0);
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOTestImage v = view.Visibility();
        if (static_cast<int>(atOrigin.size()) == preset)
        {
          test.ExpectAtMost(view.MeasureSurfaces(v).Minimum, 0.8, what + ": smallest V");
          atOrigin.push_back(v);
        }
        same.Ours(preset, 255.0 * vtkSSAOLargestDifference(v, atOrigin[preset]), what);
        plane.SetPreset(preset);
        const vtkSSAOStatistics floor = plane.MeasureSurfaces(plane.Visibility());
        open.Ours(preset, floor.Minimum, what);
        test.ExpectAtLeast(floor.Count, 5000, what + ": pixels of the floor");
      }
      const vtkSSAOTestImage v = view.VisibilityOfVTK(0.5);
      ofVTK = ofVTK.Width ? ofVTK : v;
      same.VTK(255.0 * vtkSSAOLargestDifference(v, ofVTK), what);
      open.VTK(plane.MeasureSurfaces(plane.VisibilityOfVTK(1.0)).Minimum, what);
    }
  }
  return test.GetResult();
}
