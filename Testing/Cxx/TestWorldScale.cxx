// SPDX-License-Identifier: BSD-3-Clause

// Visibility does not depend on the unit of length: a scene scaled with its radius, or with the
// automatic one, has the same.

#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>

//------------------------------------------------------------------------------
int TestWorldScale(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (bool parallel : { false, true })
  {
    for (double radius : { 0.5, 0.0 })
    {
      vtkSSAOTestImage unit;
      double unitRadius = 0.0;
      for (double scale : { 1.0, 1.0e-3, 1.0e3 })
      {
        vtkSSAOTestView view(test, 150, 100);
        vtkSSAOAddStillLife(view, scale);
        vtkSSAOLookAtStillLife(view, parallel, scale);
        view.Pass->SetRadius(radius * scale);
        const vtkSSAOTestImage v = view.Visibility();
        if (scale == 1.0)
        {
          unit = v;
          unitRadius = view.Pass->GetEffectiveRadius();
          test.ExpectAtLeast(unitRadius, 0.1, "effective radius");
          test.ExpectAtMost(view.MeasureSurfaces(v).Minimum, 0.8, "smallest V at scale 1");
          continue;
        }
        std::ostringstream what;
        what << (parallel ? "Parallel" : "Perspective") << ", radius "
             << (radius > 0.0 ? "given" : "automatic") << ", scale " << scale << ": ";
        test.ExpectNear(view.Pass->GetEffectiveRadius() / scale, unitRadius, 1.0e-6 * unitRadius,
          what.str() + "effective radius / scale");
        // Other numbers are rounded otherwise: single samples change sides, pixels at silhouettes
        // change owners.
        test.ExpectAtMost(
          vtkSSAOMeanDifference(v, unit), 2.0e-5, what.str() + "mean difference of V");
        const vtkSSAOStatistics beyond = vtkSSAOMeasure(
          v, [&](int x, int y) { return std::abs(v.At(x, y) - unit.At(x, y)) > 2.0 / 255.0; });
        test.ExpectAtMost(beyond.Count, 2, what.str() + "pixels that differ by more than 2/255");
      }
    }
  }
  return test.GetResult();
}
