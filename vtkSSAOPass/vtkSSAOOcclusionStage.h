// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOOcclusionStage
 * @brief   Stage 2: captured geometry to raw ambient visibility.
 */

#ifndef vtkSSAOOcclusionStage_h
#define vtkSSAOOcclusionStage_h

#include "vtkSSAOFullScreenStage.h"

class vtkSSAOLayerStage;
struct vtkSSAOOcclusionSettings;

class vtkSSAOOcclusionStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws V, depth, certainty and whether samples were taken to the output texture: V is 1 open, 0
   * closed, 1 and depth 0 where there is no surface.
   * geometry has one sample per pixel; layers is drawn if the estimator looks behind it.
   * False on failure.
   */
  bool Render(const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings,
    vtkTextureObject* geometry, const vtkSSAOLayerStage& layers);

  void ReleaseGraphicsResources(vtkWindow* window) override;
  unsigned long GetTextureMemory() const override;

private:
  void UpdateSamples(const vtkSSAOView& view, const vtkSSAOOcclusionSettings& settings);

  vtkSmartPointer<vtkTextureObject> Kernel;
  int KernelEstimator = -1; // whose sample points they are
  vtkSmartPointer<vtkTextureObject> Noise;
  int NoiseSlices = 0; // for how many slices its angles are, 0 for none
};

#endif
