// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOOcclusionStage.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSSAOLayerStage.h"
#include "vtkSSAOOcclusionSettings.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass0SliceFunctions.h"
#include "vtkSSAOPass2CrytekSphere.h"
#include "vtkSSAOPass2DepthSphere.h"
#include "vtkSSAOPass2ExactHorizon.h"
#include "vtkSSAOPass2Hemisphere.h"
#include "vtkSSAOPass2HemisphereLinearDepth.h"
#include "vtkSSAOPass2HorizonAngle.h"
#include "vtkSSAOPass2LayeredBitmask.h"
#include "vtkSSAOPass2OcclusionFS.h"
#include "vtkSSAOPass2PositionSphere.h"
#include "vtkSSAOPass2ReflectedHemisphere.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/trigonometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

//------------------------------------------------------------------------------
// The shader of an estimator, which defines ssaoVisibility().
const char* EstimatorSource(int estimator)
{
  switch (estimator)
  {
    case Pass::CrytekSphere:
      return vtkSSAOPass2CrytekSphere;
    case Pass::PositionSphere:
      return vtkSSAOPass2PositionSphere;
    case Pass::DepthSphere:
      return vtkSSAOPass2DepthSphere;
    case Pass::HemisphereLinearDepth:
      return vtkSSAOPass2HemisphereLinearDepth;
    case Pass::ReflectedHemisphere:
      return vtkSSAOPass2ReflectedHemisphere;
    case Pass::HorizonAngle:
      return vtkSSAOPass2HorizonAngle;
    case Pass::ExactHorizon:
      return vtkSSAOPass2ExactHorizon;
    case Pass::LayeredBitmask:
      return vtkSSAOPass2LayeredBitmask;
    default:
      return vtkSSAOPass2Hemisphere;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> NewTable(
  const vtkSSAOView& view, int width, int height, const std::vector<glm::vec4>& values)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(view.Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->Create2DFromRaw(width, height, 4, VTK_FLOAT, const_cast<float*>(&values[0].x));
  return texture;
}

//------------------------------------------------------------------------------
// The controls; a program has those that its estimator reads.
void SetUniforms(vtkShaderProgram* program, const vtkSSAOOcclusionSettings& settings)
{
  program->SetUniformf("radius", static_cast<float>(settings.Radius));
  program->SetUniformf("bias", static_cast<float>(settings.Bias));
  program->SetUniformi("samplesInKernel", settings.KernelSize);
  program->SetUniformf("noiseSize", static_cast<float>(settings.NoiseSize));
  program->SetUniformi("rangeCheck", settings.RangeCheck ? 1 : 0);
  program->SetUniformi("halfRule", settings.HalfRule ? 1 : 0);
  program->SetUniformf("minimumDifference", static_cast<float>(settings.MinimumDifference));
  program->SetUniformf("falloffExponent", static_cast<float>(1.0 / settings.Attenuation));
  program->SetUniformi("falloff", settings.Falloff);
  program->SetUniformi("allDirections", settings.Directions);
  program->SetUniformi("allSteps", settings.Steps);
  program->SetUniformf("leastReach", static_cast<float>(settings.LeastReach()));
  const double angle = glm::radians(settings.AngleBias);
  const float angleBias[2] = { static_cast<float>(std::cos(angle)),
    static_cast<float>(std::sin(angle)) };
  program->SetUniform2f("angleBias", angleBias);
  const float sliceTurn[2] = { static_cast<float>(std::cos(settings.SliceAngle())),
    static_cast<float>(std::sin(settings.SliceAngle())) };
  program->SetUniform2f("sliceTurn", sliceTurn);
  program->SetUniformf("sheet", static_cast<float>(settings.Sheet));
}
}

//------------------------------------------------------------------------------
void vtkSSAOOcclusionStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkSSAOFullScreenStage::ReleaseGraphicsResources(window);
  Release(this->Kernel, window);
  Release(this->Noise, window);
}

//------------------------------------------------------------------------------
unsigned long vtkSSAOOcclusionStage::GetTextureMemory() const
{
  return this->vtkSSAOFullScreenStage::GetTextureMemory() + GetBytes(this->Kernel) +
    GetBytes(this->Noise);
}

//------------------------------------------------------------------------------
void vtkSSAOOcclusionStage::UpdateSamples(
  const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings)
{
  if (!this->Kernel || this->KernelEstimator != settings.Estimator ||
    static_cast<int>(this->Kernel->GetWidth()) != settings.KernelSize)
  {
    this->Kernel = NewTable(view, settings.KernelSize, 1, settings.MakeKernel());
    this->KernelEstimator = settings.Estimator;
  }
  const int slices = settings.UsesSlices() ? settings.Directions : 0;
  if (!this->Noise || static_cast<int>(this->Noise->GetWidth()) != settings.NoiseSize ||
    this->NoiseSlices != slices)
  {
    this->Noise = NewTable(view, settings.NoiseSize, settings.NoiseSize, settings.MakeNoise());
    this->NoiseSlices = slices;
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOOcclusionStage::Render(const vtkSSAOView& view,
  const vtkSSAOOcclusionSettings& settings, vtkTextureObject* geometry,
  const vtkSSAOLayerStage& layers)
{
  this->UpdateSamples(view, settings);

  std::string source = vtkSSAOPass2OcclusionFS;
  vtkShaderProgram::Substitute(
    source, "//SSAO::Functions", std::string(vtkSSAOPass0Functions) + vtkSSAOPass0SliceFunctions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram::Substitute(source, "//SSAO::Estimator", EstimatorSource(settings.Estimator));
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  std::vector<vtkTextureObject*> inputs = { geometry, this->Kernel, this->Noise };
  if (settings.LooksBehind())
  {
    inputs.push_back(layers.GetSolids());
    inputs.push_back(layers.GetMoreSolids());
  }
  for (vtkTextureObject* input : inputs)
  {
    input->Activate();
  }
  view.SetUniforms(program);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("kernelTexture", this->Kernel->GetTextureUnit());
  program->SetUniformi("noiseTexture", this->Noise->GetTextureUnit());
  SetUniforms(program, settings);
  program->SetUniformf("downsampling", static_cast<float>(settings.Downsampling));
  if (settings.LooksBehind())
  {
    const float texelSize[2] = { 1.0F / layers.GetSolids()->GetWidth(),
      1.0F / layers.GetSolids()->GetHeight() };
    program->SetUniformi("solids", layers.GetSolids()->GetTextureUnit());
    program->SetUniformi("moreSolids", layers.GetMoreSolids()->GetTextureUnit());
    program->SetUniform4f("solidsPlace", &layers.GetPixelOfTexel()[0]);
    program->SetUniform2f("solidsTexelSize", texelSize);
    program->SetUniform4f("uneven", &layers.GetUneven()[0]);
    program->SetUniformf("evenFacet", layers.GetEvenFacet());
  }
  const bool drawn = this->DrawToOutput(view.Coarse(settings.Downsampling), 4);
  for (vtkTextureObject* input : inputs)
  {
    input->Deactivate();
  }
  return drawn;
}
