// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthTracer.h"

#include "vtkSSAOTruthCamera.h"
#include "vtkSSAOTruthDigest.h"
#include "vtkSSAOTruthEmbree.h"
#include "vtkSSAOTruthImage.h"
#include "vtkSSAOTruthSampler.h"
#include "vtkSSAOTruthScene.h"

#include "vtkMath.h"
#include "vtkObject.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

namespace
{
// Raise this when the same input gives another image, so that old cache files are not used.
const int AlgorithmVersion = 1;

// Sine of the elevation above the facet's plane below which nothing occludes: see the class
// documentation.
const double LowestElevation = 1e-4;

/**
 * What the filter functions know of a geometry: a mesh or a set of spheres.
 */
struct GeometryRecord
{
  const vtkSSAOTruthScene::Mesh* Mesh = nullptr;
  const vtkSSAOTruthScene::Spheres* Spheres = nullptr;

  bool IsLit() const { return this->Mesh ? this->Mesh->Lit : this->Spheres->Lit; }
};

/**
 * A ray from the camera, in double precision, beside Embree's context.
 */
struct CameraContext
{
  vtkSSAOTruthRayContext Base;
  double Start[3];
  double Direction[3];
  bool Mirrored;
};

/**
 * The surface point that shadow rays belong to, beside Embree's context. They start a little behind
 * it and end a little beyond the radius, so that what single precision is wrong about is found, and
 * then decided in double precision.
 */
struct ShadowContext
{
  vtkSSAOTruthRayContext Base;
  double Point[3];
  double FacetNormal[3];
  double Lead; // distance from the start of the rays to the point
  double Radius;
};

/**
 * The surface point that a pixel shows; world axes, relative to the origin.
 */
struct SurfacePoint
{
  double Point[3];
  double FacetNormal[3];
  double ShadingNormal[3];
};

//------------------------------------------------------------------------------
void GetVertices(
  const vtkSSAOTruthScene::Mesh& mesh, unsigned int triangle, const double* vertices[3])
{
  for (int i = 0; i < 3; ++i)
  {
    vertices[i] =
      mesh.Points.data() + 3 * std::size_t(mesh.Triangles[3 * std::size_t(triangle) + i]);
  }
}

//------------------------------------------------------------------------------
// (v1 - v0) x (v2 - v0): points to the side from which the vertices run counter-clockwise.
void GetWindingNormal(const double* const vertices[3], double normal[3])
{
  double first[3], second[3];
  vtkMath::Subtract(vertices[1], vertices[0], first);
  vtkMath::Subtract(vertices[2], vertices[0], second);
  vtkMath::Cross(first, second, normal);
}

//------------------------------------------------------------------------------
bool IsClipped(const vtkSSAOTruthScene::Mesh& mesh, const double start[3],
  const double direction[3], double distance)
{
  for (const std::array<double, 4>& plane : mesh.ClippingPlanes)
  {
    double value = plane[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      value += plane[axis] * (start[axis] + distance * direction[axis]);
    }
    if (value < 0.0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Whether the rasteriser takes a triangle for front facing, seen along a direction.
bool IsFrontFacing(const double* const vertices[3], const double direction[3], bool mirrored)
{
  double normal[3];
  GetWindingNormal(vertices, normal);
  return (vtkMath::Dot(normal, direction) < 0.0) != mirrored;
}

//------------------------------------------------------------------------------
// Filter of camera rays: rejects what VTK does not draw.
void FilterCameraHit(const RTCFilterFunctionNArguments* arguments)
{
  const GeometryRecord* record = static_cast<const GeometryRecord*>(arguments->geometryUserPtr);
  const CameraContext* context = reinterpret_cast<const CameraContext*>(arguments->context);
  const vtkSSAOTruthScene::Mesh* mesh = record->Mesh;
  if (!mesh || (!mesh->CullsBack && !mesh->CullsFront && mesh->ClippingPlanes.empty()))
  {
    return;
  }
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (arguments->valid[i] != -1)
    {
      continue;
    }
    const double* vertices[3];
    GetVertices(*mesh, RTCHitN_primID(arguments->hit, arguments->N, i), vertices);
    const bool front = IsFrontFacing(vertices, context->Direction, context->Mirrored);
    if ((front && mesh->CullsFront) || (!front && mesh->CullsBack) ||
      IsClipped(
        *mesh, context->Start, context->Direction, RTCRayN_tfar(arguments->ray, arguments->N, i)))
    {
      arguments->valid[i] = 0;
    }
  }
}

//------------------------------------------------------------------------------
// Whether a surface rises above the plane of the facet, seen from the point: three vertices, or a
// sphere.
bool RisesAboveFacet(const ShadowContext& context, const double* const vertices[3])
{
  for (int i = 0; i < 3; ++i)
  {
    double offset[3];
    vtkMath::Subtract(vertices[i], context.Point, offset);
    const double height = vtkMath::Dot(offset, context.FacetNormal);
    if (height > 0.0 &&
      height * height > LowestElevation * LowestElevation * vtkMath::Dot(offset, offset))
    {
      return true;
    }
  }
  return false;
}

bool RisesAboveFacet(const ShadowContext& context, const double center[3], double radius)
{
  double offset[3];
  vtkMath::Subtract(center, context.Point, offset);
  return vtkMath::Dot(offset, context.FacetNormal) + radius >
    LowestElevation * std::max(vtkMath::Norm(offset), radius);
}

//------------------------------------------------------------------------------
// Whether the ray from a point meets a triangle, or a sphere, ahead and not beyond a distance.
bool IsHit(
  const double point[3], const double direction[3], double limit, const double* const vertices[3])
{
  // Moeller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", JGT 2(1), 1997.
  double first[3], second[3], offset[3], p[3], q[3];
  vtkMath::Subtract(vertices[1], vertices[0], first);
  vtkMath::Subtract(vertices[2], vertices[0], second);
  vtkMath::Subtract(point, vertices[0], offset);
  vtkMath::Cross(direction, second, p);
  vtkMath::Cross(offset, first, q);
  const double determinant = vtkMath::Dot(first, p);
  const double u = vtkMath::Dot(offset, p) / determinant;
  const double v = vtkMath::Dot(direction, q) / determinant;
  const double distance = vtkMath::Dot(second, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && distance <= limit;
}

bool IsHit(const double point[3], const double direction[3], double limit, const double center[3],
  double radius)
{
  double offset[3];
  vtkMath::Subtract(center, point, offset);
  const double square = vtkMath::Dot(direction, direction);
  const double along = vtkMath::Dot(offset, direction) / square;
  double across[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    across[axis] = offset[axis] - along * direction[axis];
  }
  const double halfSquare = radius * radius - vtkMath::Dot(across, across);
  if (halfSquare < 0.0)
  {
    return false;
  }
  const double half = std::sqrt(halfSquare / square);
  const bool entersAhead = along - half > 0.0 && along - half <= limit;
  const bool leavesAhead = along + half > 0.0 && along + half <= limit;
  return entersAhead || leavesAhead;
}

//------------------------------------------------------------------------------
// Filter of shadow rays: rejects what is below the facet's plane, behind the point, unlit or
// clipped away.
void FilterShadowHit(const RTCFilterFunctionNArguments* arguments)
{
  const GeometryRecord* record = static_cast<const GeometryRecord*>(arguments->geometryUserPtr);
  const ShadowContext* context = reinterpret_cast<const ShadowContext*>(arguments->context);
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (arguments->valid[i] != -1)
    {
      continue;
    }
    const unsigned int primitive = RTCHitN_primID(arguments->hit, arguments->N, i);
    const double distance = RTCRayN_tfar(arguments->ray, arguments->N, i) - context->Lead;
    const double direction[3] = { RTCRayN_dir_x(arguments->ray, arguments->N, i),
      RTCRayN_dir_y(arguments->ray, arguments->N, i),
      RTCRayN_dir_z(arguments->ray, arguments->N, i) };
    const bool uncertain =
      distance < 4.0 * context->Lead || distance > context->Radius - context->Lead;
    bool occludes = record->IsLit();
    if (occludes && record->Mesh)
    {
      const double* vertices[3];
      GetVertices(*record->Mesh, primitive, vertices);
      occludes = RisesAboveFacet(*context, vertices) &&
        (!uncertain || IsHit(context->Point, direction, context->Radius, vertices)) &&
        !IsClipped(*record->Mesh, context->Point, direction, distance);
    }
    else if (occludes)
    {
      const double* center = record->Spheres->Centers.data() + 3 * std::size_t(primitive);
      const double radius = record->Spheres->Radii[primitive];
      occludes = RisesAboveFacet(*context, center, radius) &&
        (!uncertain || IsHit(context->Point, direction, context->Radius, center, radius));
    }
    if (!occludes)
    {
      arguments->valid[i] = 0;
    }
  }
}

//------------------------------------------------------------------------------
void InitializeRay(
  const double start[3], const double direction[3], double farDistance, RTCRay& ray)
{
  ray.org_x = static_cast<float>(start[0]);
  ray.org_y = static_cast<float>(start[1]);
  ray.org_z = static_cast<float>(start[2]);
  ray.dir_x = static_cast<float>(direction[0]);
  ray.dir_y = static_cast<float>(direction[1]);
  ray.dir_z = static_cast<float>(direction[2]);
  ray.tnear = 0.0f;
  ray.tfar = static_cast<float>(farDistance);
  ray.time = 0.0f;
  ray.mask = 0xffffffffu;
  ray.id = 0;
  ray.flags = 0;
}

//------------------------------------------------------------------------------
// Unit vectors that make a right-handed frame with a unit normal (Duff et al., "Building an
// Orthonormal Basis, Revisited", JCGT 6(1), 2017).
void GetFrame(const double normal[3], double tangent[3], double bitangent[3])
{
  const double sign = normal[2] < 0.0 ? -1.0 : 1.0;
  const double a = -1.0 / (sign + normal[2]);
  const double b = normal[0] * normal[1] * a;
  tangent[0] = 1.0 + sign * normal[0] * normal[0] * a;
  tangent[1] = sign * b;
  tangent[2] = -sign * normal[0];
  bitangent[0] = b;
  bitangent[1] = sign + normal[1] * normal[1] * a;
  bitangent[2] = -normal[1];
}

/**
 * The scene in Embree's form, and what tracing one pixel of it needs.
 */
class View
{
public:
  View(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera);
  ~View();
  View(const View&) = delete;
  void operator=(const View&) = delete;

  bool IsValid() const { return this->Valid; }

  /// The opaque lit surface at the centre of a pixel.
  bool FindSurface(int x, int y, SurfacePoint& surface) const;

  /// Prepares the shadow rays of a surface point.
  void GetShadowContext(const SurfacePoint& surface, double radius, ShadowContext& context) const;

  /// Whether a shadow ray is free.
  bool IsOpen(ShadowContext& context, const double direction[3]) const;

private:
  void AddMesh(const vtkSSAOTruthScene::Mesh& mesh, GeometryRecord* record);
  void AddSpheres(const vtkSSAOTruthScene::Spheres& spheres, GeometryRecord* record);
  void AttachGeometry(RTCGeometry geometry, GeometryRecord* record);
  void AddBounds(const double point[3], double margin);
  bool ClipToBounds(const double start[3], const double direction[3], double range[2]) const;
  bool FindOnMesh(const vtkSSAOTruthScene::Mesh& mesh, unsigned int triangle,
    const CameraContext& context, SurfacePoint& surface) const;
  bool FindOnSphere(const double center[3], double radius, const CameraContext& context,
    SurfacePoint& surface) const;

  const vtkSSAOTruthCamera& Camera;
  bool Mirrored;
  RTCDevice Device;
  RTCScene Scene = nullptr;
  std::vector<GeometryRecord> Records;
  double Minimum[3];
  double Maximum[3];
  bool Valid = false;
};

//------------------------------------------------------------------------------
View::View(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera)
  : Camera(camera)
  , Mirrored(camera.IsMirrored())
  // One thread builds, so that the result cannot depend on how the build was divided.
  , Device(rtcNewDevice("threads=1"))
{
  std::fill(this->Minimum, this->Minimum + 3, std::numeric_limits<double>::infinity());
  std::fill(this->Maximum, this->Maximum + 3, -std::numeric_limits<double>::infinity());
  if (!this->Device)
  {
    return;
  }
  this->Scene = rtcNewScene(this->Device);
  // Robust: a ray cannot slip through a shared edge.
  rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(this->Scene, RTC_BUILD_QUALITY_HIGH);

  this->Records.resize(scene.GetMeshes().size() + scene.GetSpheres().size());
  std::size_t next = 0;
  for (const vtkSSAOTruthScene::Mesh& mesh : scene.GetMeshes())
  {
    this->AddMesh(mesh, &this->Records[next++]);
  }
  for (const vtkSSAOTruthScene::Spheres& spheres : scene.GetSpheres())
  {
    this->AddSpheres(spheres, &this->Records[next++]);
  }
  rtcCommitScene(this->Scene);
  this->Valid = rtcGetDeviceError(this->Device) == RTC_ERROR_NONE;
}

//------------------------------------------------------------------------------
View::~View()
{
  if (this->Scene)
  {
    rtcReleaseScene(this->Scene);
  }
  if (this->Device)
  {
    rtcReleaseDevice(this->Device);
  }
}

//------------------------------------------------------------------------------
void View::AddMesh(const vtkSSAOTruthScene::Mesh& mesh, GeometryRecord* record)
{
  record->Mesh = &mesh;
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
    RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.Points.size() / 3));
  unsigned int* triangles =
    static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
      RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), mesh.Triangles.size() / 3));
  if (points && triangles)
  {
    std::transform(mesh.Points.begin(), mesh.Points.end(), points,
      [](double value) { return static_cast<float>(value); });
    std::copy(mesh.Triangles.begin(), mesh.Triangles.end(), triangles);
    for (unsigned int point : mesh.Triangles)
    {
      this->AddBounds(mesh.Points.data() + 3 * std::size_t(point), 0.0);
    }
  }
  this->AttachGeometry(geometry, record);
}

