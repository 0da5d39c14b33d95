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
  const char key = this->Interactor->GetKeyCode();
  if (!this->Use || !this->Use(key))
  {
    this->Superclass::OnChar();
    if (key == 'f' || key == 'F')
    {
      this->Interactor->Render(); // arrived: the frames on the way were those of a movement
    }
  }
}
}
