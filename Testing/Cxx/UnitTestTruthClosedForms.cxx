// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ray-traced visibility against closed forms, in perspective and in parallel.
 *
 * Sphere on a plane, round pit, long wall, V-groove, disc over a plane, unlimited; wall and pit
 * with a cutoff. Off the axis of a disc its form factor is Howell, "A Catalog of Radiation Heat
 * Transfer Configuration Factors", B-13. Then the test shows that it can fail: without the cosine
 * weight, and without the cutoff, the same comparisons are far off.
 */

#include "UnitTestTruthCommon.h"

#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPropCollection.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace
{
using namespace TruthTest;

const double Tolerance = 0.003;

// Far enough for "infinite": what is beyond changes V by about (1 / Far)^2.
const double Far = 1000.0;

// Visibility expected at a point of the scene; NaN where the closed form does not apply.
typedef std::function<double(const Point&)> ClosedForm;

//------------------------------------------------------------------------------
// Part of the cosine-weighted hemisphere that a disc of radius r fills, at height h above the point
// and parallel to its surface, its axis at distance a.
double DiscFactor(double r, double h, double a)
{
  const double sum = a * a + h * h + r * r;
  return 0.5 * (1.0 - (sum - 2.0 * r * r) / std::sqrt(sum * sum - 4.0 * a * a * r * r));
}

/**
 * How far a traced view is from a closed form.
 */
struct Comparison
{
  int Pixels = 0;
  /// Largest mean difference over the pixels of a tenth of the range of V, so that errors of
  /// opposite sign at different places do not cancel.
  double LargestMean = 0.0;
  /// Root mean square difference, and what the standard errors predict for it.
  double RootMeanSquare = 0.0;
  double Predicted = 0.0;
};

//------------------------------------------------------------------------------
Comparison Compare(const TracedView& view, const ClosedForm& expected)
{
  const int bins = 10;
  std::vector<double> sums(bins, 0.0);
  std::vector<int> counts(bins, 0);
  Comparison result;
  for (std::size_t i = 0; i < view.Positions.size(); ++i)
  {
    const double value = view.Image.Hit[i] ? expected(view.Positions[i]) : std::nan("");
    if (std::isnan(value))
    {
      continue;
    }
    const double difference = view.Image.Visibility[i] - value;
    const int bin = std::min(bins - 1, static_cast<int>(bins * value));
    sums[bin] += difference;
    ++counts[bin];
    ++result.Pixels;
    result.RootMeanSquare += difference * difference;
    result.Predicted += std::pow(view.Image.StandardError[i], 2);
  }
  for (int bin = 0; bin < bins; ++bin)
  {
    if (counts[bin] >= 20)
    {
      result.LargestMean = std::max(result.LargestMean, std::abs(sums[bin] / counts[bin]));
    }
  }
  result.RootMeanSquare = std::sqrt(result.RootMeanSquare / result.Pixels);
  result.Predicted = std::sqrt(result.Predicted / result.Pixels);
  return result;
}

//------------------------------------------------------------------------------
vtkSSAOTruthTracer MakeTracer(double radius)
{
  vtkSSAOTruthTracer tracer;
  tracer.SetRadius(radius);
  tracer.SetRaysPerPixel(1024);
  return tracer;
}

//------------------------------------------------------------------------------
bool Check(
  const std::string& name, vtkRenderer* renderer, double radius, const ClosedForm& expected)
{
  const TracedView view(renderer, 33, 25, MakeTracer(radius));
  const Comparison result = Compare(view, expected);
  bool good = view.Good && result.Pixels >= 100;
  good &= CheckNear(name + ", mean difference", 0.0, result.LargestMean, Tolerance);
  // No pixel may be far off, and the standard error must be honest.
  good &= CheckNear(name + ", RMS difference of a pixel", result.Predicted, result.RootMeanSquare,
    0.15 * result.Predicted + 1e-4);
  return good;
}

//------------------------------------------------------------------------------
// The same in perspective and in parallel, from one position.
bool CheckBoth(const std::string& name, vtkRenderer* renderer, const Point& position,
  const Point& focalPoint, double scale, double radius, const ClosedForm& expected)
{
  const double distance = std::sqrt(std::pow(position[0] - focalPoint[0], 2) +
    std::pow(position[1] - focalPoint[1], 2) + std::pow(position[2] - focalPoint[2], 2));
  const double angle = 2.0 * 180.0 / Pi * std::atan(scale / distance);
  SetCamera(renderer, false, position, focalPoint, scale, angle);
  bool good = Check(name + ", perspective", renderer, radius, expected);
  SetCamera(renderer, true, position, focalPoint, scale, angle);
  good &= Check(name + ", parallel", renderer, radius, expected);
  return good;
}

//------------------------------------------------------------------------------
// A round wall from z = -depth to 0 about the z axis.
vtkSmartPointer<vtkPolyData> MakeTube(double radius, double depth)
{
  const int sides = 720;
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> quads;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * Pi * i / sides;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), -depth });
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
    const vtkIdType next = (i + 1) % sides;
    quads.push_back({ 2 * i, 2 * next, 2 * next + 1, 2 * i + 1 });
  }
  return MakePolygons(points, quads);
}

