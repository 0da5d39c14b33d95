// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAODenoiseStage.h"

#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass3BoxFS.h"
#include "vtkSSAOPass3EdgeAwareFS.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool vtkSSAODenoiseStage::Render(const vtkSSAOView& view, bool edgeAware, int noiseSize,
  vtkTextureObject* geometry, vtkTextureObject* visibility)
{
  std::string source = edgeAware ? vtkSSAOPass3EdgeAwareFS : vtkSSAOPass3BoxFS;
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
  program->SetUniformi("noiseSize", noiseSize);
  const bool drawn = this->DrawToOutput(view, 1);
  visibility->Deactivate();
  geometry->Deactivate();
  return drawn;
}
