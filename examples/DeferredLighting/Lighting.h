// SPDX-License-Identifier: BSD-3-Clause
// The lighting pass of LearnOpenGL, "SSAO": Blinn-Phong, its ambient term times the visibility.
#ifndef DeferredLighting_Lighting_h
#define DeferredLighting_Lighting_h

#include <vtkVector.h>
#if __has_include(<vtkVectorOperators.h>) // VTK 9.6 has what is in it in vtkVector.h
#include <vtkVectorOperators.h>
#endif

namespace deferred
{
/// What one pixel shows, in view coordinates: the viewer is in the origin and looks along -z.
struct Surface
{
  bool Seen = false;       // false: no lit opaque surface here, and the rest means nothing
  vtkVector3d Position;    // world units
  vtkVector3d Normal;      // of length 1, towards the viewer
  vtkVector3d Albedo;      // red, green, blue in [0, 1]; the background's colour where none is seen
  double Visibility = 1.0; // of the ambient light: 1 open, 0 closed
};

/// Its light falls off with distance as 1 / (1 + Linear d + Quadratic d^2).
struct PointLight
{
  vtkVector3d Position; // in view coordinates
  vtkVector3d Color;
  double Linear = 0.0;    // per world unit
  double Quadratic = 0.0; // per world unit squared
};

/// LearnOpenGL multiplies the ambient light with the albedo; its older version did not.
enum class AmbientLight
{
  TimesAlbedo,
  WithoutAlbedo
};

const double AmbientStrength = 0.3;
const double SpecularExponent = 8.0;

/// The only term that occlusion concerns: 0.3 x albedo x V, or 0.3 x V.
vtkVector3d AmbientTerm(const Surface& surface, AmbientLight ambient);

vtkVector3d DiffuseTerm(const Surface& surface, const PointLight& light);
vtkVector3d SpecularTerm(const Surface& surface, const PointLight& light);
}

#endif
