// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOScopedBlendEquation
 * @brief   Restores the equation of blending when it goes out of scope.
 *
 * VTK has such a class for each other part of OpenGL's state that the stages change.
 */

#ifndef vtkSSAOScopedBlendEquation_h
#define vtkSSAOScopedBlendEquation_h

#include "vtkOpenGLState.h"
#include "vtkSSAOOpenGL.h"

class vtkSSAOScopedBlendEquation
{
public:
  explicit vtkSSAOScopedBlendEquation(vtkOpenGLState* state)
    : State(state)
  {
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_RGB, &this->Colour);
    state->vtkglGetIntegerv(GL_BLEND_EQUATION_ALPHA, &this->Alpha);
  }
  ~vtkSSAOScopedBlendEquation()
  {
    this->State->vtkglBlendEquationSeparate(
      static_cast<unsigned int>(this->Colour), static_cast<unsigned int>(this->Alpha));
  }
  vtkSSAOScopedBlendEquation(const vtkSSAOScopedBlendEquation&) = delete;
  void operator=(const vtkSSAOScopedBlendEquation&) = delete;

private:
  vtkOpenGLState* State;
  int Colour = 0;
  int Alpha = 0;
};

#endif
