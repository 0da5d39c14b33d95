// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the tests of the ray-traced reference share: small scenes, tracing, checks that
 * print.
 */

#ifndef UnitTestTruthCommon_h
#define UnitTestTruthCommon_h

#include "vtkSSAOTruthCamera.h"
#include "vtkSSAOTruthImage.h"
#include "vtkSSAOTruthScene.h"
#include "vtkSSAOTruthTracer.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace TruthTest
{
const double Infinity = std::numeric_limits<double>::infinity();
const double Pi = 3.14159265358979323846;

typedef std::array<double, 3> Point;

//------------------------------------------------------------------------------
// Prints what was expected and what was found; true if they differ by no more than the tolerance.
inline bool CheckNear(
  const std::string& what, double expected, double actual, double tolerance, bool quiet = false)
{
  const bool good = std::abs(actual - expected) <= tolerance;
  if (!good || !quiet)
  {
    std::cout << (good ? "  ok   " : "  FAIL ") << what << ": expected " << expected << ", actual "
              << actual << ", tolerance " << tolerance << "\n";
  }
  return good;
}

//------------------------------------------------------------------------------
inline bool CheckTrue(const std::string& what, bool actual)
{
  std::cout << (actual ? "  ok   " : "  FAIL ") << what << "\n";
  return actual;
}

//------------------------------------------------------------------------------
inline vtkSmartPointer<vtkActor> AddPolyData(vtkRenderer* renderer, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
// Polygons over shared points.
inline vtkSmartPointer<vtkPolyData> MakePolygons(
  const std::vector<Point>& points, const std::vector<std::vector<vtkIdType>>& polygons)
{
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  for (const Point& point : points)
  {
    vtkpoints->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const std::vector<vtkIdType>& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtkpoints);
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
// A square floor z = height, centred at the origin.
inline vtkSmartPointer<vtkPolyData> MakeFloor(double halfSize, double height)
{
  return MakePolygons({ { -halfSize, -halfSize, height }, { halfSize, -halfSize, height },
                        { halfSize, halfSize, height }, { -halfSize, halfSize, height } },
    { { 0, 1, 2, 3 } });
}

//------------------------------------------------------------------------------
// Points, each with a vertex: VTK does not draw a prop whose data has no cells.
inline vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<Point>& points)
{
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const Point& point : points)
  {
    const vtkIdType id = vtkpoints->InsertNextPoint(point.data());
    vertices->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(vtkpoints);
  data->SetVerts(vertices);
  return data;
}

//------------------------------------------------------------------------------
inline void SetCamera(vtkRenderer* renderer, bool parallel, const Point& position,
  const Point& focalPoint, double parallelScale, double viewAngle)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(0.02, 1.0, 0.3);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(parallelScale);
  camera->SetViewAngle(viewAngle);
  camera->SetClippingRange(0.01, 1000.0);
  renderer->SetActiveCamera(camera);
}

/**
 * A traced view and where its pixels are in the world.
 */
struct TracedView
{
  vtkSSAOTruthScene Scene;
  vtkSSAOTruthImage Image;
  std::vector<Point> Positions;
  bool Good = false;

  TracedView(vtkRenderer* renderer, int width, int height, const vtkSSAOTruthTracer& tracer)
  {
    this->Scene.Gather(renderer);
    const vtkSSAOTruthCamera camera(
      renderer->GetActiveCamera(), width, height, this->Scene.GetOrigin());
    this->Good = tracer.Trace(this->Scene, camera, this->Image);
    this->Positions.resize(this->Image.Hit.size());
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
        Point& point = this->Positions[pixel];
        camera.GetPoint(x, y, this->Image.Depth[pixel], point.data());
        for (int axis = 0; axis < 3; ++axis)
        {
          point[axis] += this->Scene.GetOrigin()[axis];
        }
      }
    }
  }
};
}

#endif