//------------------------------------------------------------------------------
// A disc z = height about the z axis, as one polygon.
vtkSmartPointer<vtkPolyData> MakeDisc(double radius, double height)
{
  std::vector<Point> points;
  std::vector<vtkIdType> polygon;
  for (int i = 0; i < 720; ++i)
  {
    const double angle = 2.0 * Pi * i / 720;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), height });
    polygon.push_back(i);
  }
  return MakePolygons(points, { polygon });
}

//------------------------------------------------------------------------------
double SphereOnPlane(const Point& point)
{
  const double x = std::hypot(point[0], point[1]);
  return std::abs(point[2]) < 1e-4 && x > 0.3 && x < 5.0 ? 1.0 - 1.0 / std::pow(x * x + 1.0, 1.5)
                                                         : std::nan("");
}

//------------------------------------------------------------------------------
// The sphere of radius 1 that touches the floor: a mesh (0), glyphs (1), impostors (2).
vtkSmartPointer<vtkRenderer> MakeSphereOnPlane(int kind)
{
  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, MakeFloor(Far, 0.0));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(kind == 0 ? 400 : 6);
  sphere->SetPhiResolution(kind == 0 ? 200 : 6);
  sphere->SetRadius(kind == 0 ? 1.0 : 0.25);
  sphere->SetCenter(0.0, 0.0, kind == 0 ? 1.0 : 0.0);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  if (kind == 0)
  {
    AddPolyData(renderer, sphere->GetOutput());
    return renderer;
  }

  vtkSmartPointer<vtkPolyData> data = MakePoints({ { 0.0, 0.0, kind == 1 ? 0.5 : 1.0 } });
  vtkNew<vtkActor> actor;
  if (kind == 1)
  {
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetSourceConnection(sphere->GetOutputPort());
    mapper->SetScaleFactor(2.0);
    actor->SetMapper(mapper);
    actor->SetScale(2.0); // radius 2 x 2 x 0.25 at height 2 x 0.5
  }
  else
  {
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetRadius(1.0f);
    actor->SetMapper(mapper);
  }
  renderer->AddActor(actor);
  return renderer;
}

//------------------------------------------------------------------------------
bool TestSphereOnPlane()
{
  const char* names[] = { "mesh", "glyph", "impostor" };
  bool good = true;
  for (int kind = 0; kind < 3; ++kind)
  {
    good &= CheckBoth(std::string("sphere on plane, ") + names[kind], MakeSphereOnPlane(kind),
      { 0.0, -6.0, 5.0 }, { 0.0, -1.0, 0.0 }, 2.5, Infinity, SphereOnPlane);
  }
  return good;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakePit(double depth)
{
  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, MakeTube(1.0, depth));
  AddPolyData(renderer, MakeDisc(1.0, -depth));
  return renderer;
}

