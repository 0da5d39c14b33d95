// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOSceneHelpers.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace vtkSSAOScenes
{
//------------------------------------------------------------------------------
glm::dvec3 PaletteColor(int i)
{
  static const std::array<glm::dvec3, 8> palette = { Colors::Clay, Colors::Slate, Colors::Sage,
    Colors::Sand, Colors::Rose, Colors::Stone, Colors::Plum, Colors::Ochre };
  return palette[static_cast<std::size_t>(i) % palette.size()];
}

//------------------------------------------------------------------------------
double Random::Unit()
{
  this->State = this->State * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<double>(this->State >> 32) / 4294967296.0;
}

//------------------------------------------------------------------------------
double Random::Range(double low, double high)
{
  return low + (high - low) * this->Unit();
}

//------------------------------------------------------------------------------
glm::dvec3 Random::Direction()
{
  const double z = this->Range(-1.0, 1.0);
  const double angle = this->Range(0.0, glm::two_pi<double>());
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

//------------------------------------------------------------------------------
Ring Circle(int sides, double radius, double z)
{
  return { std::vector<double>(sides, radius), z };
}

//------------------------------------------------------------------------------
Ring Outline(int sides, double z, const std::function<double(double)>& radius)
{
  Ring ring{ std::vector<double>(sides), z };
  for (int i = 0; i < sides; ++i)
  {
    ring.Radii[i] = radius(glm::two_pi<double>() * i / sides);
  }
  return ring;
}

//------------------------------------------------------------------------------
vtkIdType Mesh::AddPoint(const glm::dvec3& point)
{
  return this->Points->InsertNextPoint(point.x, point.y, point.z);
}

//------------------------------------------------------------------------------
void Mesh::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->Triangles->InsertNextCell({ a, b, c });
}

//------------------------------------------------------------------------------
void Mesh::AddQuad(
  const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
  const vtkIdType first = this->AddPoint(a);
  this->AddPoint(b);
  this->AddPoint(c);
  this->AddPoint(d);
  this->AddTriangle(first, first + 1, first + 2);
  this->AddTriangle(first, first + 2, first + 3);
}

//------------------------------------------------------------------------------
void Mesh::AddBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& placement)
{
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 corner(
      i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z, 1.0);
    corners[i] = glm::dvec3(placement * corner);
  }
  constexpr int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& face : faces)
  {
    this->AddQuad(corners[face[0]], corners[face[1]], corners[face[2]], corners[face[3]]);
  }
}

