// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOOcclusionStage
 * @brief   Stage 2: captured geometry to raw ambient visibility.
 */

#ifndef vtkSSAOOcclusionStage_h
#define vtkSSAOOcclusionStage_h

#include "vtkSSAOFullScreenStage.h"

struct vtkSSAOOcclusionSettings;

class vtkSSAOOcclusionStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws V to the output texture (one component): 1 open, 0 closed, 1 where there is no surface.
   * geometry has one sample per pixel. False on failure.
   */
  bool Render(
    const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings, vtkTextureObject* geometry);

  void ReleaseGraphicsResources(vtkWindow* window) override;
  unsigned long GetTextureMemory() const override;

private:
  void UpdateSamples(const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings);

  vtkSmartPointer<vtkTextureObject> Kernel;
  int KernelEstimator = -1; // whose sample points they are
  vtkSmartPointer<vtkTextureObject> Noise;
};

#endif
