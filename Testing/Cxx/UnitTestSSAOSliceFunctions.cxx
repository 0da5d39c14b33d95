// SPDX-License-Identifier: BSD-3-Clause

// The functions of the estimators that cut the hemisphere into slices, and of the layers they look
// at: the text of the shaders, compiled as C++ through GLM, in float and in double, without OpenGL.

#include "vtkNew.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif

namespace
{
namespace inFloat
{
using namespace glm;
using Scalar = float;
#include "glsl/vtkSSAOPass0Functions.glsl"
#include "glsl/vtkSSAOPass0SliceFunctions.glsl"
// After the functions that it calls.
#include "UnitTestSSAOSliceFunctionsEstimator.h"
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
#include "glsl/vtkSSAOPass0SliceFunctions.glsl"
// After the functions that it calls.
#include "UnitTestSSAOSliceFunctionsEstimator.h"
#undef float
}

constexpr double Pi = 3.14159265358979323846;

//------------------------------------------------------------------------------
// Integral of cos(phi - n) |sin(phi)| from 0 to h by Simpson's rule, in double.
double ArcByQuadrature(double h, double n)
{
  const int intervals = 200;
  const double step = h / intervals;
  double sum = 0.0;
  for (int i = 0; i <= intervals; ++i)
  {
    const double phi = i * step;
    const double weight = i == 0 || i == intervals ? 1.0 : (i % 2 ? 4.0 : 2.0);
    sum += weight * std::cos(phi - n) * std::abs(std::sin(phi));
  }
  return sum * step / 3.0;
}

// The same tests in both precisions: `inPrecision` is inFloat, then inDouble.
#define inPrecision inFloat
#include "UnitTestSSAOSliceFunctionsBody.h"
#undef inPrecision
#define inPrecision inDouble
#include "UnitTestSSAOSliceFunctionsBody.h"
#undef inPrecision
}

//------------------------------------------------------------------------------
int UnitTestSSAOSliceFunctions(int, char*[])
{
  vtkSSAOTestMonitor test;
  inFloat::TestAll(test, "float, ");
  inDouble::TestAll(test, "double, ");
  return test.GetResult();
}
