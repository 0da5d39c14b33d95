// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOModulateStage.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSSAODenoiseStage.h"
#include "vtkSSAOOpenGL.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass3Interpolation.h"
#include "vtkSSAOPass4ModulateFS.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOScopedBlendEquation.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <limits>
#include <string>
#include <vector>

//------------------------------------------------------------------------------
bool vtkSSAOModulateStage::Render(const vtkSSAOView& view, const vtkSSAOStrength& strength,
  int downsampling, vtkTextureObject* geometry, vtkTextureObject* visibility,
  vtkTextureObject* occludable, vtkTextureObject* lit)
{
  std::string source = vtkSSAOPass4ModulateFS;
  vtkShaderProgram::Substitute(source, "//SSAO::Samples::Dec",
    std::string(view.Samples ? "#extension GL_ARB_sample_shading : require\n"
                               "#define SSAO_MULTISAMPLE\n"
                             : "") +
      (occludable ? "" : "#define SSAO_ALL_OCCLUDABLE\n") +
      (downsampling > 1 ? "#define SSAO_INTERPOLATED\n" : ""));
  vtkShaderProgram::Substitute(source, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram::Substitute(source, "//SSAO::Interpolation", vtkSSAOPass3Interpolation);
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  std::vector<vtkTextureObject*> inputs = { geometry, visibility };
  if (occludable)
  {
    inputs.push_back(occludable);
    inputs.push_back(lit ? lit : occludable);
  }
  for (vtkTextureObject* input : inputs)
  {
    input->Activate();
  }
  const float values[4] = { static_cast<float>(strength.Power),
    static_cast<float>(strength.Intensity), static_cast<float>(strength.Scale),
    static_cast<float>(strength.Shift) };
  vtkSSAODenoiseStage::SetUniforms(program, view, downsampling, geometry, visibility);
  if (occludable)
  {
    program->SetUniformi("occludable", occludable->GetTextureUnit());
    program->SetUniformi("lit", (lit ? lit : occludable)->GetTextureUnit());
  }
  program->SetUniformi("haveLit", lit ? 1 : 0);
  program->SetUniformf("white", view.Clamped ? 1.0F : std::numeric_limits<float>::max());
  program->SetUniform4f("strength", values);

  vtkOpenGLState* state = view.Window->GetState();
  {
    vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
    vtkOpenGLState::ScopedglBlendFuncSeparate blendFunctionSaver(state);
    const vtkSSAOScopedBlendEquation blendEquationSaver(state);
    vtkOpenGLState::ScopedglColorMask colorMaskSaver(state);
    vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
    state->vtkglEnable(GL_BLEND);
    // The picture times the visibility, or less what is taken.
    state->vtkglBlendFuncSeparate(
      occludable ? GL_ONE : GL_ZERO, occludable ? GL_ONE : GL_SRC_COLOR, GL_ZERO, GL_ONE);
    state->vtkglBlendEquationSeparate(
      occludable ? GL_FUNC_REVERSE_SUBTRACT : GL_FUNC_ADD, GL_FUNC_ADD);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_FALSE);
    this->Draw(view);
  }
  for (vtkTextureObject* input : inputs)
  {
    input->Deactivate();
  }
  return true;
}
