// SPDX-License-Identifier: BSD-3-Clause
#include "KeyStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace viewer
{
vtkStandardNewMacro(KeyStyle);

//------------------------------------------------------------------------------
void KeyStyle::OnChar()
{
  if (!this->Use || !this->Use(this->Interactor->GetKeyCode()))
  {
    this->Superclass::OnChar();
  }
}
}
