// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Scenes of simple bodies, where the visibility is known in closed form in places:
 * a sphere on a plane, the floor of a round pit, the crease of a groove, the foot of a long wall, a
 * point behind a parallel disc; and any convex body alone, which must be exactly 1.
 */

#include "vtkSSAOSceneHelpers.h"

#include "vtkPolyData.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace vtkSSAOScenes
{
namespace
{
/// Sides of what ought to be round: the area of the polygon is 0.04 % below that of the circle.
constexpr int RoundSides = 128;

//------------------------------------------------------------------------------
/**
 * The top of a plate, z = 0, open below. Above y = 0 five round pits of radius 1 and depth 1/4,
 * 1/2, 1, 2, 4, each in the middle of a square of 3 x 3; below y = 0 five V-grooves of opening
 * width 1.5 and 30, 60, 90, 120, 150 degrees between their walls, 6 long.
 */
bool AddPitsAndGrooves(Context& context)
{
  constexpr int count = 5;
  constexpr double cell = 3.0;
  constexpr double grooveHalfWidth = 0.75;
  constexpr double grooveLength = 6.0;
  constexpr double margin = 0.75;

  Mesh pits;
  double depth = 0.25;
  for (int i = 0; i < count; ++i, depth *= 2.0)
  {
    const Ring square = Outline(RoundSides, 0.0,
      [](double angle)
      { return 0.5 * cell / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle))); });
    pits.AddSpun({ square, Circle(RoundSides, 1.0, 0.0), Circle(RoundSides, 1.0, -depth),
                   Circle(RoundSides, 0.0, -depth) },
      false, { (i + 0.5) * cell, 0.5 * cell, 0.0 });
  }

  Mesh plate;
  const auto addTop = [&plate](double x0, double x1, double y0, double y1) {
    plate.AddQuad({ x0, y0, 0.0 }, { x1, y0, 0.0 }, { x1, y1, 0.0 }, { x0, y1, 0.0 });
  };
  for (int i = 0; i < count; ++i)
  {
    const double halfAngle = glm::radians(15.0 * (i + 1));
    const double bottom = -grooveHalfWidth / std::tan(halfAngle);
    const double middle = (i + 0.5) * cell;
    const double left = middle - grooveHalfWidth;
    const double right = middle + grooveHalfWidth;
    addTop(i * cell, left, -grooveLength, 0.0);
    addTop(right, (i + 1) * cell, -grooveLength, 0.0);
    plate.AddQuad({ left, -grooveLength, 0.0 }, { middle, -grooveLength, bottom },
      { middle, 0.0, bottom }, { left, 0.0, 0.0 });
    plate.AddQuad({ middle, -grooveLength, bottom }, { right, -grooveLength, 0.0 },
      { right, 0.0, 0.0 }, { middle, 0.0, bottom });
    for (const double end : { 0.0, -grooveLength })
    {
      const vtkIdType a = plate.AddPoint({ left, end, 0.0 });
      const vtkIdType b = plate.AddPoint({ middle, end, bottom });
      const vtkIdType c = plate.AddPoint({ right, end, 0.0 });
      end < 0.0 ? plate.AddTriangle(a, c, b) : plate.AddTriangle(a, b, c);
    }
  }
  const double width = count * cell;
  addTop(-margin, 0.0, -grooveLength - margin, cell + margin);
  addTop(width, width + margin, -grooveLength - margin, cell + margin);
  addTop(0.0, width, -grooveLength - margin, -grooveLength);
  addTop(0.0, width, cell, cell + margin);

  AddActor(context.Renderer, pits.GetSmooth(), Colors::Sand);
  AddActor(context.Renderer, plate.GetFlat(), Colors::Sand);
  return true;
}

