// SPDX-License-Identifier: BSD-3-Clause
// The mouse turns the scene as VTK's trackball does; keys go to the program first.
#ifndef InteractiveViewer_KeyStyle_h
#define InteractiveViewer_KeyStyle_h

#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>
#include <utility>

namespace viewer
{
class KeyStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static KeyStyle* New();
  vtkTypeMacro(KeyStyle, vtkInteractorStyleTrackballCamera);

  /// Gets each key that types a character, and returns whether it has a use for it. VTK gets only
  /// the others, so that e does not end the program.
  void SetKeyFunction(std::function<bool(char key)> function) { this->Use = std::move(function); }

  void OnChar() override;

  /// Whether the camera is moved, by the mouse or by VTK's key f.
  bool IsMoving() const { return this->State != VTKIS_NONE || this->AnimState == VTKIS_ANIM_ON; }

private:
  std::function<bool(char key)> Use;
};
}

#endif
