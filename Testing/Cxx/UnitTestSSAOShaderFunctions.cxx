// SPDX-License-Identifier: BSD-3-Clause

// The text of the shaders, compiled as C++ through GLM, in float and in double, without OpenGL.

#include "vtkSSAOKernel.h"
#include "vtkSSAOTestMonitor.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif

// The names of GLSL for one precision, the functions, and the estimator with what
// glsl/vtkSSAOPass2OcclusionFS.glsl gives it.
namespace
{
namespace inFloat
{
using namespace glm;
using Scalar = float;
#include "glsl/vtkSSAOPass0Functions.glsl"
struct Estimator
{
  vec4 pixelToRay, rayToPixel, rayOffset, viewport;
  vec2 depthSlope;
  float perspective, radius, bias;
  int kernelSize;
  std::function<vec4(vec2)> ssaoGeometryAt;
  std::vector<vec4> kernel;
  int rangeCheck = 1;
  vec2 rotation;
  vec3 ssaoKernelAt(int index) { return vec3(kernel[index].x, kernel[index].y, kernel[index].z); }
  vec2 ssaoRotationAt(vec2) { return rotation; }
  vec4 ssaoNoiseAt(vec2) { return vec4(0, 0, rotation.x, rotation.y); }
#include "glsl/vtkSSAOPass2Hemisphere.glsl"
};
}
namespace inDouble
{
using namespace glm;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using Scalar = double;
#define float double
#include "glsl/vtkSSAOPass0Functions.glsl"
struct Estimator
{
  vec4 pixelToRay, rayToPixel, rayOffset, viewport;
  vec2 depthSlope;
  float perspective, radius, bias;
  int kernelSize;
  std::function<vec4(vec2)> ssaoGeometryAt;
  std::vector<vec4> kernel;
  int rangeCheck = 1;
  vec2 rotation;
  vec3 ssaoKernelAt(int index) { return vec3(kernel[index].x, kernel[index].y, kernel[index].z); }
  vec2 ssaoRotationAt(vec2) { return rotation; }
  vec4 ssaoNoiseAt(vec2) { return vec4(0, 0, rotation.x, rotation.y); }
#include "glsl/vtkSSAOPass2Hemisphere.glsl"
};
#undef float
}

// The same tests in both precisions: `inPrecision` is inFloat, then inDouble.
#define inPrecision inFloat
#include "UnitTestSSAOShaderFunctionsBody.h"
#undef inPrecision
#define inPrecision inDouble
#include "UnitTestSSAOShaderFunctionsBody.h"
#undef inPrecision

//------------------------------------------------------------------------------
// What float loses against double.
void TestPrecisions(vtkSSAOTestMonitor& test)
{
  double strength = 0.0;
  double range = 0.0;
  double weight = 0.0;
  for (int i = 0; i <= 200; ++i)
  {
    const double t = i / 200.0;
    strength = std::max(strength,
      std::abs(inFloat::ssaoStrength(float(t), 1.7F, 0.8F, 1.1F, 0.05F) -
        inDouble::ssaoStrength(t, 1.7, 0.8, 1.1, 0.05)));
    range = std::max(range,
      std::abs(
        inFloat::ssaoRangeCheck(float(5.0 * t), 1.0F) - inDouble::ssaoRangeCheck(5.0 * t, 1.0)));
    const auto inSingle =
      inFloat::ssaoPlaneThrough(glm::normalize(glm::vec3(0.3, 0.1, 1.0)), glm::vec2(50.5F), 4.0F,
        glm::vec4(0.01, 0, 0, 0.01), glm::vec4(-0.5, -0.5, 0, 0), glm::vec2(0.0F), 1.0F);
    const auto exact =
      inDouble::ssaoPlaneThrough(glm::normalize(glm::dvec3(0.3, 0.1, 1.0)), glm::dvec2(50.5), 4.0,
        glm::dvec4(0.01, 0, 0, 0.01), glm::dvec4(-0.5, -0.5, 0, 0), glm::dvec2(0.0), 1.0);
    weight = std::max(weight,
      std::abs(inFloat::ssaoPlaneWeight(inSingle, float(3.9 + 0.2 * t), glm::vec2(2, 3)) -
        inDouble::ssaoPlaneWeight(exact, 3.9 + 0.2 * t, glm::dvec2(2, 3))));
  }
  test.ExpectAtMost(strength, 1.0e-6, "float against double: strength");
  test.ExpectAtMost(range, 1.0e-6, "float against double: range check");
  // A depth near 4 is rounded to 2.4e-7, in half footprints of .02 over a way of 3.6 pixels.
  test.ExpectAtMost(weight, 1.0e-5, "float against double: plane weight");
}
}

//------------------------------------------------------------------------------
int UnitTestSSAOShaderFunctions(int, char*[])
{
  vtkSSAOTestMonitor test;
  inFloat::TestAll(test, "float, ");
  inDouble::TestAll(test, "double, ");
  TestPrecisions(test);
  return test.GetResult();
}
