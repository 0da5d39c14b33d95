// SPDX-License-Identifier: BSD-3-Clause

// The automatic radius is a tenth of the diagonal of the visible opaque props, whatever the camera
// sees of them; and it is used: a pass with that radius set shows the same.

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <cmath>

//------------------------------------------------------------------------------
int TestAutomaticRadius(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  const vtkSSAOTestImage automatic = view.Visibility();
  double bounds[6];
  view.Renderer->ComputeVisiblePropBounds(bounds);
  const double diagonal = std::sqrt(std::pow(bounds[1] - bounds[0], 2.0) +
    std::pow(bounds[3] - bounds[2], 2.0) + std::pow(bounds[5] - bounds[4], 2.0));
  const double radius = view.Pass->GetEffectiveRadius();
  test.ExpectNear(radius, 0.1 * diagonal, 1.0e-9, "effective radius");
  test.ExpectEqual(view.Pass->GetRadius(), 0.0, "radius stays automatic");
  view.Pass->SetRadius(radius);
  test.Expect(view.Visibility() == automatic, "the same radius set by hand gives the same V");
  view.Pass->SetRadius(1.1 * radius);
  test.Expect(!(view.Visibility() == automatic), "another radius gives another V");
  test.ExpectEqual(view.Pass->GetEffectiveRadius(), 1.1 * radius, "effective radius set by hand");
  view.Pass->SetRadius(0.0);

  // What is not seen, not opaque or not to be counted does not count.
  vtkNew<vtkCubeSource> large;
  large->SetBounds(-100, 100, -100, 100, -101, -100);
  vtkActor* wall = view.Add(large);
  view.Visibility();
  test.ExpectAtLeast(view.Pass->GetEffectiveRadius(), 20.0, "radius with a large prop");
  wall->VisibilityOff();
  view.Visibility();
  test.ExpectEqual(view.Pass->GetEffectiveRadius(), radius, "radius with a hidden prop");
  wall->VisibilityOn();
  wall->GetProperty()->SetOpacity(0.5);
  view.Visibility();
  test.ExpectEqual(view.Pass->GetEffectiveRadius(), radius, "radius with a translucent prop");
  wall->GetProperty()->SetOpacity(1.0);
  wall->UseBoundsOff();
  view.Visibility();
  test.ExpectEqual(view.Pass->GetEffectiveRadius(), radius, "radius with a prop without bounds");
  view.Renderer->RemoveActor(wall);

  // Props count also when the camera does not see them.
  view.Look({ 0.2, 0.5, 2.0 }, { 0.2, 0.5, 0.0 }, { 0, 1, 0 }, 10.0);
  view.Visibility();
  test.ExpectEqual(view.Pass->GetEffectiveRadius(), radius, "radius of a close view");
  return test.GetResult();
}
