// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAODenoiseStage
 * @brief   Stage 3: raw ambient visibility to smooth visibility.
 */

#ifndef vtkSSAODenoiseStage_h
#define vtkSSAODenoiseStage_h

#include "vtkSSAOFullScreenStage.h"

class vtkSSAODenoiseStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws to the output texture (one component) with the denoiser Box, or EdgeAware if edgeAware.
   * noiseSize: edge of the tile of rotations, which the mean spans, in pixels. False on failure.
   */
  bool Render(const vtkSSAOView& view, bool edgeAware, int noiseSize, vtkTextureObject* geometry,
    vtkTextureObject* visibility);
};

#endif