//------------------------------------------------------------------------------
void View::AddSpheres(const vtkSSAOTruthScene::Spheres& spheres, GeometryRecord* record)
{
  record->Spheres = &spheres;
  RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  float* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
    RTC_FORMAT_FLOAT4, 4 * sizeof(float), spheres.Radii.size()));
  for (std::size_t i = 0; points && i < spheres.Radii.size(); ++i)
  {
    const double* center = spheres.Centers.data() + 3 * i;
    for (int axis = 0; axis < 3; ++axis)
    {
      points[4 * i + axis] = static_cast<float>(center[axis]);
    }
    points[4 * i + 3] = static_cast<float>(spheres.Radii[i]);
    this->AddBounds(center, spheres.Radii[i]);
  }
  this->AttachGeometry(geometry, record);
}

//------------------------------------------------------------------------------
void View::AttachGeometry(RTCGeometry geometry, GeometryRecord* record)
{
  rtcSetGeometryUserData(geometry, record);
  rtcSetGeometryIntersectFilterFunction(geometry, FilterCameraHit);
  rtcSetGeometryOccludedFilterFunction(geometry, FilterShadowHit);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(
    this->Scene, geometry, static_cast<unsigned int>(record - this->Records.data()));
  rtcReleaseGeometry(geometry);
}