//------------------------------------------------------------------------------
/// A sphere of radius 1 that touches the plane z = 0 at the origin.
bool AddSphereOnPlane(Context& context)
{
  constexpr double half = 4.0;
  Mesh plane;
  plane.AddQuad(
    { -half, -half, 0.0 }, { half, -half, 0.0 }, { half, half, 0.0 }, { -half, half, 0.0 });
  AddActor(context.Renderer, plane.GetFlat(), Colors::Stone);
  AddActor(context.Renderer, MakeSphere({ 0.0, 0.0, 1.0 }, 1.0, 128, 96), Colors::Clay);
  return true;
}

//------------------------------------------------------------------------------
/**
 * A long wall, 2 high, whose face is the plane y = 0, on a floor that reaches from it to y = -12.
 * Straight from above the wall's top, 0.25 wide, and the floor up to the radius 1 are seen. The
 * visibility at the distance s from the wall is 1 - (acos s - s sqrt(1 - s^2)) / pi, that of the
 * top 1, and the mean over the picture 1 - 0.8 * 2 / (3 pi).
 */
bool AddLongWall(Context& context)
{
  constexpr double half = 20.0;
  Mesh mesh;
  mesh.AddQuad(
    { -half, -12.0, 0.0 }, { half, -12.0, 0.0 }, { half, 0.0, 0.0 }, { -half, 0.0, 0.0 });
  mesh.AddBox({ -half, 0.0, 0.0 }, { half, 0.25, 2.0 });
  AddActor(context.Renderer, mesh.GetFlat(), Colors::Stone);
  return true;
}

//------------------------------------------------------------------------------
/**
 * A wall in the plane y = 0 that faces -y; before it, at eight gaps from 0.02 to 5, square plates
 * (upper row), discs (middle row) and spheres (lower row). Depth steps without contact.
 */
bool AddFloatingPlates(Context& context)
{
  constexpr std::array<double, 8> gaps = { 0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0 };
  constexpr double pitch = 2.4;
  constexpr double half = 0.8;
  constexpr double thickness = 0.1;
  const double width = pitch * gaps.size();

  Mesh wall;
  wall.AddQuad(
    { -0.6, 0.0, -0.6 }, { width + 0.6, 0.0, -0.6 }, { width + 0.6, 0.0, 7.8 }, { -0.6, 0.0, 7.8 });
  AddActor(context.Renderer, wall.GetFlat(), Colors::Ivory);

  Mesh plates;
  for (std::size_t i = 0; i < gaps.size(); ++i)
  {
    const double x = (i + 0.5) * pitch;
    plates.AddBox(
      { x - half, -gaps[i] - thickness, 6.0 - half }, { x + half, -gaps[i], 6.0 + half });

    Mesh disc;
    disc.AddSpun({ Circle(RoundSides, 0.0, 0.0), Circle(RoundSides, half, 0.0),
                   Circle(RoundSides, half, thickness), Circle(RoundSides, 0.0, thickness) },
      false, glm::dvec3(0.0));
    vtkSmartPointer<vtkPolyData> turned = disc.GetFlat();
    vtkPoints* points = turned->GetPoints();
    for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
    {
      // A quarter turn about x: the disc's axis z becomes -y.
      const glm::dvec3 q(points->GetPoint(p)[0], points->GetPoint(p)[1], points->GetPoint(p)[2]);
      points->SetPoint(p, x + q.x, -gaps[i] - q.z, 3.6 + q.y);
    }
    AddActor(context.Renderer, WithNormals(turned, 30.0), Colors::Slate);
    AddActor(context.Renderer, MakeSphere({ x, -gaps[i] - half, 1.2 }, half, 64, 48), Colors::Clay);
  }
  AddActor(context.Renderer, plates.GetFlat(), Colors::Sage);
  return true;
}

//------------------------------------------------------------------------------
/**
 * A room of 4 x 4 x 3, open towards -y, of five slabs that reach into one another at the edges; two
 * boxes and a sphere on the floor, a shelf on the back wall. Flat shading throughout, but the
 * sphere.
 */