//------------------------------------------------------------------------------
bool TestPit()
{
  bool good = true;
  for (double depth : { 0.25, 1.0, 2.0 })
  {
    const std::string name = "round pit, depth " + std::to_string(depth);
    const ClosedForm floor = [depth](const Point& point)
    {
      const double a = std::hypot(point[0], point[1]);
      return std::abs(point[2] + depth) < 1e-4 && a < 0.95 ? DiscFactor(1.0, depth, a)
                                                           : std::nan("");
    };
    good &= CheckBoth(
      name, MakePit(depth), { 0.0, -0.3, 4.0 }, { 0.0, 0.0, -depth }, 0.9, Infinity, floor);
    good &= CheckBoth(name + ", centre", MakePit(depth), { 0.0, -0.3, 4.0 }, { 0.0, 0.0, -depth },
      0.01, Infinity, [depth](const Point&) { return 1.0 / (1.0 + depth * depth); });
  }
  for (double radius : { 0.9, 1.1, 1.3, 2.0 })
  {
    good &= CheckBoth("round pit, depth 1, centre, R " + std::to_string(radius), MakePit(1.0),
      { 0.0, -0.3, 4.0 }, { 0.0, 0.0, -1.0 }, 0.01, radius,
      [radius](const Point&) { return std::min(1.0, std::max(0.5, 1.0 / (radius * radius))); });
  }
  return good;
}

//------------------------------------------------------------------------------
// Floor z = 0 and a wall x = 0 of height 1.
vtkSmartPointer<vtkRenderer> MakeWall()
{
  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, MakeFloor(Far, 0.0));
  AddPolyData(renderer,
    MakePolygons({ { 0.0, -Far, 0.0 }, { 0.0, Far, 0.0 }, { 0.0, Far, 1.0 }, { 0.0, -Far, 1.0 } },
      { { 0, 1, 2, 3 } }));
  return renderer;
}

//------------------------------------------------------------------------------
double WallWithCutoff(const Point& point, double radius)
{
  const double s = point[0] / radius;
  if (std::abs(point[2]) > 1e-4 || s <= 0.01)
  {
    return std::nan("");
  }
  return s >= 1.0 ? 1.0 : 1.0 - (std::acos(s) - s * std::sqrt(1.0 - s * s)) / Pi;
}

//------------------------------------------------------------------------------
bool TestWall()
{
  const Point position = { 3.0, -2.0, 2.5 };
  const Point focalPoint = { 0.6, 0.0, 0.0 };
  bool good = CheckBoth("long wall", MakeWall(), position, focalPoint, 1.0, Infinity,
    [](const Point& point)
    {
      const double x = point[0];
      return std::abs(point[2]) < 1e-4 && x > 0.01 ? 0.5 * (1.0 + x / std::sqrt(x * x + 1.0))
                                                   : std::nan("");
    });
  for (double radius : { 0.5, 1.0 })
  {
    good &= CheckBoth("long wall, R " + std::to_string(radius), MakeWall(), position, focalPoint,
      1.0, radius, [radius](const Point& point) { return WallWithCutoff(point, radius); });
  }

  // The same where a float is worth 0.25.
  const Point place = { 2683000.0, 1247000.0, 400.0 };
  vtkSmartPointer<vtkRenderer> far = MakeWall();
  vtkPropCollection* props = far->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    vtkActor::SafeDownCast(props->GetItemAsObject(i))->AddPosition(place[0], place[1], place[2]);
  }
  good &= CheckBoth("long wall, far away, R 1", far,
    { place[0] + position[0], place[1] + position[1], place[2] + position[2] },
    { place[0] + focalPoint[0], place[1] + focalPoint[1], place[2] + focalPoint[2] }, 1.0, 1.0,
    [&place](const Point& point)
    {
      const Point local = { point[0] - place[0], point[1] - place[1], point[2] - place[2] };
      return WallWithCutoff(local, 1.0);
    });
  return good;
}

