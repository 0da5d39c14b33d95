// SPDX-License-Identifier: BSD-3-Clause

// Visibility does not depend on the unit of length: a scene scaled with its radius, or with the
// automatic one, has the same.

#include "vtkSSAOStability.h"
#include "vtkSSAOTestImpostors.h"
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
Images Render(vtkSSAOTestMonitor& test, double scale, bool parallel, double radius, bool impostors)
{
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view, scale);
  if (impostors)
  {
    vtkSSAOTest::AddImpostors(view, scale);
  }
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

//------------------------------------------------------------------------------
void Compare(
  vtkSSAOTestMonitor& test, const char* name, bool impostors, const std::vector<double>& scales)
{
  // At the rim of a sphere rounding decides whether a pixel shows it, and up to a noise tile of its
  // neighbours notices, 10 x 10 pixels or 0.7 % of the picture.
  vtkSSAOStability row(test, name,
    impostors ? "% of the pixels whose V differs by more than 2/255 from scale 1"
              : "largest difference of V from scale 1 in 1/255",
    vtkSSAOStability::AtMost, impostors ? 1.0 : 2.0);
  const auto difference = [impostors](const vtkSSAOTestImage& a, const vtkSSAOTestImage& b)
  {
    return impostors ? 100.0 * vtkSSAOShareBeyond(a, b, 2.0 / 255.0)
                     : 255.0 * vtkSSAOLargestDifference(a, b);
  };
  for (bool parallel : { false, true })
  {
    for (double radius : { 0.5, 0.0 })
    {
      const Images unit = Render(test, 1.0, parallel, radius, impostors);
      test.ExpectAtLeast(unit.Radius, 0.1, "effective radius");
      for (double scale : scales)
      {
        const Images images = Render(test, scale, parallel, radius, impostors);
        std::ostringstream what;
        what << (parallel ? "parallel" : "perspective") << ", radius "
             << (radius > 0.0 ? "given" : "automatic") << ", scale " << scale;
        test.ExpectNear(images.Radius / scale, unit.Radius, 1.0e-6 * unit.Radius,
          what.str() + ": effective radius / scale");
        for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
        {
          row.Ours(preset, difference(images.Ours[preset], unit.Ours[preset]), what.str());
        }
        row.VTK(difference(images.VTK, unit.VTK), what.str());
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableWorldScale(int, char*[])
{
  vtkSSAOTestMonitor test;
  Compare(test, "World scale 1e-6 to 1e6", false, { 1.0e-6, 1.0e-3, 1.0e3, 1.0e6 });
  Compare(test, "The same, spheres of vtkOpenGLSphereMapper", true, { 1.0e-3, 1.0e3 });
  return test.GetResult();
}
