// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the scenes share: the description of a scene, a mesh under construction, a random number
 * generator, and actors. Not for use outside this folder.
 */

#ifndef vtkSSAOSceneHelpers_h
#define vtkSSAOSceneHelpers_h

#include "vtkSSAOScenes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace vtkSSAOScenes
{
/// A fixed camera in world units. ViewAngle is vertical, in degrees. ParallelHeight above 0 is the
/// height of the picture in parallel projection.
struct View
{
  glm::dvec3 Position;
  glm::dvec3 FocalPoint;
  glm::dvec3 ViewUp = { 0.0, 0.0, 1.0 };
  double ViewAngle = 30.0;
  double ParallelHeight = 0.0;
};

/// What a scene function gets, and where it leaves its error message.
struct Context
{
  vtkRenderer* Renderer;
  std::string DataDirectory;
  SphereStyle Spheres;
  std::string Error;
};

/// A scene function adds all its actors and returns true, or adds none, fills Error, returns false.
struct Scene
{
  Info About;
  std::vector<View> Views;
  bool (*Add)(Context&);
};

std::vector<Scene> AnalyticScenes();
std::vector<Scene> ProceduralScenes();
std::vector<Scene> RealScenes();

/// Muted surface colours.
namespace Colors
{
constexpr glm::dvec3 Stone = { 0.74, 0.74, 0.72 };
constexpr glm::dvec3 Sand = { 0.84, 0.79, 0.68 };
constexpr glm::dvec3 Clay = { 0.78, 0.66, 0.56 };
constexpr glm::dvec3 Rose = { 0.76, 0.58, 0.55 };
constexpr glm::dvec3 Ochre = { 0.79, 0.67, 0.44 };
constexpr glm::dvec3 Sage = { 0.62, 0.69, 0.57 };
constexpr glm::dvec3 Slate = { 0.55, 0.62, 0.69 };
constexpr glm::dvec3 Plum = { 0.63, 0.55, 0.63 };
constexpr glm::dvec3 Ivory = { 0.86, 0.85, 0.80 };
}

/// Colour number i of a palette that repeats itself.
glm::dvec3 PaletteColor(int i);

/**
 * Linear congruential generator, x <- 6364136223846793005 x + 1442695040888963407 mod 2^64
 * (Knuth's MMIX), of which the upper 32 bits are used.
 */
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }

  /// Uniform in [0, 1).
  double Unit();
  /// Uniform in [low, high).
  double Range(double low, double high);
  /// A unit vector, uniform over the sphere.
  glm::dvec3 Direction();

private:
  std::uint64_t State;
};

/// One ring of a spun surface: a radius for each angle, all at one height.
struct Ring
{
  std::vector<double> Radii;
  double Z;
};

/// A ring of constant radius.
Ring Circle(int sides, double radius, double z);
/// A ring whose radius is a function of the angle in radians.
Ring Outline(int sides, double z, const std::function<double(double)>& radius);

/// Triangles under construction, wound counter-clockwise as seen from outside.
class Mesh
{
public:
  vtkIdType AddPoint(const glm::dvec3& point);
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c);

  /// Two triangles a b c and a c d, with points of their own.
  void AddQuad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

  /// A box with edges along the axes of the placement.
  void AddBox(
    const glm::dvec3& low, const glm::dvec3& high, const glm::dmat4& placement = glm::dmat4(1.0));

  /**
   * A surface spun about the z axis through center. Seen in the half plane of one angle, the rings
   * must run with the outside on the right: up an outer wall, inwards over a top, down a hole.
   * A closed surface joins its last ring to the first. Phase turns it, in radians.
   */
  void AddSpun(
    const std::vector<Ring>& rings, bool closed, const glm::dvec3& center, double phase = 0.0);

  /// A grid of columns x rows heights in the xy plane, its first point at the origin.
  void AddHeightField(int columns, int rows, double spacingX, double spacingY,
    const std::function<double(int, int)>& height);

  vtkIdType GetNumberOfPoints() const { return this->Points->GetNumberOfPoints(); }

  /// The mesh without normals.
  vtkSmartPointer<vtkPolyData> GetFlat() const;
  /// The mesh with point normals; edges sharper than featureAngle (degrees) are kept sharp.
  vtkSmartPointer<vtkPolyData> GetSmooth(double featureAngle = 30.0) const;
  /// The mesh with point normals that point away from center, or from the z axis through it.
  vtkSmartPointer<vtkPolyData> GetSmoothAbout(const glm::dvec3& center, bool aboutAxis) const;

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
};

/// Point normals for a surface of triangles, whose winding is kept. 180 degrees: no sharp edges.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface, double featureAngle);

/// Add an opaque actor with VTK's default material.
void AddActor(vtkRenderer* renderer, vtkPolyData* surface, const glm::dvec3& color);

/// Give a surface one colour as unsigned char RGB point scalars.
void Paint(vtkPolyData* surface, const glm::dvec3& color);

/// Add an actor with the colours that the surface's own point or cell scalars hold.
void AddColoredActor(vtkRenderer* renderer, vtkPolyData* surface);

/// A colour array for n points or cells, to be set as the scalars of a surface.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(
  vtkIdType n, const std::function<glm::dvec3(vtkIdType)>& color);

/// Give all actors of a renderer the ambient coefficient share, and diffuse 1 - share.
void ShareWithAmbient(vtkRenderer* renderer, double share);

/// Add the lines of a data set as tubes of ten sides with capped ends.
void AddTubes(vtkRenderer* renderer, vtkPolyData* lines, double radius, const glm::dvec3& color);

/// Add points with the arrays SphereRadiusArray() and RGB point scalars as spheres.
void AddSpheres(vtkRenderer* renderer, vtkPolyData* points, SphereStyle style);

/// A sphere of triangles with smooth normals; sides around, rows from pole to pole.
vtkSmartPointer<vtkPolyData> MakeSphere(
  const glm::dvec3& center, double radius, int sides, int rows);
}

#endif
