// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTestShapes.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricTorus.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestView.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <cstdlib>

namespace
{
//------------------------------------------------------------------------------
void Paint(vtkActor* actor, double red, double green, double blue, double scale)
{
  vtkProperty* property = actor->GetProperty();
  property->SetColor(red, green, blue);
  property->SetAmbient(0.3);
  property->SetDiffuse(0.7);
  // Without highlights the whole colour may be occluded, and the pass goes another way.
  property->SetSpecular(std::getenv("SSAO_TEST_MATTE") ? 0.0 : 0.2);
  property->SetSpecularPower(20.0);
  actor->SetScale(scale);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkSSAOQuad(
  const double (&origin)[3], const double (&a)[3], const double (&b)[3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double corners[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (const auto& corner : corners)
  {
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      point[i] = origin[i] + corner[0] * a[i] + corner[1] * b[i];
    }
    points->InsertNextPoint(point);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  auto quad = vtkSmartPointer<vtkPolyData>::New();
  quad->SetPoints(points);
  quad->SetPolys(triangles);
  return quad;
}

//------------------------------------------------------------------------------
vtkActor* vtkSSAOAddFloor(vtkSSAOTestView& view, double scale)
{
  const double s = 20.0 * scale;
  return view.Add(vtkSSAOQuad({ -s, 0, s }, { 2 * s, 0, 0 }, { 0, 0, -2 * s }));
}

//------------------------------------------------------------------------------
void vtkSSAOAddCorner(vtkSSAOTestView& view, double scale)
{
  const double s = 20.0 * scale;
  view.Add(vtkSSAOQuad({ -s, 0, s }, { 2 * s, 0, 0 }, { 0, 0, -s }));
  view.Add(vtkSSAOQuad({ -s, 0, 0 }, { 2 * s, 0, 0 }, { 0, s, 0 }));
}

//------------------------------------------------------------------------------
void vtkSSAOLookAtCorner(vtkSSAOTestView& view, bool parallel, double scale)
{
  const double away = 20.0 * scale;
  if (parallel)
  {
    view.LookParallel({ 0, away, away }, { 0, 0, 0 }, { 0, 1, 0 }, 4.0 * scale);
  }
  else
  {
    view.Look({ 0, 0.7 * away, 0.7 * away }, { 0, 0, 0 }, { 0, 1, 0 });
  }
}

//------------------------------------------------------------------------------
void vtkSSAOAddStillLife(vtkSSAOTestView& view, double scale)
{
  Paint(view.Add(vtkSSAOQuad({ -6, 0, 6 }, { 12, 0, 0 }, { 0, 0, -7 })), 0.8, 0.75, 0.7, scale);
  Paint(view.Add(vtkSSAOQuad({ -2, 0, -1 }, { 8, 0, 0 }, { 0, 1.6, 0 })), 0.6, 0.75, 0.85, scale);

  vtkNew<vtkCubeSource> box;
  box->SetBounds(-1.7, -0.7, 0.0, 1.0, -0.7, 0.3);
  Paint(view.Add(box), 0.85, 0.45, 0.35, scale);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.2, 0.5, 0.1);
  sphere->SetRadius(0.5);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(48);
  Paint(view.Add(sphere), 0.9, 0.85, 0.4, scale);

  vtkNew<vtkParametricTorus> torus;
  torus->SetRingRadius(0.5);
  torus->SetCrossSectionRadius(0.16);
  vtkNew<vtkParametricFunctionSource> ring;
  ring->SetParametricFunction(torus);
  ring->SetUResolution(64);
  ring->SetVResolution(32);
  vtkActor* actor = view.Add(ring);
  Paint(actor, 0.5, 0.8, 0.5, scale);
  actor->RotateX(90);
  actor->SetPosition(1.2 * scale, 0.16 * scale, 0.5 * scale);

  view.Renderer->SetBackground(0.9, 0.9, 0.95);
}

//------------------------------------------------------------------------------
void vtkSSAOLookAtStillLife(vtkSSAOTestView& view, bool parallel, double scale)
{
  const std::vector<double> from = { 1.2 * scale, 2.6 * scale, 4.6 * scale };
  const std::vector<double> at = { -0.1 * scale, 0.5 * scale, 0.0 };
  if (parallel)
  {
    view.LookParallel(from, at, { 0, 1, 0 }, 1.3 * scale);
  }
  else
  {
    view.Look(from, at, { 0, 1, 0 });
  }
}

//------------------------------------------------------------------------------
void vtkSSAOMoveScene(vtkSSAOTestView& view, const std::array<double, 3>& offset)
{
  vtkActorCollection* actors = view.Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    vtkNew<vtkTransform> transform;
    transform->Translate(offset.data());
    transform->Concatenate(actor->GetMatrix());
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetInputDataObject(actor->GetMapper()->GetInputDataObject(0, 0));
    filter->SetTransform(transform);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->Update();
    vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(filter->GetOutput());
    actor->SetPosition(0.0, 0.0, 0.0);
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->SetScale(1.0);
  }
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  double from[3];
  double at[3];
  camera->GetPosition(from);
  camera->GetFocalPoint(at);
  for (int i = 0; i < 3; ++i)
  {
    from[i] += offset[i];
    at[i] += offset[i];
  }
  camera->SetPosition(from);
  camera->SetFocalPoint(at);
  view.Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkSSAOShowOcclusionOfStillLife(vtkSSAOTestView& view)
{
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  view.Pass->SetOutputModeToOcclusion();
}

//------------------------------------------------------------------------------
void vtkSSAOAddFloorAndSpheres(
  vtkRenderer* renderer, int spheres, double radius, vtkProperty* property)
{
  const auto add = [&](vtkPolyDataAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (property)
    {
      actor->SetProperty(property);
    }
    renderer->AddActor(actor);
    return actor.Get();
  };
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.4);
  floor->SetPoint1(3.0, -1.0, -0.4);
  floor->SetPoint2(-1.0, 3.0, -0.4);
  add(floor);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  for (int i = 0; i < spheres; ++i)
  {
    add(sphere)->SetPosition(i % 3, i / 3, 0.0);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(1.0, 1.0, 0.0);
  camera->SetPosition(1.2, -1.0, 9.0);
  camera->SetClippingRange(4.0, 14.0);
}
