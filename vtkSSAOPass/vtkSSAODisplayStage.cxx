// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAODisplayStage.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkSSAOOpenGL.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass5DisplayFS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool vtkSSAODisplayStage::Render(const vtkSSAOView& view, int mode, const glm::ivec4& source,
  vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  std::string text = vtkSSAOPass5DisplayFS;
  vtkShaderProgram::Substitute(text, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram* program = this->UseProgram(view.Window, text);
  if (!program)
  {
    return false;
  }
  const glm::vec4 from(source);
  const glm::vec4 to(view.Viewport);
  const float texelSize[2] = { 1.0F / geometry->GetWidth(), 1.0F / geometry->GetHeight() };
  const double* range = view.Renderer->GetActiveCamera()->GetClippingRange();
  const float clippingRange[2] = { static_cast<float>(range[0] - view.DepthOrigin),
    static_cast<float>(range[1] - view.DepthOrigin) };
  geometry->Activate();
  visibility->Activate();
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("visibility", visibility->GetTextureUnit());
  program->SetUniform4f("source", &from[0]);
  program->SetUniform4f("target", &to[0]);
  program->SetUniform2f("texelSize", texelSize);
  program->SetUniformi("mode", mode);
  program->SetUniform2f("clippingRange", clippingRange);

  vtkOpenGLState* state = view.Window->GetState();
  {
    vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
    vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDepthMask(GL_FALSE);
    this->Draw(view);
  }
  visibility->Deactivate();
  geometry->Deactivate();
  return true;
}