//------------------------------------------------------------------------------
void View::AddBounds(const double point[3], double margin)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Minimum[axis] = std::min(this->Minimum[axis], point[axis] - margin);
    this->Maximum[axis] = std::max(this->Maximum[axis], point[axis] + margin);
  }
}

//------------------------------------------------------------------------------
// Shortens a range of distances along a ray to what is inside the bounds of the scene, slightly
// enlarged.
bool View::ClipToBounds(const double start[3], const double direction[3], double range[2]) const
{
  double diagonal[3];
  vtkMath::Subtract(this->Maximum, this->Minimum, diagonal);
  const double margin = 1e-3 * vtkMath::Norm(diagonal);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = this->Minimum[axis] - margin - start[axis];
    const double high = this->Maximum[axis] + margin - start[axis];
    if (direction[axis] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return false;
      }
      continue;
    }
    const double first = low / direction[axis];
    const double second = high / direction[axis];
    range[0] = std::max(range[0], std::min(first, second));
    range[1] = std::min(range[1], std::max(first, second));
  }
  return range[0] < range[1];
}

//------------------------------------------------------------------------------
bool View::FindSurface(int x, int y, SurfacePoint& surface) const
{
  CameraContext context;
  context.Mirrored = this->Mirrored;
  double nearPoint[3], farPoint[3];
  this->Camera.GetRay(x, y, nearPoint, farPoint);
  vtkMath::Subtract(farPoint, nearPoint, context.Direction);
  double range[2] = { 0.0, vtkMath::Normalize(context.Direction) };
  if (!this->ClipToBounds(nearPoint, context.Direction, range))
  {
    return false;
  }
  // Single precision is relative to the distance from where the ray enters the scene.
  for (int axis = 0; axis < 3; ++axis)
  {
    context.Start[axis] = nearPoint[axis] + range[0] * context.Direction[axis];
  }
  RTCRayHit hit;
  InitializeRay(context.Start, context.Direction, range[1] - range[0], hit.ray);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.primID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  vtkSSAOTruthIntersect(this->Scene, &context.Base, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
  {
    return false;
  }
  const GeometryRecord& record = this->Records[hit.hit.geomID];
  const unsigned int primitive = hit.hit.primID;
  if (!record.IsLit())
  {
    return false;
  }
  return record.Mesh
    ? this->FindOnMesh(*record.Mesh, primitive, context, surface)
    : this->FindOnSphere(record.Spheres->Centers.data() + 3 * std::size_t(primitive),
        record.Spheres->Radii[primitive], context, surface);
}

//------------------------------------------------------------------------------
bool View::FindOnMesh(const vtkSSAOTruthScene::Mesh& mesh, unsigned int triangle,
  const CameraContext& context, SurfacePoint& surface) const
{
  const double* vertices[3];
  GetVertices(mesh, triangle, vertices);
  double winding[3];
  GetWindingNormal(vertices, winding);
  const double area = vtkMath::Dot(winding, winding);
  const double along = vtkMath::Dot(winding, context.Direction);
  if (!(area > 0.0) || along == 0.0)
  {
    return false;
  }

  // The point in double precision: ray meets plane.
  double offset[3];
  vtkMath::Subtract(vertices[0], context.Start, offset);
  const double distance = vtkMath::Dot(winding, offset) / along;
  for (int axis = 0; axis < 3; ++axis)
  {
    surface.Point[axis] = context.Start[axis] + distance * context.Direction[axis];
    // A point on an edge goes inside by more than rounding, so that it is on this facet's side of
    // the neighbour.
    const double middle = (vertices[0][axis] + vertices[1][axis] + vertices[2][axis]) / 3.0;
    surface.Point[axis] += 1e-9 * (middle - surface.Point[axis]);
  }

  const double towardsViewer = along < 0.0 ? 1.0 : -1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    surface.FacetNormal[axis] = towardsViewer * winding[axis];
  }
  vtkMath::Normalize(surface.FacetNormal);

  std::copy(surface.FacetNormal, surface.FacetNormal + 3, surface.ShadingNormal);
  if (mesh.Normal == vtkSSAOTruthScene::Mesh::NoNormals)
  {
    return true;
  }
  double normal[3] = { 0.0, 0.0, 0.0 };
  if (mesh.Normal == vtkSSAOTruthScene::Mesh::CellNormals)
  {
    const double* cellNormal = mesh.Normals.data() + 3 * std::size_t(triangle);
    std::copy(cellNormal, cellNormal + 3, normal);
  }
  else
  {
    // Barycentric weights: the signed areas of the triangles that the point makes with the edges.
    for (int i = 0; i < 3; ++i)
    {
      const double* const part[3] = { surface.Point, vertices[(i + 1) % 3], vertices[(i + 2) % 3] };
      double partWinding[3];
      GetWindingNormal(part, partWinding);
      const double weight =
        vtkMath::ClampValue(vtkMath::Dot(partWinding, winding) / area, 0.0, 1.0);
      const std::size_t point = mesh.Triangles[3 * std::size_t(triangle) + i];
      for (int axis = 0; axis < 3; ++axis)
      {
        normal[axis] += weight * mesh.Normals[3 * point + axis];
      }
    }
  }
  if (!(vtkMath::Normalize(normal) > 0.0))
  {
    return true;
  }
  // VTK's shader turns the normals of back faces; then the side of the facet counts.
  double sign = (along < 0.0) != context.Mirrored ? 1.0 : -1.0;
  if (sign * vtkMath::Dot(normal, surface.FacetNormal) < 0.0)
  {
    sign = -sign;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    surface.ShadingNormal[axis] = sign * normal[axis];
  }
  return true;
}

