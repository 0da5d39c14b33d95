// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOResolveStage.h"

#include "vtkSSAOPass1ResolveFS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

//------------------------------------------------------------------------------
bool vtkSSAOResolveStage::Render(const vtkSSAOView& view, vtkTextureObject* geometry)
{
  vtkShaderProgram* program = this->UseProgram(view.Window, vtkSSAOPass1ResolveFS);
  if (!program)
  {
    return false;
  }
  geometry->Activate();
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("samples", view.Samples);
  const bool drawn = this->DrawToOutput(view, 4);
  geometry->Deactivate();
  return drawn;
}