//------------------------------------------------------------------------------
void Mesh::AddSpun(
  const std::vector<Ring>& rings, bool closed, const glm::dvec3& center, double phase)
{
  const vtkIdType first = this->GetNumberOfPoints();
  const vtkIdType sides = static_cast<vtkIdType>(rings.front().Radii.size());
  const std::size_t count = rings.size();
  for (const Ring& ring : rings)
  {
    for (vtkIdType i = 0; i < sides; ++i)
    {
      const double angle = phase + glm::two_pi<double>() * i / sides;
      const double radius = ring.Radii[i];
      this->AddPoint(
        center + glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), ring.Z));
    }
  }
  for (std::size_t k = 0; k + (closed ? 0 : 1) < count; ++k)
  {
    const std::size_t next = (k + 1) % count;
    for (vtkIdType i = 0; i < sides; ++i)
    {
      const vtkIdType j = (i + 1) % sides;
      const vtkIdType lower = first + static_cast<vtkIdType>(k) * sides;
      const vtkIdType upper = first + static_cast<vtkIdType>(next) * sides;
      // A ring of radius 0 is a point: only one of the two triangles has an area.
      if (rings[k].Radii[i] > 0.0 || rings[k].Radii[j] > 0.0)
      {
        this->AddTriangle(lower + i, lower + j, upper + j);
      }
      if (rings[next].Radii[i] > 0.0 || rings[next].Radii[j] > 0.0)
      {
        this->AddTriangle(lower + i, upper + j, upper + i);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Mesh::AddHeightField(int columns, int rows, double spacingX, double spacingY,
  const std::function<double(int, int)>& height)
{
  const vtkIdType first = this->GetNumberOfPoints();
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      this->AddPoint({ i * spacingX, j * spacingY, height(i, j) });
    }
  }
  for (int j = 0; j + 1 < rows; ++j)
  {
    for (int i = 0; i + 1 < columns; ++i)
    {
      const vtkIdType corner = first + static_cast<vtkIdType>(j) * columns + i;
      this->AddTriangle(corner, corner + 1, corner + columns + 1);
      this->AddTriangle(corner, corner + columns + 1, corner + columns);
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Mesh::GetFlat() const
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(this->Points);
  surface->SetPolys(this->Triangles);
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Mesh::GetSmooth(double featureAngle) const
{
  return WithNormals(this->GetFlat(), featureAngle);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Mesh::GetSmoothAbout(const glm::dvec3& center, bool aboutAxis) const
{
  vtkSmartPointer<vtkPolyData> surface = this->GetFlat();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < this->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 normal;
    this->Points->GetPoint(i, &normal.x);
    normal -= center;
    normal.z = aboutAxis ? 0.0 : normal.z;
    normal = glm::normalize(normal);
    normals->InsertNextTuple(&normal.x);
  }
  surface->GetPointData()->SetNormals(normals);
  return surface;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface, double featureAngle)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(featureAngle);
  normals->SetSplitting(featureAngle < 180.0);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

//------------------------------------------------------------------------------
void AddActor(vtkRenderer* renderer, vtkPolyData* surface, const glm::dvec3& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void Paint(vtkPolyData* surface, const glm::dvec3& color)
{
  surface->GetPointData()->SetScalars(
    MakeColors(surface->GetNumberOfPoints(), [&color](vtkIdType) { return color; }));
}

//------------------------------------------------------------------------------
void AddColoredActor(vtkRenderer* renderer, vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(
  vtkIdType n, const std::function<glm::dvec3(vtkIdType)>& color)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("colors");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const glm::dvec3 rgb = color(i) * 255.0 + 0.5;
    for (int channel = 0; channel < 3; ++channel)
    {
      colors->SetTypedComponent(i, channel, static_cast<unsigned char>(rgb[channel]));
    }
  }
  return colors;
}

//------------------------------------------------------------------------------
void ShareWithAmbient(vtkRenderer* renderer, double share)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator position;
  actors->InitTraversal(position);
  while (vtkActor* actor = actors->GetNextActor(position))
  {
    actor->GetProperty()->SetAmbient(share);
    actor->GetProperty()->SetDiffuse(1.0 - share);
  }
}

//------------------------------------------------------------------------------
void AddTubes(vtkRenderer* renderer, vtkPolyData* lines, double radius, const glm::dvec3& color)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(10);
  tubes->CappingOn();
  // The filter gives strips.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tubes->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  AddActor(renderer, triangles->GetOutput(), color);
}

//------------------------------------------------------------------------------
void AddSpheres(vtkRenderer* renderer, vtkPolyData* points, SphereStyle style)
{
  vtkNew<vtkActor> actor;
  if (style == SphereStyle::Impostors)
  {
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(points);
    mapper->SetScaleArray(SphereRadiusArray());
    actor->SetMapper(mapper);
  }
  else
  {
    vtkNew<vtkSphereSource> unitSphere;
    unitSphere->SetRadius(1.0);
    unitSphere->SetThetaResolution(16);
    unitSphere->SetPhiResolution(9);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(points);
    mapper->SetSourceConnection(unitSphere->GetOutputPort());
    mapper->SetScaleArray(SphereRadiusArray());
    mapper->SetScaleModeToScaleByMagnitude();
    mapper->OrientOff();
    actor->SetMapper(mapper);
  }
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSphere(
  const glm::dvec3& center, double radius, int sides, int rows)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center.x, center.y, center.z);
  source->SetRadius(radius);
  source->SetThetaResolution(sides);
  source->SetPhiResolution(rows + 1);
  source->Update();
  return source->GetOutput();
}
}