//------------------------------------------------------------------------------
bool View::FindOnSphere(
  const double center[3], double radius, const CameraContext& context, SurfacePoint& surface) const
{
  // The nearest point of the ray to the centre, then half the chord back; forward if the ray starts
  // inside.
  double offset[3];
  vtkMath::Subtract(center, context.Start, offset);
  const double along = vtkMath::Dot(offset, context.Direction);
  double across[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    across[axis] = along * context.Direction[axis] - offset[axis];
  }
  const double half = std::sqrt(std::max(0.0, radius * radius - vtkMath::Dot(across, across)));
  const bool inside = vtkMath::Dot(offset, offset) < radius * radius;
  for (int axis = 0; axis < 3; ++axis)
  {
    surface.FacetNormal[axis] = across[axis] + (inside ? half : -half) * context.Direction[axis];
  }
  vtkMath::Normalize(surface.FacetNormal);
  for (int axis = 0; axis < 3; ++axis)
  {
    surface.Point[axis] = center[axis] + radius * surface.FacetNormal[axis];
    surface.FacetNormal[axis] *= inside ? -1.0 : 1.0;
    surface.ShadingNormal[axis] = surface.FacetNormal[axis];
  }
  return true;
}

//------------------------------------------------------------------------------
void View::GetShadowContext(
  const SurfacePoint& surface, double radius, ShadowContext& context) const
{
  context.Radius = radius;
  std::copy(surface.Point, surface.Point + 3, context.Point);
  std::copy(surface.FacetNormal, surface.FacetNormal + 3, context.FacetNormal);
  // Some steps of single precision at the largest coordinate of the scene. What is that near to
  // the ends of a ray is decided in double precision, so the size has no effect on the result.
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max({ largest, std::abs(this->Minimum[axis]), std::abs(this->Maximum[axis]) });
  }
  context.Lead = 8.0 * std::numeric_limits<float>::epsilon() * largest;
}

