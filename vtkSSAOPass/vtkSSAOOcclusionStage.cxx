// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOOcclusionStage.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSSAOKernel.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass2Hemisphere.h"
#include "vtkSSAOPass2OcclusionFS.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> NewTable(
  const vtkSSAOView& view, int width, int height, int components, const float* values)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(view.Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->Create2DFromRaw(width, height, components, VTK_FLOAT, const_cast<float*>(values));
  return texture;
}

//------------------------------------------------------------------------------
void Release(vtkSmartPointer<vtkTextureObject>& texture, vtkWindow* window)
{
  if (texture)
  {
    texture->ReleaseGraphicsResources(window);
    texture = nullptr;
  }
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
void vtkSSAOOcclusionStage::UpdateSamples(
  const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings)
{
  if (!this->Kernel || static_cast<int>(this->Kernel->GetWidth()) != settings.KernelSize)
  {
    const std::vector<glm::vec4> kernel = vtkSSAOHemisphereKernel(settings.KernelSize);
    this->Kernel = NewTable(view, settings.KernelSize, 1, 4, &kernel[0].x);
  }
  if (!this->Noise || static_cast<int>(this->Noise->GetWidth()) != settings.NoiseSize)
  {
    const std::vector<glm::vec2> tile = vtkSSAORotationTile(settings.NoiseSize);
    this->Noise = NewTable(view, settings.NoiseSize, settings.NoiseSize, 2, &tile[0].x);
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOOcclusionStage::Render(
  const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings, vtkTextureObject* geometry)
{
  this->UpdateSamples(view, settings);

  std::string source = vtkSSAOPass2OcclusionFS;
  vtkShaderProgram::Substitute(source, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram::Substitute(source, "//SSAO::Estimator", vtkSSAOPass2Hemisphere);
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  geometry->Activate();
  this->Kernel->Activate();
  this->Noise->Activate();
  view.SetUniforms(program);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("kernelTexture", this->Kernel->GetTextureUnit());
  program->SetUniformi("noiseTexture", this->Noise->GetTextureUnit());
  program->SetUniformf("radius", static_cast<float>(settings.Radius));
  program->SetUniformf("bias", static_cast<float>(settings.Bias));
  program->SetUniformi("kernelSize", settings.KernelSize);
  program->SetUniformf("noiseSize", static_cast<float>(settings.NoiseSize));
  const bool drawn = this->DrawToOutput(view, 1);
  this->Noise->Deactivate();
  this->Kernel->Deactivate();
  geometry->Deactivate();
  return drawn;
}
