// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Convex bodies alone have V = 1 exactly, whatever their tessellation, normals and place.
 *
 * Low-poly spheres with smooth normals (also turned inside out, also flat), a box, a cone, a tilted
 * plane of many facets seen at grazing angles, strips, impostors; moved, rotated, scaled unevenly,
 * mirrored, and far from the origin. Then a body that is not convex must not be all 1.
 */

#include "UnitTestTruthCommon.h"

#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cstdlib>

namespace
{
using namespace TruthTest;

//------------------------------------------------------------------------------
// Smallest V over the surface in several views of all the renderer shows, in perspective and in
// parallel, with a short and an infinite radius.
double GetSmallest(vtkRenderer* renderer)
{
  double smallest = 2.0;
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const Point center = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double size =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const double elevations[] = { 0.4, 12.0, -50.0 };
  for (int i = 0; i < 12; ++i)
  {
    const double azimuth = 0.3 + 2.1 * (i / 4);
    const double elevation = elevations[i / 4] * Pi / 180.0;
    const Point position = { center[0] + 2.0 * size * std::cos(azimuth) * std::cos(elevation),
      center[1] + 2.0 * size * std::sin(azimuth) * std::cos(elevation),
      center[2] + 2.0 * size * std::sin(elevation) };
    SetCamera(renderer, i % 2 == 1, position, center, 0.45 * size, 26.0);
    renderer->GetActiveCamera()->SetClippingRange(0.1 * size, 10.0 * size);
    vtkSSAOTruthTracer tracer;
    tracer.SetRadius(i % 4 < 2 ? Infinity : 0.2 * size);
    tracer.SetRaysPerPixel(256);
    const TracedView view(renderer, 50, 40, tracer);
    int hits = 0;
    for (std::size_t pixel = 0; pixel < view.Image.Hit.size(); ++pixel)
    {
      if (view.Image.Hit[pixel])
      {
        ++hits;
        smallest = std::min(smallest, static_cast<double>(view.Image.Visibility[pixel]));
      }
    }
    if (hits == 0)
    {
      std::cout << "  no pixel shows the body in view " << i << "\n";
      return 0.0;
    }
  }
  return smallest;
}

//------------------------------------------------------------------------------
// The body as it is, and under several transforms of its actor.
bool CheckBody(const std::string& name, vtkPolyData* data, int interpolation = VTK_GOURAUD)
{
  bool good = true;
  for (int kind = 0; kind < 4; ++kind)
  {
    vtkNew<vtkRenderer> renderer;
    vtkSmartPointer<vtkActor> actor = AddPolyData(renderer, data);
    actor->GetProperty()->SetInterpolation(interpolation);
    const char* place = "in place";
    if (kind == 1)
    {
      place = "rotated and scaled unevenly";
      actor->RotateWXYZ(37.0, 1.0, 2.0, 3.0);
      actor->SetScale(3.0, 0.2, 1.0);
    }
    else if (kind == 2)
    {
      place = "mirrored";
      vtkNew<vtkTransform> mirror;
      mirror->RotateX(20.0);
      mirror->Scale(-1.0, 1.0, 1.0);
      actor->SetUserMatrix(mirror->GetMatrix());
    }
    else if (kind == 3)
    {
      place = "far away";
      actor->RotateY(11.0);
      actor->AddPosition(2683000.0, 1247000.0, 400.0);
    }
    good &= CheckNear(name + ", " + place + ", smallest V", 1.0, GetSmallest(renderer), 0.0);
  }
  return good;
}

//------------------------------------------------------------------------------
bool TestSpheres()
{
  bool good = true;
  for (int resolution : { 3, 5, 8, 24 })
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    sphere->Update();
    const std::string name = "sphere of " + std::to_string(resolution);
    good &= CheckBody(name + ", smooth", sphere->GetOutput());
    good &= CheckBody(name + ", flat", sphere->GetOutput(), VTK_FLAT);

    vtkNew<vtkReverseSense> reverse;
    reverse->SetInputConnection(sphere->GetOutputPort());
    reverse->ReverseCellsOff();
    reverse->ReverseNormalsOn();
    reverse->Update();
    good &= CheckBody(name + ", normals inwards", reverse->GetOutput());

    vtkNew<vtkStripper> stripper;
    stripper->SetInputConnection(sphere->GetOutputPort());
    stripper->Update();
    good &= CheckBody(name + ", strips", stripper->GetOutput());
  }

  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(MakePoints({ { 0.1, 0.2, 0.3 } }));
  mapper->SetRadius(0.7f);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  // A box around it that is not drawn gives the size of the view.
  vtkNew<vtkCubeSource> box;
  box->Update();
  AddPolyData(renderer, box->GetOutput())->GetProperty()->SetRepresentationToWireframe();
  good &= CheckNear("impostor, smallest V", 1.0, GetSmallest(renderer), 0.0);
  return good;
}

//------------------------------------------------------------------------------
bool TestOthers()
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(3.0);
  box->Update();
  bool good = CheckBody("box", box->GetOutput());

  // Corner normals that all three faces share.
  vtkNew<vtkPolyData> shared;
  shared->DeepCopy(MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                  { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
      { 3, 0, 4, 7 } }));
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(shared);
  normals->SplittingOff();
  normals->Update();
  good &= CheckBody("box with smooth corners", normals->GetOutput());
  normals->ComputePointNormalsOff();
  normals->ComputeCellNormalsOn();
  normals->Update();
  good &= CheckBody("box with cell normals", normals->GetOutput());

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(7);
  cone->Update();
  good &= CheckBody("cone", cone->GetOutput());

  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(60, 50);
  plane->SetNormal(0.3, -0.5, 0.8);
  plane->Update();
  good &= CheckBody("plane of 3000 quads", plane->GetOutput());
  plane->SetResolution(60, 50);
  plane->SetNormal(0.0, 0.0, 1.0);
  plane->Update();
  good &= CheckBody("level plane, grazing", plane->GetOutput());
  return good;
}

//------------------------------------------------------------------------------
// The test must be able to fail.
bool TestNotConvex()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCubeSource> box;
  box->Update();
  AddPolyData(renderer, box->GetOutput());
  AddPolyData(renderer, box->GetOutput())->AddPosition(0.8, 0.7, -0.6);
  const double smallest = GetSmallest(renderer);
  return CheckTrue(
    "two boxes that overlap have a smallest V of " + std::to_string(smallest), smallest < 0.7);
}
}

//------------------------------------------------------------------------------
int UnitTestTruthConvex(int, char*[])
{
  bool good = TestSpheres();
  good &= TestOthers();
  good &= TestNotConvex();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