//------------------------------------------------------------------------------
bool View::IsOpen(ShadowContext& context, const double direction[3]) const
{
  double start[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    start[axis] = context.Point[axis] - context.Lead * direction[axis];
  }
  RTCRay ray;
  InitializeRay(start, direction, context.Radius + 2.0 * context.Lead, ray);
  vtkSSAOTruthOccluded(this->Scene, &context.Base, &ray);
  // Embree marks a ray that hit something by a negative end.
  return !(ray.tfar < 0.0f);
}

/**
 * How the hemisphere is sampled.
 */
struct Sampling
{
  double Distance;
  int Replicates;
  int RaysPerReplicate;
  bool CosineWeight;
};

//------------------------------------------------------------------------------
// V of one point and its standard error.
void TracePoint(const View& view, const Sampling& sampling, int x, int y,
  const SurfacePoint& surface, float& visibility, float& standardError)
{
  ShadowContext context;
  view.GetShadowContext(surface, sampling.Distance, context);
  double tangent[3], bitangent[3];
  GetFrame(surface.ShadingNormal, tangent, bitangent);

  long long open = 0;
  long long tried = 0;
  double sum = 0.0;
  double sumOfSquares = 0.0;
  int replicates = 0;
  for (int replicate = 0; replicate < sampling.Replicates; ++replicate)
  {
    const vtkSSAOTruthSampler sampler(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
      static_cast<std::uint32_t>(replicate));
    int openHere = 0;
    int triedHere = 0;
    for (int i = 0; i < sampling.RaysPerReplicate; ++i)
    {
      double u[2], local[3], direction[3];
      sampler.GetPoint(static_cast<std::uint32_t>(i), u);
      if (sampling.CosineWeight)
      {
        vtkSSAOTruthSampler::GetCosineDirection(u, local);
      }
      else
      {
        vtkSSAOTruthSampler::GetUniformDirection(u, local);
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        direction[axis] = local[0] * tangent[axis] + local[1] * bitangent[axis] +
          local[2] * surface.ShadingNormal[axis];
      }
      if (vtkMath::Dot(direction, surface.FacetNormal) > 0.0)
      {
        ++triedHere;
        openHere += view.IsOpen(context, direction) ? 1 : 0;
      }
    }
    open += openHere;
    tried += triedHere;
    if (triedHere > 0)
    {
      const double value = static_cast<double>(openHere) / triedHere;
      sum += value;
      sumOfSquares += value * value;
      ++replicates;
    }
  }

  visibility = tried > 0 ? static_cast<float>(static_cast<double>(open) / tried) : 1.0f;
  standardError = 0.0f;
  if (replicates > 1)
  {
    const double variance = std::max(0.0, sumOfSquares - sum * sum / replicates) / (replicates - 1);
    standardError = static_cast<float>(std::sqrt(variance / replicates));
  }
}

