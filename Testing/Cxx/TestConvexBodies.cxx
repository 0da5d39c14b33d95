// SPDX-License-Identifier: BSD-3-Clause

// Nothing in front of a convex body: a sphere and a box alone in space are not occluded, whatever
// the radius, in any preset, in both projections.

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestView.h"
#include "vtkSphereSource.h"

#include <sstream>

//------------------------------------------------------------------------------
int TestConvexBodies(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (bool round : { true, false })
  {
    vtkSSAOTestView view(test, 150, 100);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetThetaResolution(256);
    sphere->SetPhiResolution(128);
    vtkNew<vtkCubeSource> box;
    view.Add(round ? static_cast<vtkAlgorithm*>(sphere) : box);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      for (bool parallel : { false, true })
      {
        if (parallel)
        {
          view.LookParallel({ 2, 1.5, 3 }, { 0, 0, 0 }, { 0, 1, 0 }, 1.0);
        }
        else
        {
          view.Look({ 2, 1.5, 3 }, { 0, 0, 0 }, { 0, 1, 0 });
        }
        for (double radius : { 0.0, 0.1, 1.0 })
        {
          view.Pass->SetRadius(radius);
          const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
          std::ostringstream what;
          what << (round ? "Sphere, " : "Box, ") << vtkSSAOTestView::GetPresetName(preset)
               << (parallel ? ", parallel" : ", perspective") << ", radius " << radius << ": ";
          test.ExpectAtLeast(v.Mean, 0.998, what.str() + "mean V");
          // Single pixels of a silhouette may see a neighbour that their tangent plane hides by
          // less than the bias: a few of the samples of one pixel, spread by the denoiser.
          test.ExpectAtLeast(v.Minimum, 0.9, what.str() + "smallest V");
          test.ExpectAtLeast(v.Count, 1500, what.str() + "pixels of the body");
        }
      }
    }
  }

  // Few facets under smooth normals: of neighbouring facets the one that looks away from the
  // shading normal lies below the horizon of the other.
  for (int resolution : { 6, 10, 20 })
  {
    vtkSSAOTestView view(test, 150, 100);
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    view.Add(sphere);
    view.Look({ 2, 1.5, 3 }, { 0, 0, 0 }, { 0, 1, 0 });
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      for (double radius : { 0.1, 1.0 })
      {
        view.Pass->SetRadius(radius);
        const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
        std::ostringstream what;
        what << "Sphere of " << resolution << " x " << resolution << " facets, "
             << vtkSSAOTestView::GetPresetName(preset) << ", radius " << radius << ": ";
        test.ExpectAtLeast(v.Mean, 0.998, what.str() + "mean V");
        test.ExpectAtLeast(v.Minimum, 0.99, what.str() + "smallest V");
        test.ExpectAtLeast(v.Count, 1500, what.str() + "pixels of the body");
      }
    }
  }
  return test.GetResult();
}
