// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Named scenes for the regression tests and for the report of speed against error.
 *
 * Every scene has a fixed occlusion radius and two fixed views. All props are opaque and lit, with
 * VTK's default material (ambient 0, diffuse 1) in muted colours; the two rooms have ambient 0.3
 * and diffuse 0.7, since a headlight leaves walls seen at a grazing angle black. Surfaces are
 * triangles only; smooth surfaces carry point normals, flat ones carry none, so that VTK takes the
 * facet's normal. The same call gives the same scene everywhere: random numbers come from a
 * written-out generator.
 *
 * A program that looks for the geometry itself finds vtkActor props whose mapper is a
 * vtkPolyDataMapper with triangles, or (see SphereStyle) points with their radii in the point array
 * SphereRadiusArray(). No actor is transformed.
 */

#ifndef vtkSSAOScenes_h
#define vtkSSAOScenes_h

#include <string>
#include <vector>

class vtkRenderer;

namespace vtkSSAOScenes
{
/// What a scene is made from.
enum class Kind
{
  Analytic,   ///< simple bodies, with closed forms of the visibility in places
  Procedural, ///< computed geometry, no files
  Real        ///< read from the data directory
};

/// How molecules are drawn.
enum class SphereStyle
{
  Impostors, ///< vtkOpenGLSphereMapper: one sprite per sphere, exact depth and normals
  Glyphs     ///< vtkGlyph3DMapper with a sphere of 16 x 8 facets: slow for the ribosome
};

/// What is known about a scene.
struct Info
{
  std::string Name;                ///< one of Names()
  Kind SceneKind = Kind::Analytic; ///< what it is made from
  std::string Description;         ///< a line
  /// Occlusion radius in the scene's world units.
  double Radius = 0.0;
  /// File in the data directory that the scene needs; empty for computed scenes.
  std::string DataFile = {};
  int NumberOfViews = 0; ///< places of the camera
};

/// The names of all scenes: analytic, then procedural, then real ones.
std::vector<std::string> Names();

/// "analytic", "procedural" or "real".
const char* KindName(Kind kind);

/// Point array with the radii of impostor or glyphed spheres (float, world units).
const char* SphereRadiusArray();

/// What is known about a scene. An unknown name gives a warning and an Info with an empty Name.
const Info& GetInfo(const std::string& name);

/**
 * Add the props of a scene to a renderer, and set its background and camera.
 *
 * @param name one of Names()
 * @param view 0 to GetInfo(name).NumberOfViews - 1
 * @param renderer an empty renderer; its lights stay VTK's default, a headlight
 * @param dataDirectory the folder that holds the real scenes' files; not used by other scenes
 * @param error receives the message of a failure; without it a failure is a VTK warning
 * @param spheres how molecules are drawn
 * @return false, and an untouched renderer, for an unknown name or view and for missing data
 */
bool Build(const std::string& name, int view, vtkRenderer* renderer,
  const std::string& dataDirectory, std::string* error = nullptr,
  SphereStyle spheres = SphereStyle::Impostors);

/// Only move the camera of a renderer that already holds the scene. Fails as Build does.
bool SetView(
  const std::string& name, int view, vtkRenderer* renderer, std::string* error = nullptr);
}

#endif
