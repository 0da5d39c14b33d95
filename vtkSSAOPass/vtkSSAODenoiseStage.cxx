// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAODenoiseStage.h"

#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass3BoxCenteredFS.h"
#include "vtkSSAOPass3BoxFS.h"
#include "vtkSSAOPass3EdgeAwareFS.h"
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
    case Pass::SeparableGaussian:
      return vtkSSAOPass3SeparableGaussianFS;
    default:
      return vtkSSAOPass3EdgeAwareFS;
  }
}
}

//------------------------------------------------------------------------------
void vtkSSAODenoiseStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkSSAOFullScreenStage::ReleaseGraphicsResources(window);
  if (this->Across)
  {
    this->Across->ReleaseGraphicsResources(window);
    this->Across = nullptr;
  }
}

//------------------------------------------------------------------------------
unsigned long vtkSSAODenoiseStage::GetTextureMemory() const
{
  return this->vtkSSAOFullScreenStage::GetTextureMemory() + GetBytes(this->Across);
}

//------------------------------------------------------------------------------
bool vtkSSAODenoiseStage::Render(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings,
  vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  if (settings.Denoiser == Pass::SeparableGaussian)
  {
    return this->RenderAlong(view, settings, true, geometry, visibility, &this->Across) &&
      this->RenderAlong(view, settings, false, geometry, this->Across, nullptr);
  }
  this->Across = nullptr;
  return this->RenderAlong(view, settings, true, geometry, visibility, nullptr);
}

//------------------------------------------------------------------------------
// One step. Without a target the result is the stage's output.
bool vtkSSAODenoiseStage::RenderAlong(const vtkSSAOView& view,
  const vtkSSAODenoiseSettings& settings, bool across, vtkTextureObject* geometry,
  vtkTextureObject* visibility, vtkSmartPointer<vtkTextureObject>* target)
{
  std::string source = DenoiserSource(settings.Denoiser);
  vtkShaderProgram::Substitute(source, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  geometry->Activate();
  visibility->Activate();
  view.SetUniforms(program);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("visibility", visibility->GetTextureUnit());
  program->SetUniformi("noiseSize", settings.NoiseSize);
  const float axis[2] = { across ? 1.0F : 0.0F, across ? 0.0F : 1.0F };
  program->SetUniform2f("axis", axis);
  program->SetUniformf("largestStep", static_cast<float>(0.5 * settings.Radius));
  const bool drawn = target ? this->DrawToTexture(view, 1, *target) : this->DrawToOutput(view, 1);
  visibility->Deactivate();
  geometry->Deactivate();
  return drawn;
}
