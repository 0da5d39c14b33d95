// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Scenes of computed geometry, one function each.
 */

#include "vtkSSAOSceneHelpers.h"

#include "vtkAppendPolyData.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vtkSSAOScenes
{
namespace
{
//------------------------------------------------------------------------------
void AddGround(
  Context& context, double x0, double x1, double y0, double y1, const glm::dvec3& color)
{
  Mesh ground;
  ground.AddQuad({ x0, y0, 0.0 }, { x1, y0, 0.0 }, { x1, y1, 0.0 }, { x0, y1, 0.0 });
  AddActor(context.Renderer, ground.GetFlat(), color);
}

//------------------------------------------------------------------------------
/**
 * 200 spheres of radius 0.2 to 0.5 dropped one after the other onto a plane: each is let down at
 * 24 random places and stays at the lowest.
 */
bool AddSpherePack(Context& context)
{
  constexpr double floorRadius = 3.6;
  Random random(1);
  vtkNew<vtkAppendPolyData> heap;
  std::vector<glm::dvec4> spheres;
  // The height at which a sphere let down at (x, y) first touches something.
  const auto restingHeight = [&spheres](double x, double y, double radius)
  {
    double height = radius;
    for (const glm::dvec4& other : spheres)
    {
      const double reach = other.w + radius;
      const double below =
        reach * reach - (x - other.x) * (x - other.x) - (y - other.y) * (y - other.y);
      if (below > 0.0)
      {
        height = std::max(height, other.z + std::sqrt(below));
      }
    }
    return height;
  };
  for (int i = 0; i < 200; ++i)
  {
    const double radius = random.Range(0.2, 0.5);
    glm::dvec4 lowest(0.0, 0.0, 1e9, radius);
    for (int trial = 0; trial < 24; ++trial)
    {
      const double distance = (floorRadius - radius) * std::sqrt(random.Unit());
      const double angle = random.Range(0.0, glm::two_pi<double>());
      const double x = distance * std::cos(angle);
      const double y = distance * std::sin(angle);
      const double height = restingHeight(x, y, radius);
      if (height < lowest.z)
      {
        lowest = { x, y, height, radius };
      }
    }
    spheres.push_back(lowest);
    vtkSmartPointer<vtkPolyData> sphere = MakeSphere(glm::dvec3(lowest), radius, 32, 16);
    Paint(sphere, PaletteColor(i));
    heap->AddInputData(sphere);
  }
  heap->Update();
  AddColoredActor(context.Renderer, heap->GetOutput());
  AddGround(context, -4.5, 4.5, -4.5, 4.5, Colors::Stone);
  return true;
}

//------------------------------------------------------------------------------
/// The zero surface of a function over the cube [-half, half]^3, its normals from the gradient.
vtkSmartPointer<vtkPolyData> ZeroSurface(
  int samples, double half, const std::function<float(const glm::dvec3&)>& function)
{
  const double spacing = 2.0 * half / (samples - 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(samples, samples, samples);
  image->SetOrigin(-half, -half, -half);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  values->SetNumberOfTuples(static_cast<vtkIdType>(samples) * samples * samples);
  vtkIdType index = 0;
  for (int k = 0; k < samples; ++k)
  {
    for (int j = 0; j < samples; ++j)
    {
      for (int i = 0; i < samples; ++i)
      {
        const glm::dvec3 point = glm::dvec3(i, j, k) * spacing - half;
        values->SetValue(index++, function(point));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

//------------------------------------------------------------------------------
double Gyroid(const glm::dvec3& p)
{
  return std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) +
    std::sin(p.z) * std::cos(p.x);
}

//------------------------------------------------------------------------------
/// Two periods of the gyroid each way: an open surface that ends at the sides of a cube.
bool AddGyroid(Context& context)
{
  const auto surface = ZeroSurface(
    81, glm::two_pi<double>(), [](const glm::dvec3& p) { return static_cast<float>(Gyroid(p)); });
  AddActor(context.Renderer, surface, Colors::Clay);
  return true;
}

//------------------------------------------------------------------------------
/// The part of a ball on one side of the gyroid: a closed solid, wound outwards.
bool AddGyroidSolid(Context& context)
{
  constexpr double radius = 7.0;
  // A smooth minimum of the two fields rounds the rim to about two cells of the grid.
  constexpr double rounding = 0.25;
  const auto surface = ZeroSurface(121, 1.02 * radius,
    [](const glm::dvec3& p)
    {
      const double inGyroid = Gyroid(p) + 0.3;
      const double inBall = radius - glm::length(p);
      const double apart = std::abs(inGyroid - inBall);
      return static_cast<float>(
        std::min(inGyroid, inBall) - rounding * std::log1p(std::exp(-apart / rounding)));
    });
  AddActor(context.Renderer, surface, Colors::Sage);
  return true;
}

//------------------------------------------------------------------------------
/// Menger sponge of level 3 and side 3: the faces between full and empty cells of a 27^3 grid.
bool AddMenger(Context& context)
{
  constexpr int cells = 27;
  const auto isFull = [](const glm::ivec3& cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (cell[axis] < 0 || cell[axis] >= cells)
      {
        return false;
      }
    }
    for (int size = 1; size < cells; size *= 3)
    {
      const glm::ivec3 digit = (cell / size) % 3;
      if ((digit.x == 1) + (digit.y == 1) + (digit.z == 1) > 1)
      {
        return false;
      }
    }
    return true;
  };
  Mesh sponge;
  for (int index = 0; index < cells * cells * cells; ++index)
  {
    const glm::ivec3 cell(index % cells, index / cells % cells, index / (cells * cells));
    if (!isFull(cell))
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        glm::ivec3 neighbor = cell;
        neighbor[axis] += 2 * side - 1;
        if (isFull(neighbor))
        {
          continue;
        }
        // The face's edges u and v, with u x v along the outward normal.
        glm::dvec3 u(0.0);
        glm::dvec3 v(0.0);
        u[(axis + (side ? 1 : 2)) % 3] = 1.0;
        v[(axis + (side ? 2 : 1)) % 3] = 1.0;
        glm::dvec3 corner = cell;
        corner[axis] += side;
        constexpr double scale = 3.0 / cells;
        sponge.AddQuad(
          corner * scale, (corner + u) * scale, (corner + u + v) * scale, (corner + v) * scale);
      }
    }
  }
  AddActor(context.Renderer, sponge.GetFlat(), Colors::Sand);
  return true;
}

//------------------------------------------------------------------------------
/// Velocity of a whirl whose axis bends: round the axis, inwards below, outwards above, and up.
glm::dvec3 Tornado(const glm::dvec3& p)
{
  const glm::dvec2 axis(0.35 * std::sin(1.1 * p.z), 0.35 * std::cos(1.3 * p.z) - 0.35);
  const glm::dvec2 d = glm::dvec2(p) - axis;
  const double radius = glm::length(d) + 1e-3;
  const double swirl = 1.0 / (0.3 + radius);
  const double outward = 0.12 * (p.z - 1.6);
  return { -d.y * swirl + outward * d.x, d.x * swirl + outward * d.y, 0.1 + 0.25 / (0.5 + radius) };
}

//------------------------------------------------------------------------------
/// Stream lines of a whirl, by the classical Runge-Kutta method, as tubes.
bool AddStreamTubes(Context& context)
{
  constexpr int lines = 40;
  constexpr int steps = 400;
  constexpr double stepLength = 0.05;
  constexpr double largestDistance = 2.4;
  const auto direction = [](const glm::dvec3& p) { return glm::normalize(Tornado(p)); };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int line = 0; line < lines; ++line)
  {
    // Starting points on a golden-angle spiral.
    const double angle = line * glm::pi<double>() * (3.0 - std::sqrt(5.0));
    const double distance = 1.9 * std::sqrt((line + 0.5) / lines);
    glm::dvec3 p(distance * std::cos(angle), distance * std::sin(angle), 0.0);
    std::vector<vtkIdType> ids;
    for (int step = 0; step < steps && p.z < 4.5 && glm::length(glm::dvec2(p)) < largestDistance;
         ++step)
    {
      ids.push_back(points->InsertNextPoint(p.x, p.y, p.z));
      const glm::dvec3 k1 = direction(p);
      const glm::dvec3 k2 = direction(p + 0.5 * stepLength * k1);
      const glm::dvec3 k3 = direction(p + 0.5 * stepLength * k2);
      const glm::dvec3 k4 = direction(p + stepLength * k3);
      p += stepLength / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  vtkNew<vtkPolyData> streamLines;
  streamLines->SetPoints(points);
  streamLines->SetLines(cells);
  AddTubes(context.Renderer, streamLines, 0.05, Colors::Slate);
  return true;
}

//------------------------------------------------------------------------------
// Where a gear stands and how it is turned.
struct Gear
{
  glm::dvec2 Center;
  int Teeth;
  double Phase;
};

/// Tooth pitch on the pitch circle: it makes gears of any number of teeth mesh.
constexpr double ToothPitch = 0.55;

//------------------------------------------------------------------------------
double PitchRadius(int teeth)
{
  return ToothPitch * teeth / glm::two_pi<double>();
}

//------------------------------------------------------------------------------
/// The gear that meshes with another one in the given direction (degrees).
Gear NextGear(const Gear& gear, int teeth, double degrees)
{
  const double angle = glm::radians(degrees);
  const double distance = PitchRadius(gear.Teeth) + PitchRadius(teeth);
  // Share of a tooth's period at the contact. Gaps lie at 1/8, teeth at 5/8 of it, and the two
  // gears run through it in opposite senses, so the shares add up to 6/8.
  const double share = (angle - gear.Phase) * gear.Teeth / glm::two_pi<double>();
  const double phase = angle + glm::pi<double>() - (0.75 - share) * glm::two_pi<double>() / teeth;
  return { gear.Center + distance * glm::dvec2(std::cos(angle), std::sin(angle)), teeth, phase };
}

//------------------------------------------------------------------------------
/// A toothed rim, a thinner web and a hub with a hole; closed.
vtkSmartPointer<vtkPolyData> MakeGear(const Gear& gear)
{
  const int sides = 8 * gear.Teeth;
  const double pitchRadius = PitchRadius(gear.Teeth);
  const auto teeth = [sides, pitchRadius](double angle)
  {
    constexpr double profile[8] = { -0.2, -0.2, -0.2, -0.02, 0.16, 0.16, 0.16, -0.02 };
    return pitchRadius + profile[std::lround(angle * sides / glm::two_pi<double>()) % 8];
  };
  const double rim = pitchRadius - 0.45;
  constexpr double hub = 0.45;
  constexpr double hole = 0.2;
  Mesh mesh;
  mesh.AddSpun({ Outline(sides, 0.12, teeth), Outline(sides, 0.6, teeth), Circle(sides, rim, 0.6),
                 Circle(sides, rim, 0.3), Circle(sides, hub, 0.3), Circle(sides, hub, 0.75),
                 Circle(sides, hole, 0.75), Circle(sides, hole, 0.12) },
    true, { gear.Center, 0.0 }, gear.Phase);
  return mesh.GetSmooth();
}

//------------------------------------------------------------------------------
/// A nut of width across flats w and the end of a bolt in it.
void AddNut(Context& context, const glm::dvec3& place, double w, double phase)
{
  constexpr int sides = 48;
  const auto hexagon = [w](double angle)
  {
    const double sixth = glm::pi<double>() / 3.0;
    return 0.5 * w / std::cos(std::fmod(angle, sixth) - 0.5 * sixth);
  };
  const double hole = 0.28 * w;
  const double height = 0.5 * w;
  Mesh nut;
  nut.AddSpun({ Outline(sides, 0.0, hexagon), Outline(sides, 0.88 * height, hexagon),
                Circle(sides, 0.48 * w, height), Circle(sides, 1.15 * hole, height),
                Circle(sides, hole, 0.9 * height), Circle(sides, hole, 0.0) },
    true, place, phase);
  AddActor(context.Renderer, nut.GetSmooth(20.0), Colors::Ochre);
  Mesh bolt;
  bolt.AddSpun({ Circle(sides, 0.96 * hole, 0.0), Circle(sides, 0.96 * hole, 1.2 * height),
                 Circle(sides, 0.8 * hole, 1.3 * height), Circle(sides, 0.0, 1.3 * height) },
    false, place);
  AddActor(context.Renderer, bolt.GetSmooth(), Colors::Stone);
}

//------------------------------------------------------------------------------
/// Five meshing gears on pins before a plate, with nuts on it.
bool AddGears(Context& context)
{
  std::vector<Gear> gears = { { { 0.0, 0.0 }, 24, 0.0 } };
  gears.push_back(NextGear(gears[0], 14, 20.0));
  gears.push_back(NextGear(gears[1], 18, -35.0));
  gears.push_back(NextGear(gears[0], 12, 150.0));
  gears.push_back(NextGear(gears[0], 16, -100.0));
  for (std::size_t i = 0; i < gears.size(); ++i)
  {
    AddActor(context.Renderer, MakeGear(gears[i]), PaletteColor(static_cast<int>(i)));
    Mesh pin;
    pin.AddSpun({ Circle(48, 0.19, 0.0), Circle(48, 0.19, 0.95), Circle(48, 0.14, 1.0),
                  Circle(48, 0.0, 1.0) },
      false, { gears[i].Center, 0.0 });
    AddActor(context.Renderer, pin.GetSmooth(), Colors::Stone);
  }
  constexpr double left = -4.8;
  constexpr double right = 7.2;
  constexpr double front = -6.0;
  constexpr double back = 4.0;
  Mesh plate;
  plate.AddBox({ left, front, -0.3 }, { right, back, 0.0 });
  // A wall with ribs at the right.
  plate.AddBox({ right - 0.3, front, 0.0 }, { right, back, 0.8 });
  for (int i = 0; i < 5; ++i)
  {
    const double y = front + 0.8 + 0.7 * i;
    plate.AddBox({ right - 1.5, y, 0.0 }, { right - 0.3, y + 0.12, 0.6 });
  }
  AddActor(context.Renderer, plate.GetFlat(), Colors::Stone);
  int turn = 0;
  for (const glm::dvec2 place :
    { glm::dvec2(-4.1, -5.3), glm::dvec2(-4.1, -1.0), glm::dvec2(0.5, 3.3), glm::dvec2(3.4, 3.3),
      glm::dvec2(6.2, 2.2), glm::dvec2(2.6, -5.0), glm::dvec2(3.9, -4.6) })
  {
    AddNut(context, { place, 0.0 }, 0.8, 0.35 * turn++);
  }
  return true;
}

//------------------------------------------------------------------------------
/// 257 x 257 heights by the diamond-square method, over a square of side 10.
bool AddFractalTerrain(Context& context)
{
  constexpr int size = 257;
  Random random(7);
  std::vector<double> heights(static_cast<std::size_t>(size) * size, 0.0);
  const auto at = [&heights](int i, int j) -> double& { return heights[j * size + i]; };
  // The mean of the neighbours at distance step that lie inside the square.
  const auto mean = [&at](int i, int j, int step, bool diagonal)
  {
    double sum = 0.0;
    int count = 0;
    for (int k = 0; k < 4; ++k)
    {
      const int di = diagonal ? (k & 1 ? step : -step) : (k == 0 ? step : k == 1 ? -step : 0);
      const int dj = diagonal ? (k & 2 ? step : -step) : (k == 2 ? step : k == 3 ? -step : 0);
      if (i + di >= 0 && i + di < size && j + dj >= 0 && j + dj < size)
      {
        sum += at(i + di, j + dj);
        ++count;
      }
    }
    return sum / count;
  };
  double amplitude = 1.6;
  for (int step = (size - 1) / 2; step > 0; step /= 2, amplitude *= 0.52)
  {
    for (int j = step; j < size; j += 2 * step)
    {
      for (int i = step; i < size; i += 2 * step)
      {
        at(i, j) = mean(i, j, step, true) + random.Range(-amplitude, amplitude);
      }
    }
    for (int j = 0; j < size; j += step)
    {
      for (int i = (j / step) % 2 ? 0 : step; i < size; i += 2 * step)
      {
        at(i, j) = mean(i, j, step, false) + random.Range(-amplitude, amplitude);
      }
    }
  }
  Mesh terrain;
  constexpr double spacing = 10.0 / (size - 1);
  terrain.AddHeightField(size, size, spacing, spacing, [&at](int i, int j) { return at(i, j); });
  AddActor(context.Renderer, terrain.GetSmooth(180.0), Colors::Sand);
  return true;
}

//------------------------------------------------------------------------------
/**
 * Convex bodies of few facets with smooth normals, standing on a plane: prisms of 3 to 24 sides,
 * spheres of 4 to 24 sides, and the Platonic solids with one normal per corner.
 */
bool AddLowPolyNormals(Context& context)
{
  constexpr std::array<int, 8> sides = { 3, 4, 5, 6, 8, 12, 16, 24 };
  constexpr double pitch = 1.5;
  Mesh caps;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const double x = (i + 0.5) * pitch;
    const int n = sides[i];
    Mesh prism;
    prism.AddSpun({ Circle(n, 0.5, 0.0), Circle(n, 0.5, 1.4) }, false, { x, 3.2, 0.0 }, 0.4);
    AddActor(context.Renderer, prism.GetSmoothAbout({ x, 3.2, 0.0 }, true), Colors::Clay);
    caps.AddSpun({ Circle(n, 0.5, 1.4), Circle(n, 0.0, 1.4) }, false, { x, 3.2, 0.0 }, 0.4);
    const int around = std::max(n, 4);
    AddActor(context.Renderer, MakeSphere({ x, 1.6, 0.5 }, 0.5, around, std::max(around / 2, 3)),
      Colors::Slate);
  }
  for (int type = 0; type < 5; ++type)
  {
    vtkNew<vtkPlatonicSolidSource> source;
    source->SetSolidType(type);
    source->Update();
    vtkPolyData* unit = source->GetOutput();
    Mesh solid;
    const double lowest = unit->GetBounds()[4];
    const glm::dvec3 center(1.6 + 2.2 * type, 0.0, -0.6 * lowest);
    const auto corner = [unit](vtkIdType i)
    {
      glm::dvec3 point;
      unit->GetPoint(i, &point.x);
      return point;
    };
    for (vtkIdType i = 0; i < unit->GetNumberOfPoints(); ++i)
    {
      solid.AddPoint(center + 0.6 * corner(i));
    }
    vtkNew<vtkIdList> face;
    for (vtkIdType i = 0; i < unit->GetNumberOfCells(); ++i)
    {
      unit->GetCellPoints(i, face);
      for (vtkIdType k = 1; k + 1 < face->GetNumberOfIds(); ++k)
      {
        // VTK's source winds some of the solids inwards.
        const vtkIdType a = face->GetId(0);
        vtkIdType b = face->GetId(k);
        vtkIdType c = face->GetId(k + 1);
        if (glm::dot(corner(a), glm::cross(corner(b), corner(c))) < 0.0)
        {
          std::swap(b, c);
        }
        solid.AddTriangle(a, b, c);
      }
    }
    AddActor(context.Renderer, solid.GetSmoothAbout(center, false), Colors::Sage);
  }
  AddActor(context.Renderer, caps.GetFlat(), Colors::Clay);
  AddGround(context, 0.0, pitch * sides.size(), -1.2, 4.4, Colors::Stone);
  return true;
}

//------------------------------------------------------------------------------
/**
 * Surfaces without thickness: a stack of sheets with gaps that double from 0.02, a blind, walls of
 * no thickness beside walls of thickness 0.02 and 0.2, and a bush of leaf cards.
 */
bool AddThinShells(Context& context)
{
  AddGround(context, 0.0, 11.0, 0.0, 7.0, Colors::Stone);

  Mesh sheets;
  double z = 0.0;
  double gap = 0.02;
  for (int i = 0; i < 7; ++i, gap *= 2.0)
  {
    z += gap;
    const double x = 0.6 + 0.12 * i;
    sheets.AddQuad({ x, 0.5, z }, { x + 2.4, 0.5, z }, { x + 2.4, 2.7, z }, { x, 2.7, z });
  }
  AddActor(context.Renderer, sheets.GetFlat(), Colors::Sand);

  Mesh blind;
  for (int i = 0; i < 12; ++i)
  {
    const double bottom = 0.15 + 0.2 * i;
    blind.AddQuad({ 0.8, 4.6, bottom }, { 4.4, 4.6, bottom }, { 4.4, 4.8, bottom + 0.16 },
      { 0.8, 4.8, bottom + 0.16 });
  }
  AddActor(context.Renderer, blind.GetFlat(), Colors::Slate);
  Mesh backWall;
  backWall.AddBox({ 0.4, 5.3, 0.0 }, { 4.8, 5.5, 2.8 });
  AddActor(context.Renderer, backWall.GetFlat(), Colors::Ivory);

  // Cells with a cross of two walls: no thickness, 0.02, 0.2.
  Mesh walls;
  double x = 5.6;
  for (const double thickness : { 0.0, 0.02, 0.2 })
  {
    const glm::dvec2 middle(x, 1.7);
    const double half = 0.5 * thickness;
    if (thickness > 0.0)
    {
      walls.AddBox(
        { middle.x - 0.8, middle.y - half, 0.0 }, { middle.x + 0.8, middle.y + half, 1.0 });
      walls.AddBox(
        { middle.x - half, middle.y - 0.8, 0.0 }, { middle.x + half, middle.y + 0.8, 1.0 });
    }
    else
    {
      walls.AddQuad({ middle.x - 0.8, middle.y, 0.0 }, { middle.x + 0.8, middle.y, 0.0 },
        { middle.x + 0.8, middle.y, 1.0 }, { middle.x - 0.8, middle.y, 1.0 });
      walls.AddQuad({ middle.x, middle.y - 0.8, 0.0 }, { middle.x, middle.y + 0.8, 0.0 },
        { middle.x, middle.y + 0.8, 1.0 }, { middle.x, middle.y - 0.8, 1.0 });
    }
    x += 2.0;
  }
  AddActor(context.Renderer, walls.GetFlat(), Colors::Rose);

  Mesh leaves;
  Random random(11);
  const glm::dvec3 crown(7.6, 5.0, 1.5);
  for (int i = 0; i < 260; ++i)
  {
    const glm::dvec3 center =
      crown + 1.3 * std::cbrt(random.Unit()) * random.Direction() * glm::dvec3(1.4, 1.0, 0.9);
    const glm::dvec3 normal = random.Direction();
    const glm::dvec3 aside = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 u = 0.2 * glm::normalize(glm::cross(aside, normal));
    const glm::dvec3 v = 0.2 * glm::cross(normal, glm::normalize(u));
    leaves.AddQuad(center - u - v, center + u - v, center + u + v, center - u + v);
  }
  AddActor(context.Renderer, leaves.GetFlat(), Colors::Sage);
  Mesh trunk;
  trunk.AddSpun({ Circle(16, 0.12, 0.0), Circle(16, 0.08, 1.8), Circle(16, 0.0, 1.8) }, false,
    { 7.6, 5.0, 0.0 });
  AddActor(context.Renderer, trunk.GetSmooth(), Colors::Clay);
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<Scene> ProceduralScenes()
{
  return {
    { { "sphere_pack", Kind::Procedural, "Heap of 200 spheres on a plane", 1.0 },
      { { { 6.5, -11.5, 9.0 }, { 0.0, 0.0, 0.7 } }, { { -4.0, -7.0, 3.2 }, { 0.0, 0.0, 1.2 } } },
      AddSpherePack },
    { { "gyroid", Kind::Procedural, "Gyroid, an open surface", 2.0 },
      { { { 20.8, -27.1, 15.8 }, { 0.0, -0.7, -1.2 } },
        { { 1.5, -20.0, 1.5 }, { 0.0, 0.0, 0.0 } } },
      AddGyroid },
    { { "gyroid_solid", Kind::Procedural, "Ball cut by a gyroid, a closed solid", 1.8 },
      { { { 14.0, -22.0, 12.0 }, { 0.0, 0.0, 0.0 } }, { { -9.0, -14.0, 5.0 }, { 0.0, 0.0, 0.0 } } },
      AddGyroidSolid },
    { { "menger", Kind::Procedural, "Menger sponge of level 3 and side 3", 0.5 },
      { { { 6.2, -5.0, 4.9 }, { 1.5, 1.35, 1.25 } }, { { -0.9, -1.7, 4.2 }, { 1.1, 0.9, 1.75 } } },
      AddMenger },
    { { "stream_tubes", Kind::Procedural, "Stream lines of a whirl as tubes", 0.6 },
      { { { 5.7, -8.6, 4.2 }, { 0.0, 0.0, 2.0 } }, { { 2.0, -5.0, 6.5 }, { 0.0, 0.0, 2.4 } } },
      AddStreamTubes },
    { { "gears", Kind::Procedural, "Five meshing gears on a plate with nuts and ribs", 0.8 },
      { { { -3.0, -5.0, 19.0 }, { 1.2, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } },
        { { 8.5, -13.5, 9.0 }, { 1.4, -1.6, -0.2 } } },
      AddGears },
    { { "fractal_terrain", Kind::Procedural, "Diamond-square terrain of 257 x 257 heights", 1.0 },
      { { { 8.0, -8.2, 9.6 }, { 5.2, 4.6, -0.5 } }, { { 1.6, -3.6, 3.6 }, { 5.2, 4.6, -0.3 } } },
      AddFractalTerrain },
    { { "lowpoly_normals", Kind::Procedural,
        "Prisms, spheres and Platonic solids of few facets with smooth normals", 0.8 },
      { { { -1.5, -9.0, 8.5 }, { 5.2, 1.8, 0.2 } }, { { 13.0, -6.0, 4.6 }, { 7.0, 1.5, 0.2 } } },
      AddLowPolyNormals },
    { { "thin_shells", Kind::Procedural,
        "Stacked sheets, a blind, walls with and without thickness, leaf cards", 0.8 },
      { { { 5.5, -10.0, 9.6 }, { 5.5, 3.1, 0.7 } }, { { 0.4, -5.5, 4.2 }, { 5.0, 3.2, 0.8 } } },
      AddThinShells },
  };
}
}
