// SPDX-License-Identifier: BSD-3-Clause

// An open plane is not occluded, at any angle, in any preset, in both projections.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <cmath>

//------------------------------------------------------------------------------
int TestStableOpenPlane(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(
    test, "Open plane at 5 to 89 degrees", "mean V", vtkSSAOStability::AtLeast, 0.998);
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddFloor(view);
  view.Pass->SetRadius(1.0);

  for (bool parallel : { false, true })
  {
    for (int elevation : { 89, 85, 60, 45, 30, 15, 5 })
    {
      const double angle = elevation * std::acos(-1.0) / 180.0;
      const std::vector<double> from = { 0.0, 15.0 * std::sin(angle), 15.0 * std::cos(angle) };
      if (parallel)
      {
        view.LookParallel(from, { 0, 0, 0 }, { 0, 1, 0 }, 4.0);
      }
      else
      {
        view.Look(from, { 0, 0, 0 }, { 0, 1, 0 });
      }
      const std::string what =
        (parallel ? "parallel, " : "perspective, ") + std::to_string(elevation) + " degrees";
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
        // Nothing rises above a plane: what is left is rounding of depths and facets, which a
        // hundredth above the facet takes away.
        row.Ours(preset, v.Mean, what);
        test.ExpectAtLeast(v.Minimum, 0.99, what + ": smallest V");
        test.ExpectAtLeast(v.Count, 2000, what + ": pixels of the plane");
      }
      row.VTK(view.MeasureSurfaces(view.VisibilityOfVTK(1.0)).Mean, what);
    }
  }

  // An off-axis view, as of a tile of a larger picture or of one eye.
  view.SetPreset(1);
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  for (bool parallel : { false, true })
  {
    if (parallel)
    {
      view.LookParallel({ 0, 7, 7 }, { 0, 0, 0 }, { 0, 1, 0 }, 1.5);
    }
    else
    {
      view.Look({ 0, 7, 7 }, { 0, 0, 0 }, { 0, 1, 0 });
    }
    camera->SetWindowCenter(-1.0, 0.75);
    const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
    const std::string what = parallel ? "Off-axis, parallel: " : "Off-axis, perspective: ";
    test.ExpectAtLeast(v.Mean, 0.995, what + "mean V");
    test.ExpectAtLeast(v.Count, 2000, what + "pixels of the plane");
    // The very surface: depth times the ray of a pixel lies on the plane, so its depth is linear in
    // the pixel's place for parallel projection, and its inverse for perspective.
    const vtkSSAOTestImage depth = view.Depth();
    const auto along = [&](int x, int y)
    { return parallel ? depth.At(x, y) : 1.0 / depth.At(x, y); };
    test.ExpectNear(along(20, 20) + along(130, 80), along(20, 80) + along(130, 20), 1.0e-4,
      what + "depth of a plane");
  }
  return test.GetResult();
}