//------------------------------------------------------------------------------
bool TestGroove()
{
  bool good = true;
  for (double degrees : { 30.0, 60.0, 90.0, 120.0, 150.0 })
  {
    const double angle = degrees * Pi / 180.0;
    const double x = Far * std::sin(0.5 * angle);
    const double z = Far * std::cos(0.5 * angle);
    vtkNew<vtkRenderer> renderer;
    AddPolyData(renderer,
      MakePolygons({ { 0.0, -Far, 0.0 }, { 0.0, Far, 0.0 }, { x, -Far, z }, { x, Far, z },
                     { -x, -Far, z }, { -x, Far, z } },
        { { 0, 1, 3, 2 }, { 0, 4, 5, 1 } }));
    // A groove without an end looks the same from every point of it.
    good &= CheckBoth("V-groove, " + std::to_string(degrees) + " degrees", renderer,
      { 0.02, -1.0, 2.0 }, { 0.0, 0.0, 0.0 }, 0.3, Infinity,
      [angle](const Point&) { return 0.5 * (1.0 - std::cos(angle)); });
  }
  return good;
}

//------------------------------------------------------------------------------
bool TestDisc()
{
  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, MakeFloor(Far, 0.0));
  AddPolyData(renderer, MakeDisc(1.0, 0.7));
  const Point position = { 0.0, -4.0, 0.6 };
  const Point focalPoint = { 0.0, 0.0, 0.0 };
  bool good = CheckBoth("disc over plane", renderer, position, focalPoint, 1.0, Infinity,
    [](const Point& point)
    {
      const double a = std::hypot(point[0], point[1]);
      return std::abs(point[2]) < 1e-3 && a < 6.0 ? 1.0 - DiscFactor(1.0, 0.7, a) : std::nan("");
    });
  good &= CheckBoth("disc over plane, centre", renderer, position, focalPoint, 0.005, Infinity,
    [](const Point&) { return 0.49 / (0.49 + 1.0); });
  return good;
}

//------------------------------------------------------------------------------
// The comparison must notice a wrong definition.
bool TestSensitivity()
{
  const double margin = 10.0 * Tolerance;
  vtkSmartPointer<vtkRenderer> sphere = MakeSphereOnPlane(0);
  SetCamera(sphere, false, { 0.0, -6.0, 5.0 }, { 0.0, -1.0, 0.0 }, 2.5, 36.0);
  vtkSSAOTruthTracer unweighted = MakeTracer(Infinity);
  unweighted.SetCosineWeight(false);
  double error = Compare(TracedView(sphere, 65, 49, unweighted), SphereOnPlane).LargestMean;
  bool good = CheckTrue("without the cosine weight the sphere on a plane is off by " +
      std::to_string(error) + ", more than " + std::to_string(margin),
    error > margin);

  vtkSmartPointer<vtkRenderer> wall = MakeWall();
  SetCamera(wall, false, { 3.0, -2.0, 2.5 }, { 0.6, 0.0, 0.0 }, 1.0, 29.0);
  const ClosedForm form = [](const Point& point) { return WallWithCutoff(point, 0.5); };
  for (int i = 0; i < 2; ++i)
  {
    vtkSSAOTruthTracer tracer = MakeTracer(0.5);
    tracer.SetCosineWeight(i != 0);
    tracer.SetCutoff(i == 0);
    error = Compare(TracedView(wall, 33, 25, tracer), form).LargestMean;
    good &= CheckTrue(std::string("without the ") + (i == 0 ? "cosine weight" : "cutoff") +
        " the wall with a cutoff is off by " + std::to_string(error) + ", more than " +
        std::to_string(margin),
      error > margin);
  }
  return good;
}
}

//------------------------------------------------------------------------------
int UnitTestTruthClosedForms(int, char*[])
{
  bool good = TestSphereOnPlane();
  good &= TestPit();
  good &= TestWall();
  good &= TestGroove();
  good &= TestDisc();
  good &= TestSensitivity();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
