// SPDX-License-Identifier: BSD-3-Clause

// Pixels to positions and back, for every kind of projection: the numbers that the shaders get give
// what the projection matrix gives.

#include "vtkSSAOProjection.h"
#include "vtkSSAOShaderFunctions.h"
#include "vtkSSAOTestMonitor.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <string>

namespace
{
//------------------------------------------------------------------------------
void TestMatrix(vtkSSAOTestMonitor& test, const std::string& what, const glm::dmat4& clipOfView,
  const glm::ivec4& viewport, double nearest, double farthest)
{
  const vtkSSAOProjection p = vtkSSAOProjection::FromMatrix(clipOfView, viewport);
  test.ExpectEqual(p.Perspective, clipOfView[3][3] == 0.0 ? 1.0 : 0.0, what + "perspective");
  double pixelError = 0.0;
  double positionError = 0.0;
  double depthError = 0.0;
  double floatError = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    // A point within the view, from the matrix alone.
    const glm::dvec2 pixel(
      viewport.x + viewport.z * std::fmod(i * 0.618, 1.0), viewport.y + viewport.w * (i / 1000.0));
    const double depth = nearest * std::pow(farthest / nearest, std::fmod(i * 0.755, 1.0));
    const glm::dvec2 ndc((pixel.x - viewport.x) / viewport.z * 2.0 - 1.0,
      (pixel.y - viewport.y) / viewport.w * 2.0 - 1.0);
    const glm::dvec4 onAxis = clipOfView * glm::dvec4(0.0, 0.0, -depth, 1.0);
    const glm::dvec4 unproject =
      glm::inverse(clipOfView) * glm::dvec4(ndc * onAxis.w, onAxis.z, onAxis.w);
    const glm::dvec3 position = glm::dvec3(unproject) / unproject.w;

    const glm::vec3 rebuilt =
      shader::ssaoPositionVC(glm::vec2(pixel), static_cast<float>(depth), glm::vec4(p.PixelToRay),
        glm::vec4(p.RayOffset), glm::vec2(p.DepthSlope), static_cast<float>(p.Perspective));
    positionError = std::max(positionError,
      glm::length(glm::dvec3(rebuilt) - position) /
        (std::abs(position.x) + std::abs(position.y) + depth));
    const glm::vec2 back = shader::ssaoPixelOf(rebuilt, glm::vec4(p.RayToPixel),
      glm::vec4(p.RayOffset), glm::vec2(p.DepthSlope), static_cast<float>(p.Perspective));
    pixelError = std::max(pixelError, glm::length(glm::dvec2(back) - pixel));
    const double windowDepth = 0.5 * onAxis.z / onAxis.w + 0.5;
    // In double by the same formula: float loses what a window depth loses.
    const double ndcZ = 2.0 * windowDepth - 1.0;
    depthError = std::max(depthError,
      std::abs(-(p.DepthOfWindow.y - ndcZ * p.DepthOfWindow.w) /
          (ndcZ * p.DepthOfWindow.z - p.DepthOfWindow.x) / depth -
        1.0));
    floatError = std::max(floatError,
      std::abs(
        shader::ssaoDepthOfWindow(static_cast<float>(windowDepth), glm::vec4(p.DepthOfWindow)) /
          depth -
        1.0));
  }
  // Two roundings of float32 at about 1000 pixels: 1000 x 6e-8 each.
  test.ExpectAtMost(positionError, 1.0e-6, what + "relative error of the position");
  test.ExpectAtMost(pixelError, 2.0e-3, what + "error of the pixel");
  test.ExpectAtMost(depthError, 1.0e-9, what + "relative error of the depth, in double");
  test.ExpectAtMost(floatError, 1.0e-3, what + "relative error of the depth, in float");
}
}

//------------------------------------------------------------------------------
int UnitTestSSAOProjection(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (const glm::ivec4& viewport : { glm::ivec4(0, 0, 800, 600), glm::ivec4(123, 45, 301, 199) })
  {
    const std::string at = " at " + std::to_string(viewport.x) + ": ";
    const double aspect = static_cast<double>(viewport.z) / viewport.w;
    TestMatrix(
      test, "perspective" + at, glm::perspective(0.5, aspect, 1.0, 100.0), viewport, 1.0, 100.0);
    TestMatrix(test, "off-axis perspective" + at, glm::frustum(-0.2, 0.7, -0.1, 0.3, 1.0, 100.0),
      viewport, 1.0, 100.0);
    TestMatrix(test, "parallel" + at, glm::ortho(-2.0 * aspect, 2.0 * aspect, -2.0, 2.0, 1.0, 9.0),
      viewport, 1.0, 9.0);
    TestMatrix(test, "off-centre parallel" + at, glm::ortho(-1.0, 5.0, 0.0, 3.0, 1.0, 9.0),
      viewport, 1.0, 9.0);
    // A shear, as VTK's view shear and stereo give.
    glm::dmat4 shear(1.0);
    shear[2][0] = 0.3;
    shear[2][1] = -0.2;
    TestMatrix(test, "sheared parallel" + at,
      glm::ortho(-2.0 * aspect, 2.0 * aspect, -2.0, 2.0, 1.0, 9.0) * shear, viewport, 1.0, 9.0);
    // A view that is rolled in the projection.
    const glm::dmat4 roll = glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0.0, 0.0, 1.0));
    TestMatrix(test, "rolled perspective" + at, roll * glm::perspective(0.5, aspect, 1.0, 100.0),
      viewport, 1.0, 100.0);
  }
  return test.GetResult();
}
