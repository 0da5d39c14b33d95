// SPDX-License-Identifier: BSD-3-Clause
// Which pass draws a frame: the one that the user chose, or, while the camera moves, a cheaper one.
#ifndef InteractiveViewer_FrameBudget_h
#define InteractiveViewer_FrameBudget_h

#include <vtkNew.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>

namespace viewer
{
class FrameBudget
{
public:
  using Pass = vtkScreenSpaceAmbientOcclusionPass;

  /// The pass for the next frame. The one for movements follows the chosen one in all but quality:
  /// it is Fast, with fewer pixels estimated or without occlusion where that took too long.
  Pass* Choose(Pass* chosen, bool moving);

  /// Tells how long the frame took. Above the budget, movements go on with less.
  void Judge(double seconds, double budget);

  /// How movements are drawn.
  const char* GetName() const;

  Pass* GetMovingPass() { return this->Moving; }

private:
  void SetLevel(int level);

  vtkNew<Pass> Moving;
  bool IsMoving = false;
  int Level = -1; // before the first movement
  int Frames = 0; // drawn at this level in this movement
};
}

#endif