//------------------------------------------------------------------------------
void TraceRow(const View& view, const vtkSSAOTruthCamera& camera, const Sampling& sampling, int y,
  vtkSSAOTruthImage& image)
{
  for (int x = 0; x < image.Width; ++x)
  {
    SurfacePoint surface;
    if (!view.FindSurface(x, y, surface))
    {
      continue;
    }
    const std::size_t pixel = static_cast<std::size_t>(y) * image.Width + x;
    image.Hit[pixel] = 1;
    image.Depth[pixel] = static_cast<float>(camera.GetDepth(surface.Point));
    double normal[3], facetNormal[3];
    camera.ToView(surface.ShadingNormal, normal);
    camera.ToView(surface.FacetNormal, facetNormal);
    for (int axis = 0; axis < 3; ++axis)
    {
      image.Normal[3 * pixel + axis] = static_cast<float>(normal[axis]);
      image.GeometricNormal[3 * pixel + axis] = static_cast<float>(facetNormal[axis]);
    }
    TracePoint(view, sampling, x, y, surface, image.Visibility[pixel], image.StandardError[pixel]);
  }
}
}

//------------------------------------------------------------------------------
std::string vtkSSAOTruthTracer::GetDigest() const
{
  vtkSSAOTruthDigest digest;
  digest.Add(AlgorithmVersion);
  digest.Add(this->Radius);
  digest.Add(this->RaysPerPixel);
  digest.Add(this->Replicates);
  digest.Add(this->CosineWeight);
  digest.Add(this->Cutoff);
  return digest.GetHex();
}

