// SPDX-License-Identifier: BSD-3-Clause
#include "Lighting.h"

#include <algorithm>
#include <cmath>

namespace deferred
{
namespace
{
double Attenuation(const Surface& surface, const PointLight& light)
{
  const double distance = (light.Position - surface.Position).Norm();
  return 1.0 / (1.0 + light.Linear * distance + light.Quadratic * distance * distance);
}
}

//------------------------------------------------------------------------------
vtkVector3d AmbientTerm(const Surface& surface, AmbientLight ambient)
{
  const vtkVector3d white(1.0, 1.0, 1.0);
  const vtkVector3d color = ambient == AmbientLight::TimesAlbedo ? surface.Albedo : white;
  return color * (AmbientStrength * surface.Visibility);
}

//------------------------------------------------------------------------------
vtkVector3d DiffuseTerm(const Surface& surface, const PointLight& light)
{
  const vtkVector3d toLight = (light.Position - surface.Position).Normalized();
  const double lambert = std::max(0.0, surface.Normal.Dot(toLight));
  return surface.Albedo * light.Color * (lambert * Attenuation(surface, light));
}

//------------------------------------------------------------------------------
vtkVector3d SpecularTerm(const Surface& surface, const PointLight& light)
{
  const vtkVector3d toLight = (light.Position - surface.Position).Normalized();
  const vtkVector3d toViewer = (surface.Position * -1.0).Normalized();
  const vtkVector3d halfway = (toLight + toViewer).Normalized();
  const double share = std::pow(std::max(0.0, surface.Normal.Dot(halfway)), SpecularExponent);
  return light.Color * (share * Attenuation(surface, light));
}
}
