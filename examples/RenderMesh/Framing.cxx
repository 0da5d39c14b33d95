// SPDX-License-Identifier: BSD-3-Clause
#include "Framing.h"
#include "CommandLine.h"
#include "MeshFile.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rendermesh
{
namespace
{
/// All points of the scene in the axes of the camera: to the right, up, and away from the viewer.
std::vector<vtkVector3d> PointsInAxes(vtkRenderer* renderer, const vtkVector3d axes[3])
{
  std::vector<vtkVector3d> points;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    vtkDataSet* mesh = actor->GetMapper()->GetInput();
    vtkMatrix4x4* matrix = actor->GetMatrix();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[4] = { 0.0, 0.0, 0.0, 1.0 };
      mesh->GetPoint(i, p);
      matrix->MultiplyPoint(p, p);
      const vtkVector3d world(p);
      points.emplace_back(axes[0].Dot(world), axes[1].Dot(world), axes[2].Dot(world));
    }
  }
  return points;
}

/// The nearest place from which all points are seen, in the same axes. A point is between the left
/// and right sides of the view where |x - cx| <= slope (z - cz), and likewise up and down.
vtkVector3d PlaceCamera(
  const std::vector<vtkVector3d>& points, double margin, const double slopes[2])
{
  vtkVector3d place(0.0, 0.0, Infinity);
  for (int side = 0; side < 2; ++side)
  {
    double high = -Infinity;
    double low = -Infinity;
    for (const vtkVector3d& p : points)
    {
      high = std::max(high, p[side] - slopes[side] * p[2]);
      low = std::max(low, -p[side] - slopes[side] * p[2]);
    }
    const double reach = margin * std::hypot(1.0, slopes[side]);
    place[side] = 0.5 * (high - low);
    place[2] = std::min(place[2], -0.5 * (high + low + 2.0 * reach) / slopes[side]);
  }
  // One side sets the distance. Along the other, centre what is seen by a few Newton steps.
  for (int step = 0; step < 20; ++step)
  {
    const int side = step % 2;
    double high = -Infinity;
    double low = Infinity;
    double depth = 0.0;
    for (const vtkVector3d& p : points)
    {
      const double distance = std::max(p[2] - place[2], margin);
      const double slope = (p[side] - place[side]) / distance;
      depth = slope > high || slope < low ? distance : depth;
      high = std::max(high, slope);
      low = std::min(low, slope);
    }
    place[side] += std::isfinite(high + low) ? 0.4 * (high + low) * depth : 0.0;
  }
  return place;
}

/// The camera's axes in the world: to the right, up, and away from the viewer.
void ChooseAxes(const Settings& settings, vtkVector3d axes[3])
{
  const bool yUp = IsGltf(settings.Input);
  const vtkVector3d defaultUp = yUp ? vtkVector3d(0.0, 1.0, 0.0) : vtkVector3d(0.0, 0.0, 1.0);
  const vtkVector3d defaultLook =
    yUp ? vtkVector3d(-0.5, -0.5, -0.8) : vtkVector3d(-0.5, 0.8, -0.5);
  const vtkVector3d away = settings.Look.value_or(defaultLook).Normalized();
  vtkVector3d up = settings.Up.value_or(defaultUp).Normalized();
  if (away.Cross(up).Norm() < 1e-6)
  {
    up = std::abs(away[1]) < 0.9 ? vtkVector3d(0.0, 1.0, 0.0) : vtkVector3d(1.0, 0.0, 0.0);
  }
  axes[0] = away.Cross(up).Normalized();
  axes[1] = axes[0].Cross(away);
  axes[2] = away;
}
}

//------------------------------------------------------------------------------
void FrameScene(const Settings& settings, Scene& scene)
{
  vtkVector3d axes[3];
  ChooseAxes(settings, axes);
  const std::vector<vtkVector3d> points = PointsInAxes(scene.Renderer, axes);
  vtkBoundingBox box; // in the camera's axes
  for (const vtkVector3d& p : points)
  {
    box.AddPoint(p[0], p[1], p[2]);
  }
  box.Inflate(scene.Margin);

  const double rim = 0.94; // of the picture is filled
  const double aspect = static_cast<double>(settings.Size[0]) / settings.Size[1];
  const double slope = rim * std::tan(0.5 * vtkMath::RadiansFromDegrees(settings.ViewAngle));
  const double slopes[2] = { slope * aspect, slope };
  double middle[3];
  box.GetCenter(middle);
  vtkVector3d place = settings.Parallel
    ? vtkVector3d(middle[0], middle[1], box.GetBound(4) - box.GetDiagonalLength())
    : PlaceCamera(points, scene.Margin, slopes);
  if (settings.Position)
  {
    for (int i = 0; i < 3; ++i)
    {
      place[i] = axes[i].Dot(*settings.Position);
    }
  }
  const double distance = std::max(middle[2] - place[2], 1e-6 * box.GetDiagonalLength());

  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double eye[3];
  double focus[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = axes[0][i] * place[0] + axes[1][i] * place[1] + axes[2][i] * place[2];
    focus[i] = eye[i] + axes[2][i] * distance;
  }
  camera->SetPosition(eye);
  camera->SetFocalPoint(focus);
  camera->SetViewUp(axes[1].GetData());
  camera->SetViewAngle(settings.ViewAngle);
  camera->SetParallelProjection(settings.Parallel);
  camera->SetParallelScale(0.5 * std::max(box.GetLength(1), box.GetLength(0) / aspect) / rim);
  camera->Zoom(settings.Zoom);

  double bounds[6];
  scene.Renderer->ComputeVisiblePropBounds(bounds);
  vtkBoundingBox reach(bounds);
  reach.Inflate(scene.Margin);
  reach.GetBounds(bounds);
  scene.Renderer->ResetCameraClippingRange(bounds);
}
}