//------------------------------------------------------------------------------
bool vtkSSAOTruthTracer::Trace(
  const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera, vtkSSAOTruthImage& image) const
{
  image.Allocate(camera.GetWidth(), camera.GetHeight());
  if (!(this->Radius > 0.0) || this->RaysPerPixel < 1 || this->Replicates < 2)
  {
    vtkGenericWarningMacro("vtkSSAOTruthTracer: bad radius "
      << this->Radius << ", rays per pixel " << this->RaysPerPixel << " or replicates "
      << this->Replicates);
    return false;
  }
  if (scene.GetMeshes().empty() && scene.GetSpheres().empty())
  {
    return true;
  }
  const View view(scene, camera);
  if (!view.IsValid())
  {
    vtkGenericWarningMacro("vtkSSAOTruthTracer: Embree cannot build the scene");
    return false;
  }

  Sampling sampling;
  sampling.Distance = this->Cutoff ? this->Radius : std::numeric_limits<double>::infinity();
  sampling.Replicates = this->Replicates;
  sampling.RaysPerReplicate = (this->RaysPerPixel + this->Replicates - 1) / this->Replicates;
  sampling.CosineWeight = this->CosineWeight;

  // Threads take rows as they get free; a pixel depends on nothing but the view and itself.
  std::atomic<int> nextRow(0);
  std::atomic<int> rowsDone(0);
  std::atomic<bool> stopped(false);
  const auto work = [&]()
  {
    for (int y = nextRow++; y < image.Height && !stopped; y = nextRow++)
    {
      TraceRow(view, camera, sampling, y, image);
      const double share = static_cast<double>(++rowsDone) / image.Height;
      if (this->Progress && !this->Progress(share))
      {
        stopped = true;
      }
    }
  };
  const int threads = this->Threads > 0
    ? this->Threads
    : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i)
  {
    others.emplace_back(work);
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
  return !stopped;
}
