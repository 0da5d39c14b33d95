// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOProjection.h"

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace
{
//------------------------------------------------------------------------------
// Rows of a 2x2 matrix as the shaders take them.
glm::dvec4 Rows(const glm::dmat2& m)
{
  return { m[0][0], m[1][0], m[0][1], m[1][1] };
}
}

//------------------------------------------------------------------------------
vtkSSAOProjection vtkSSAOProjection::FromMatrix(
  const glm::dmat4& clipOfView, const glm::ivec4& viewport)
{
  // With d = -z and w = d (perspective) or 1 (parallel), the first two rows of the matrix read
  //   ndc w = L (x, y) - M d + T,   L 2x2, M and T its third and fourth columns,
  // and ndc = scale pixel + origin. Solved for (x, y):
  //   (x, y) = (inverse(L) ndc) w + inverse(L) M d - inverse(L) T
  const glm::dmat2 linear(clipOfView);
  const glm::dmat2 inverse = glm::inverse(linear);
  const glm::dvec2 scale(2.0 / viewport.z, 2.0 / viewport.w);
  const glm::dvec2 origin(-1.0 - scale.x * viewport.x, -1.0 - scale.y * viewport.y);

  vtkSSAOProjection projection;
  const glm::dmat2 pixelToRay = inverse * glm::dmat2(scale.x, 0.0, 0.0, scale.y);
  const glm::dvec2 rayOffset = inverse * origin;
  const glm::dvec2 shift = -(inverse * glm::dvec2(clipOfView[3]));
  projection.PixelToRay = Rows(pixelToRay);
  projection.RayToPixel = Rows(glm::inverse(pixelToRay));
  projection.RayOffset = glm::dvec4(rayOffset, shift);
  projection.DepthSlope = inverse * glm::dvec2(clipOfView[2]);
  projection.DepthOfWindow =
    glm::dvec4(clipOfView[2][2], clipOfView[3][2], clipOfView[2][3], clipOfView[3][3]);
  projection.Perspective = clipOfView[2][3] != 0.0 ? 1.0 : 0.0;
  return projection;
}
