// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAODelegateGraft.h"

#include "vtkCameraPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"

//------------------------------------------------------------------------------
vtkSSAODelegateGraft::vtkSSAODelegateGraft(vtkRenderPass* delegate, vtkRenderPass* scion)
  : Root(delegate)
{
  if (vtkOpaquePass::SafeDownCast(delegate))
  {
    this->OpaquePass = delegate;
    this->Root = scion;
  }
  else
  {
    this->Replace(delegate, scion);
  }
}

//------------------------------------------------------------------------------
vtkSSAODelegateGraft::~vtkSSAODelegateGraft()
{
  if (this->Undo)
  {
    this->Undo();
  }
}

//------------------------------------------------------------------------------
bool vtkSSAODelegateGraft::Replace(vtkRenderPass* pass, vtkRenderPass* scion)
{
  // A pass with one delegate: replace it, or look inside it.
  const auto replaceDelegate = [this, scion](auto* owner)
  {
    vtkRenderPass* inner = owner->GetDelegatePass();
    if (vtkOpaquePass::SafeDownCast(inner))
    {
      this->OpaquePass = inner;
      owner->SetDelegatePass(scion);
      this->Undo = [this, owner] { owner->SetDelegatePass(this->OpaquePass); };
      return true;
    }
    return inner && this->Replace(inner, scion);
  };

  if (auto* steps = vtkRenderStepsPass::SafeDownCast(pass))
  {
    this->OpaquePass = steps->GetOpaquePass();
    if (this->OpaquePass)
    {
      steps->SetOpaquePass(scion);
      this->Undo = [this, steps] { steps->SetOpaquePass(this->OpaquePass); };
    }
    return this->OpaquePass != nullptr;
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return replaceDelegate(camera);
  }
  if (auto* image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return replaceDelegate(image);
  }
  if (auto* supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    return replaceDelegate(supersampling);
  }
  if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
    {
      auto* item = vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i));
      if (vtkOpaquePass::SafeDownCast(item))
      {
        this->OpaquePass = item;
        passes->ReplaceItem(i, scion);
        this->Undo = [this, passes, i] { passes->ReplaceItem(i, this->OpaquePass); };
        return true;
      }
      if (this->Replace(item, scion))
      {
        return true;
      }
    }
  }
  return false;
}
