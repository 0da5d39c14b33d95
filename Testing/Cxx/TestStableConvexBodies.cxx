// SPDX-License-Identifier: BSD-3-Clause

// Nothing in front of a convex body: a sphere and a box alone in space are not occluded, whatever
// the radius, in any preset, in both projections.

#include "vtkCleanPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkNew.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataNormals.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestView.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <sstream>

namespace
{
//------------------------------------------------------------------------------
void Look(vtkSSAOTestView& view, bool parallel)
{
  if (parallel)
  {
    view.LookParallel({ 2, 1.5, 3 }, { 0, 0, 0 }, { 0, 1, 0 }, 1.0);
  }
  else
  {
    view.Look({ 2, 1.5, 3 }, { 0, 0, 0 }, { 0, 1, 0 });
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyDataAlgorithm> NewSphere(int around, int fromPoleToPole)
{
  auto sphere = vtkSmartPointer<vtkSphereSource>::New();
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(around);
  sphere->SetPhiResolution(fromPoleToPole);
  return sphere;
}

//------------------------------------------------------------------------------
// One body in both projections; radius 0 is the automatic one.
void TestBody(vtkSSAOTestMonitor& test, vtkSSAOStability& mean, vtkSSAOStability* smallest,
  vtkPolyDataAlgorithm* body, const std::string& name)
{
  vtkSSAOTestView view(test, 150, 100);
  view.Add(body);
  for (bool parallel : { false, true })
  {
    Look(view, parallel);
    for (double radius : { 0.0, 0.1, 1.0 })
    {
      std::ostringstream what;
      what << name << (parallel ? ", parallel" : ", perspective") << ", radius " << radius;
      view.Pass->SetRadius(radius);
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
        mean.Ours(preset, v.Mean, what.str());
        if (smallest)
        {
          smallest->Ours(preset, v.Minimum, what.str());
        }
        // A hundredth, as for an open plane: rounding of depths and facets at silhouettes.
        test.ExpectAtLeast(v.Minimum, 0.99, what.str() + ": smallest V");
        test.ExpectAtLeast(v.Count, 1000, what.str() + ": pixels of the body");
      }
      const vtkSSAOStatistics v =
        view.MeasureSurfaces(view.VisibilityOfVTK(view.Pass->GetEffectiveRadius()));
      mean.VTK(v.Mean, what.str());
      if (smallest)
      {
        smallest->VTK(v.Minimum, what.str());
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableConvexBodies(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability bodies(
    test, "Isolated convex bodies", "mean V", vtkSSAOStability::AtLeast, 0.998);
  TestBody(test, bodies, nullptr, NewSphere(256, 128), "sphere");
  TestBody(test, bodies, nullptr, vtkNew<vtkCubeSource>(), "box");
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(60);
  TestBody(test, bodies, nullptr, cylinder, "cylinder");
  vtkNew<vtkConeSource> cone; // its corners see each other's facets at sharp angles
  cone->SetResolution(60);
  TestBody(test, bodies, nullptr, cone, "cone");
  vtkNew<vtkPlatonicSolidSource> tetrahedron;
  TestBody(test, bodies, nullptr, tetrahedron, "tetrahedron");

  // Few facets under smooth normals: of neighbouring facets the one that looks away from the
  // shading normal lies below the horizon of the other.
  vtkSSAOStability mean(test, "Spheres of 6 x 6 to 20 x 20 facets with smooth normals", "mean V",
    vtkSSAOStability::AtLeast, 0.998);
  vtkSSAOStability smoothBodies(test, "Prisms, boxes and Platonic solids with smooth normals",
    "mean V", vtkSSAOStability::AtLeast, 0.998);
  vtkSSAOStability smallest(
    test, "Low-poly bodies with smooth normals", "smallest V", vtkSSAOStability::AtLeast, 0.99);
  // Normals by corner, the means of those of the facets about it.
  const auto smooth = [](vtkPolyDataAlgorithm* body)
  {
    vtkNew<vtkCleanPolyData> corners;
    corners->SetInputConnection(body->GetOutputPort());
    auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
    normals->SetInputConnection(corners->GetOutputPort());
    normals->SplittingOff();
    normals->AutoOrientNormalsOn(); // VTK's tetrahedron and icosahedron are wound inside out
    return normals;
  };
  vtkNew<vtkCylinderSource> prism;
  prism->SetResolution(5);
  TestBody(test, smoothBodies, &smallest, smooth(prism), "prism of 5 sides");
  TestBody(test, smoothBodies, &smallest, smooth(vtkNew<vtkCubeSource>()), "smooth box");
  vtkNew<vtkPlatonicSolidSource> solid;
  for (int type : { VTK_SOLID_TETRAHEDRON, VTK_SOLID_OCTAHEDRON, VTK_SOLID_ICOSAHEDRON })
  {
    solid->SetSolidType(type);
    // At the corners of the tetrahedron normals lie 70 degrees off the facets, beyond the horizon
    // of some pixels.
    TestBody(test, smoothBodies, &smallest, smooth(solid),
      "smooth Platonic solid " + std::to_string(type));
  }
  for (int resolution : { 6, 10, 20 })
  {
    TestBody(test, mean, &smallest, NewSphere(resolution, resolution),
      "sphere of " + std::to_string(resolution) + " x " + std::to_string(resolution) + " facets");
  }
  return test.GetResult();
}
