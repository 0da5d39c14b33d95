// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOProjection.h
 * @brief  A projection and a viewport as the shader functions take them. No OpenGL.
 */

#ifndef vtkSSAOProjection_h
#define vtkSSAOProjection_h

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

/**
 * The projection as ssaoPositionVC and ssaoPixelOf in glsl/vtkSSAOPass0Functions.glsl take it.
 */
struct vtkSSAOProjection
{
  glm::dvec4 PixelToRay = glm::dvec4(1.0, 0.0, 0.0, 1.0);
  glm::dvec4 RayToPixel = glm::dvec4(1.0, 0.0, 0.0, 1.0);
  glm::dvec4 RayOffset = glm::dvec4(0.0);
  glm::dvec2 DepthSlope = glm::dvec2(0.0);
  glm::dvec4 DepthOfWindow = glm::dvec4(0.0);
  double Perspective = 1.0;

  /**
   * From a matrix that takes view to clip coordinates and a viewport (x, y, width, height) in
   * pixels. The clip w must be -z (perspective) or 1 (parallel).
   */
  static vtkSSAOProjection FromMatrix(const glm::dmat4& clipOfView, const glm::ivec4& viewport);
};

#endif