bool AddCornerRoom(Context& context)
{
  constexpr double t = 0.1;
  Mesh floor;
  floor.AddBox({ -2.0 - t, -2.0, -t }, { 2.0 + t, 2.0 + t, 0.0 });
  floor.AddBox({ -2.0 - t, -2.0, 3.0 }, { 2.0 + t, 2.0 + t, 3.0 + t });
  floor.AddBox({ -2.0 - t, 2.0, -t }, { 2.0 + t, 2.0 + t, 3.0 + t });
  AddActor(context.Renderer, floor.GetFlat(), Colors::Ivory);
  Mesh left;
  left.AddBox({ -2.0 - t, -2.0, -t }, { -2.0, 2.0 + t, 3.0 + t });
  AddActor(context.Renderer, left.GetFlat(), Colors::Rose);
  Mesh right;
  right.AddBox({ 2.0, -2.0, -t }, { 2.0 + t, 2.0 + t, 3.0 + t });
  AddActor(context.Renderer, right.GetFlat(), Colors::Sage);

  const auto place = [](double x, double y, double degrees)
  {
    return glm::rotate(glm::translate(glm::dmat4(1.0), { x, y, 0.0 }), glm::radians(degrees),
      glm::dvec3(0.0, 0.0, 1.0));
  };
  Mesh boxes;
  boxes.AddBox({ -0.55, -0.55, 0.0 }, { 0.55, 0.55, 1.7 }, place(-0.8, 0.9, 18.0));
  boxes.AddBox({ -0.5, -0.5, 0.0 }, { 0.5, 0.5, 0.8 }, place(0.75, -0.1, -17.0));
  boxes.AddBox({ 0.6, 1.6, 1.7 }, { 2.0, 2.0, 1.8 });
  boxes.AddBox({ 0.6, 1.6, 2.1 }, { 2.0, 2.0, 2.2 });
  AddActor(context.Renderer, boxes.GetFlat(), Colors::Sand);
  AddActor(context.Renderer, MakeSphere({ -0.75, -0.75, 0.4 }, 0.4, 64, 48), Colors::Slate);
  ShareWithAmbient(context.Renderer, 0.3);
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<Scene> AnalyticScenes()
{
  return {
    { { "pits_grooves", Kind::Analytic,
        "Plate with round pits, depth 1/4 to 4 radii, and V-grooves of 30 to 150 degrees", 2.0 },
      { { { 7.5, -15.5, 20.0 }, { 7.5, -1.6, -0.9 } },
        { { 17.0, -11.5, 7.0 }, { 9.0, -2.2, -0.6 } } },
      AddPitsAndGrooves },
    { { "sphere_on_plane", Kind::Analytic, "Sphere of radius 1 on a plane", 1.5 },
      { { { 3.5, -5.5, 4.5 }, { 0.0, 0.0, 0.6 } }, { { 0.0, -5.5, 2.3 }, { 0.0, 0.0, 0.7 } } },
      AddSphereOnPlane },
    { { "long_wall", Kind::Analytic, "Long wall on a floor, seen from above and from the side",
        1.0 },
      { { { 0.0, -0.375, 6.0 }, { 0.0, -0.375, 0.0 }, { 0.0, 1.0, 0.0 }, 30.0, 1.25 },
        { { -2.0, -7.0, 3.0 }, { 0.0, -0.6, 0.4 } } },
      AddLongWall },
    { { "floating_plates", Kind::Analytic,
        "Plates, discs and spheres that float 0.02 to 5 before a wall", 1.5 },
      { { { 13.0, -28.0, 12.0 }, { 10.4, -1.0, 3.4 } },
        { { -3.5, -12.0, 7.0 }, { 6.8, 0.0, 3.4 } } },
      AddFloatingPlates },
    { { "corner_room", Kind::Analytic, "Open room of slabs with two boxes, a shelf and a sphere",
        0.6 },
      { { { -1.2, -7.2, 2.5 }, { 0.1, 0.0, 1.3 } }, { { -1.5, -2.8, 2.6 }, { 0.8, 1.0, 0.9 } } },
      AddCornerRoom },
  };
}
}
