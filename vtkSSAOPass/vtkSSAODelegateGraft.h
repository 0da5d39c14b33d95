// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAODelegateGraft
 * @brief   Puts a pass in the place of the opaque pass inside a delegate, for as long as it lives.
 *
 * Occlusion must be applied when the opaque props are drawn and nothing else is, so the pass steps
 * in between. The delegate is as it was when the graft is destroyed.
 */

#ifndef vtkSSAODelegateGraft_h
#define vtkSSAODelegateGraft_h

#include "vtkSmartPointer.h" // For members

#include <functional>

class vtkRenderPass;

class vtkSSAODelegateGraft
{
public:
  /**
   * Looks for a vtkOpaquePass in delegate: the delegate itself or inside vtkRenderStepsPass,
   * vtkCameraPass, vtkSequencePass or an image processing pass, and replaces the first one found
   * by scion.
   */
  vtkSSAODelegateGraft(vtkRenderPass* delegate, vtkRenderPass* scion);
  ~vtkSSAODelegateGraft();
  vtkSSAODelegateGraft(const vtkSSAODelegateGraft&) = delete;
  void operator=(const vtkSSAODelegateGraft&) = delete;

  /**
   * The pass that was replaced, or nullptr if there was none.
   */
  vtkRenderPass* GetOpaquePass() const { return this->OpaquePass; }

  /**
   * The pass to render: the delegate, or scion if the delegate itself was replaced.
   */
  vtkRenderPass* GetRoot() const { return this->Root; }

private:
  bool Replace(vtkRenderPass* pass, vtkRenderPass* scion);

  vtkSmartPointer<vtkRenderPass> OpaquePass;
  vtkSmartPointer<vtkRenderPass> Root;
  std::function<void()> Undo;
};

#endif
