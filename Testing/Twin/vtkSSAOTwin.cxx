// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTwin.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkSSAOKernel.h"
#include "vtkSSAOOcclusionSettings.h"
#include "vtkSSAOShaderFunctions.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace twin
{
using namespace glm;
namespace
{
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
#define float double
// What a shader of stage 2 sees besides its own text: its types, its uniforms, its textures and the
// shared functions. In double.
struct OcclusionShader
{
  vec4 viewport;
  vec4 drawn;
  vec4 pixelToRay;
  vec4 rayToPixel;
  vec4 rayOffset;
  vec2 depthSlope;
  vec4 depthOfWindow;
  float perspective;
  float radius;
  float bias;
  int kernelSize;
  int rangeCheck;
  int halfRule;
  float minimumDifference;
  float falloffExponent;
  int falloff;
  int directions;
  int steps;
  int allSteps;
  float leastReach;
  vec2 angleBias;
  vec2 sliceTurn;
  float ssaoCertainty = 1.0;
  float sheet;
  int noiseTile;
  float depthScale; // all depths that are looked up are multiplied by it
  const std::vector<glm::vec4>* geometry;
  const std::vector<glm::vec4>* kernel;
  const std::vector<glm::vec4>* noise;
  const std::vector<glm::vec4>* solids; // two for each texel
  int solidsWidth;
  int solidsHeight;
  vec4 solidsPlace; // (scale, offset): pixel of a texel of these

  // Index of the nearest texel of a texture of that size, clamped to the edge.
  static std::size_t TexelAt(const vec2& texel, int width, int height)
  {
    const float x = std::min(std::max(std::floor(texel.x), 0.0), width - 1.0);
    const float y = std::min(std::max(std::floor(texel.y), 0.0), height - 1.0);
    const int column = std::isfinite(x) ? static_cast<int>(x) : width - 1;
    const int row = std::isfinite(y) ? static_cast<int>(y) : height - 1;
    return static_cast<std::size_t>(row) * width + column;
  }

  vec4 ssaoGeometryAt(const vec2& pixel) const
  {
    vec4 texel(
      (*geometry)[TexelAt(pixel, static_cast<int>(viewport.z), static_cast<int>(viewport.w))]);
    texel.x *= depthScale;
    return texel;
  }

  vec4 ssaoSolidsAt(const vec2& texel) const
  {
    return vec4((*solids)[2 * TexelAt(texel, solidsWidth, solidsHeight)]) * depthScale;
  }

  vec4 ssaoMoreSolidsAt(const vec2& texel) const
  {
    return vec4((*solids)[2 * TexelAt(texel, solidsWidth, solidsHeight) + 1]) * depthScale;
  }

  vec3 ssaoKernelAt(int index) const { return vec3(vec4((*kernel)[index])); }

  vec4 ssaoNoiseAt(const vec2& pixel) const
  {
    const int column = static_cast<int>(pixel.x) % noiseTile;
    const int row = static_cast<int>(pixel.y) % noiseTile;
    return vec4((*noise)[static_cast<std::size_t>(row) * noiseTile + column]);
  }

#include "glsl/vtkSSAOPass0Functions.glsl"
#include "glsl/vtkSSAOPass0SliceFunctions.glsl"
};

struct CrytekSphere : OcclusionShader
{
#include "glsl/vtkSSAOPass2CrytekSphere.glsl"
};

struct PositionSphere : OcclusionShader
{
#include "glsl/vtkSSAOPass2PositionSphere.glsl"
};

struct DepthSphere : OcclusionShader
{
#include "glsl/vtkSSAOPass2DepthSphere.glsl"
};

struct Hemisphere : OcclusionShader
{
#include "glsl/vtkSSAOPass2Hemisphere.glsl"
};

struct HemisphereLinearDepth : OcclusionShader
{
#include "glsl/vtkSSAOPass2HemisphereLinearDepth.glsl"
};

struct ReflectedHemisphere : OcclusionShader
{
#include "glsl/vtkSSAOPass2ReflectedHemisphere.glsl"
};

struct HorizonAngle : OcclusionShader
{
#include "glsl/vtkSSAOPass2HorizonAngle.glsl"
};

struct ExactHorizon : OcclusionShader
{
#include "glsl/vtkSSAOPass2ExactHorizon.glsl"
};

struct LayeredBitmask : OcclusionShader
{
#include "glsl/vtkSSAOPass2LayeredBitmask.glsl"
};
#undef float

//------------------------------------------------------------------------------
// The stage's main() for every pixel.
template <typename Estimator>
std::vector<double> Draw(const OcclusionShader& uniforms, int width, int height, const vec2& shift)
{
  std::vector<double> visibility(static_cast<std::size_t>(width) * height);
  // Threads take rows as they get free; a pixel depends on nothing but the captured geometry.
  std::atomic<int> nextRow(0);
  const auto work = [&]()
  {
    Estimator shader;
    static_cast<OcclusionShader&>(shader) = uniforms;
    for (int y = nextRow++; y < height; y = nextRow++)
    {
      for (int x = 0; x < width; ++x)
      {
        const vec2 pixel(x + 0.5, y + 0.5);
        const std::size_t index = static_cast<std::size_t>(y) * width + x;
        const glm::vec4& center = (*uniforms.geometry)[index];
        const vec2 ray = shader.ssaoRayThrough(
          pixel, shader.pixelToRay, shader.rayOffset, shader.depthSlope, shader.perspective);
        const double reach = shader.ssaoLargestReach(
          shader.radius, center.x, ray, shader.rayToPixel, shader.perspective);
        shader.steps = reach >= shader.leastReach ? shader.allSteps : 0;
        visibility[index] =
          center.x > 0.0F ? shader.ssaoVisibility(pixel + shift, vec4(center)) : 1.0;
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned int i = 1; i < std::thread::hardware_concurrency(); ++i)
  {
    others.emplace_back(work);
  }
  work();
  for (std::thread& other : others)
  {
    other.join();
  }
  return visibility;
}
}
}

//------------------------------------------------------------------------------
vtkSSAOTwin::vtkSSAOTwin(vtkImageData* geometry, vtkCamera* camera)
{
  int size[3];
  geometry->GetDimensions(size);
  this->Width = size[0];
  this->Height = size[1];

  const double aspect = static_cast<double>(this->Width) / this->Height;
  vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0);
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      matrix[column][row] = projection->GetElement(row, column);
    }
  }
  this->Projection =
    vtkSSAOProjection::FromMatrix(matrix, glm::ivec4(0, 0, this->Width, this->Height));

  const auto* pixel = static_cast<const float*>(geometry->GetScalarPointer());
  const std::size_t pixels = static_cast<std::size_t>(this->Width) * this->Height;
  this->Geometry.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i, pixel += 8)
  {
    this->Geometry.push_back(pixel[0] > 0.0F
        ? glm::vec4(pixel[0], shader::ssaoPackNormal(glm::vec3(pixel[1], pixel[2], pixel[3])),
            shader::ssaoPackFacet(glm::vec3(pixel[4], pixel[5], pixel[6]), pixel[7]), 1.0F)
        : glm::vec4(0.0F));
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTwin::SetSolids(vtkImageData* solids)
{
  const auto* pixel = static_cast<const float*>(solids->GetScalarPointer());
  int size[3];
  solids->GetDimensions(size);
  this->SolidsWidth = size[0];
  this->SolidsHeight = size[1];
  this->Solids.clear();
  for (vtkIdType i = 0; i < 2 * solids->GetNumberOfPoints(); ++i, pixel += 4)
  {
    this->Solids.emplace_back(pixel[0], pixel[1], pixel[2], pixel[3]);
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkSSAOTwin::Visibility(
  const vtkSSAOOcclusionSettings& settings, const vtkSSAODisturbance& disturbance) const
{
  const std::vector<glm::vec4> kernel = settings.MakeKernel();
  const std::vector<glm::vec4> noise = settings.MakeNoise();
  const double angle = glm::radians(settings.AngleBias);
  twin::OcclusionShader uniforms;
  uniforms.viewport = glm::dvec4(0.0, 0.0, this->Width, this->Height);
  uniforms.drawn = uniforms.viewport;
  uniforms.pixelToRay = this->Projection.PixelToRay;
  uniforms.rayToPixel = this->Projection.RayToPixel;
  uniforms.rayOffset = this->Projection.RayOffset;
  uniforms.depthSlope = this->Projection.DepthSlope;
  uniforms.depthOfWindow = this->Projection.DepthOfWindow;
  uniforms.perspective = this->Projection.Perspective;
  uniforms.radius = settings.Radius;
  uniforms.bias = settings.Bias;
  uniforms.kernelSize = settings.KernelSize;
  uniforms.rangeCheck = settings.RangeCheck ? 1 : 0;
  uniforms.halfRule = settings.HalfRule ? 1 : 0;
  uniforms.minimumDifference = settings.MinimumDifference;
  uniforms.falloffExponent = 1.0 / settings.Attenuation;
  uniforms.falloff = settings.Falloff;
  uniforms.directions = settings.Directions;
  uniforms.allSteps = settings.Steps;
  uniforms.leastReach = settings.LeastReach();
  uniforms.angleBias = glm::dvec2(std::cos(angle), std::sin(angle));
  uniforms.sliceTurn = glm::dvec2(std::cos(settings.SliceAngle()), std::sin(settings.SliceAngle()));
  uniforms.sheet = settings.Sheet;
  uniforms.solids = &this->Solids;
  uniforms.solidsWidth = this->SolidsWidth;
  uniforms.solidsHeight = this->SolidsHeight;
  // As vtkSSAOView::Coarse: a texel is the first pixel of its square.
  // With one layer nothing is drawn once more, and no resolution reduced.
  const bool reduced = this->SolidsWidth < this->Width || this->SolidsHeight < this->Height;
  const double edge = reduced ? settings.LayerDownsampling : 1;
  uniforms.solidsPlace = glm::dvec4(edge, edge, 0.5 - 0.5 * edge, 0.5 - 0.5 * edge);
  uniforms.noiseTile = settings.NoiseSize;
  uniforms.depthScale = 1.0 + disturbance.Depth;
  uniforms.geometry = &this->Geometry;
  uniforms.kernel = &kernel;
  uniforms.noise = &noise;

  using Pass = vtkScreenSpaceAmbientOcclusionPass;
  const glm::dvec2 shift(disturbance.X, disturbance.Y);
  switch (settings.Estimator)
  {
    case Pass::CrytekSphere:
      return twin::Draw<twin::CrytekSphere>(uniforms, this->Width, this->Height, shift);
    case Pass::PositionSphere:
      return twin::Draw<twin::PositionSphere>(uniforms, this->Width, this->Height, shift);
    case Pass::DepthSphere:
      return twin::Draw<twin::DepthSphere>(uniforms, this->Width, this->Height, shift);
    case Pass::Hemisphere:
      return twin::Draw<twin::Hemisphere>(uniforms, this->Width, this->Height, shift);
    case Pass::HemisphereLinearDepth:
      return twin::Draw<twin::HemisphereLinearDepth>(uniforms, this->Width, this->Height, shift);
    case Pass::ReflectedHemisphere:
      return twin::Draw<twin::ReflectedHemisphere>(uniforms, this->Width, this->Height, shift);
    case Pass::HorizonAngle:
      return twin::Draw<twin::HorizonAngle>(uniforms, this->Width, this->Height, shift);
    case Pass::ExactHorizon:
      return twin::Draw<twin::ExactHorizon>(uniforms, this->Width, this->Height, shift);
    case Pass::LayeredBitmask:
      return this->Solids.empty()
        ? std::vector<double>()
        : twin::Draw<twin::LayeredBitmask>(uniforms, this->Width, this->Height, shift);
    default:
      return {};
  }
}
