// SPDX-License-Identifier: BSD-3-Clause

// Visibility does not depend on the unit of length: a scene scaled with its radius, or with the
// automatic one, has the same.

#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>
#include <vector>

namespace
{
struct Images
{
  std::vector<vtkSSAOTestImage> Ours; // by preset
  vtkSSAOTestImage VTK;
  double Radius = 0.0;
};

//------------------------------------------------------------------------------
Images Render(vtkSSAOTestMonitor& test, double scale, bool parallel, double radius)
{
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view, scale);
  vtkSSAOLookAtStillLife(view, parallel, scale);
  view.Pass->SetRadius(radius * scale);
  Images images;
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    view.SetPreset(preset);
    images.Ours.push_back(view.Visibility());
    test.ExpectAtMost(view.MeasureSurfaces(images.Ours.back()).Minimum, 0.8, "smallest V");
  }
  images.Radius = view.Pass->GetEffectiveRadius();
  images.VTK = view.VisibilityOfVTK(images.Radius);
  return images;
}
}

//------------------------------------------------------------------------------
int TestStableWorldScale(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(test, "World scale 1e-6 to 1e6",
    "largest difference of V from scale 1 in 1/255", vtkSSAOStability::AtMost, 2.0);
  for (bool parallel : { false, true })
  {
    for (double radius : { 0.5, 0.0 })
    {
      const Images unit = Render(test, 1.0, parallel, radius);
      test.ExpectAtLeast(unit.Radius, 0.1, "effective radius");
      for (double scale : { 1.0e-6, 1.0e-3, 1.0e3, 1.0e6 })
      {
        const Images images = Render(test, scale, parallel, radius);
        std::ostringstream what;
        what << (parallel ? "parallel" : "perspective") << ", radius "
             << (radius > 0.0 ? "given" : "automatic") << ", scale " << scale;
        test.ExpectNear(images.Radius / scale, unit.Radius, 1.0e-6 * unit.Radius,
          what.str() + ": effective radius / scale");
        for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
        {
          row.Ours(preset, 255.0 * vtkSSAOLargestDifference(images.Ours[preset], unit.Ours[preset]),
            what.str());
        }
        row.VTK(255.0 * vtkSSAOLargestDifference(images.VTK, unit.VTK), what.str());
      }
    }
  }
  return test.GetResult();
}
