// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAODenoiseStage.h"

#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass3BoxCenteredFS.h"
#include "vtkSSAOPass3BoxFS.h"
#include "vtkSSAOPass3EdgeAwareFS.h"
#include "vtkSSAOPass3InterpolateFS.h"
#include "vtkSSAOPass3Interpolation.h"
#include "vtkSSAOPass3SeparableGaussianFS.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOView.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

//------------------------------------------------------------------------------
const char* DenoiserSource(int denoiser)
{
  switch (denoiser)
  {
    case Pass::Box:
      return vtkSSAOPass3BoxFS;
    case Pass::BoxCentered:
      return vtkSSAOPass3BoxCenteredFS;
    default:
      return vtkSSAOPass3EdgeAwareFS;
  }
}
}

//------------------------------------------------------------------------------
void vtkSSAODenoiseStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkSSAOFullScreenStage::ReleaseGraphicsResources(window);
  Release(this->Between, window);
}

//------------------------------------------------------------------------------
unsigned long vtkSSAODenoiseStage::GetTextureMemory() const
{
  return this->vtkSSAOFullScreenStage::GetTextureMemory() + GetBytes(this->Between);
}

//------------------------------------------------------------------------------
bool vtkSSAODenoiseStage::Render(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings,
  vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  if (settings.Denoiser == Pass::SeparableGaussian)
  {
    return this->DrawStep(view, settings, vtkSSAOPass3SeparableGaussianFS, true, geometry,
             visibility, &this->Between) &&
      this->DrawStep(
        view, settings, vtkSSAOPass3SeparableGaussianFS, false, geometry, this->Between, nullptr);
  }
  if (settings.Downsampling > 1)
  {
    vtkTextureObject* estimated = this->DenoiseEstimated(view, settings, geometry, visibility);
    return estimated && this->Interpolate(view, settings, geometry, estimated);
  }
  this->Between = nullptr;
  return this->DrawStep(
    view, settings, DenoiserSource(settings.Denoiser), true, geometry, visibility, nullptr);
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkSSAODenoiseStage::DenoiseEstimated(const vtkSSAOView& view,
  const vtkSSAODenoiseSettings& settings, vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  if (settings.NoiseSize == 1)
  {
    this->Between = nullptr;
    return visibility;
  }
  return this->DrawStep(
           view, settings, vtkSSAOPass3EdgeAwareFS, true, geometry, visibility, &this->Between)
    ? this->Between
    : nullptr;
}

//------------------------------------------------------------------------------
bool vtkSSAODenoiseStage::Interpolate(const vtkSSAOView& view,
  const vtkSSAODenoiseSettings& settings, vtkTextureObject* geometry, vtkTextureObject* estimated)
{
  return this->DrawStep(
    view, settings, vtkSSAOPass3InterpolateFS, true, geometry, estimated, nullptr);
}

//------------------------------------------------------------------------------
void vtkSSAODenoiseStage::SetUniforms(vtkShaderProgram* program, const vtkSSAOView& view,
  int downsampling, vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  view.SetUniforms(program);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("visibility", visibility->GetTextureUnit());
  program->SetUniformf("downsampling", static_cast<float>(downsampling));
  const float coarseTexelSize[2] = { 1.0F / visibility->GetWidth(),
    1.0F / visibility->GetHeight() };
  program->SetUniform2f("coarseTexelSize", coarseTexelSize);
  const glm::vec4 estimated(view.Coarse(downsampling).Drawn);
  program->SetUniform4f("estimated", &estimated[0]);
}

//------------------------------------------------------------------------------
// One step. Without a target the result is the stage's output.
bool vtkSSAODenoiseStage::DrawStep(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings,
  const char* shader, bool across, vtkTextureObject* geometry, vtkTextureObject* visibility,
  vtkSmartPointer<vtkTextureObject>* target)
{
  std::string source = shader;
  vtkShaderProgram::Substitute(source, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram::Substitute(source, "//SSAO::Interpolation", vtkSSAOPass3Interpolation);
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  geometry->Activate();
  visibility->Activate();
  SetUniforms(program, view, settings.Downsampling, geometry, visibility);
  program->SetUniformi("noiseSize", settings.NoiseSize);
  const float axis[2] = { across ? 1.0F : 0.0F, across ? 0.0F : 1.0F };
  program->SetUniform2f("axis", axis);
  program->SetUniformf("largestStep", static_cast<float>(0.5 * settings.Radius));
  // A target in between has one pixel for each that was estimated: visibility, depth and certainty.
  const bool drawn = target ? this->DrawToTexture(view.Coarse(settings.Downsampling), 4, *target)
                            : this->DrawToOutput(view, 1);
  visibility->Deactivate();
  geometry->Deactivate();
  return drawn;
}
