// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOShaderFunctions.h
 * @brief  The functions the shaders share, as C++ in float: the very text the shaders get.
 */

#ifndef vtkSSAOShaderFunctions_h
#define vtkSSAOShaderFunctions_h

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace shader
{
using namespace glm;
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
namespace
{
#include "glsl/vtkSSAOPass0Functions.glsl"
#include "glsl/vtkSSAOPass0SliceFunctions.glsl"
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
}

#endif
