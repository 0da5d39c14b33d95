// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOModulateStage
 * @brief   Stage 4: takes the occluded part of the light from the picture.
 *
 * Draws into the renderer's framebuffer with blending that subtracts or multiplies, so pixels
 * without occlusion are not touched at all, whatever was in the framebuffer.
 */

#ifndef vtkSSAOModulateStage_h
#define vtkSSAOModulateStage_h

#include "vtkSSAOFullScreenStage.h"

/**
 * Parameters of ssaoStrength.
 */
struct vtkSSAOStrength
{
  double Power = 1.0;
  double Intensity = 1.0;
  double Scale = 1.0;
  double Shift = 0.0;
};

class vtkSSAOModulateStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * geometry and visibility: one sample per pixel; or with downsampling above 1, visibility of one
   * pixel of each square of that edge, interpolated here. occludable and lit (may be nullptr) as
   * captured. Without occludable light the whole colour of the surfaces is. False on failure: then
   * the picture is as it was.
   */
  bool Render(const vtkSSAOView& view, const vtkSSAOStrength& strength, int downsampling,
    vtkTextureObject* geometry, vtkTextureObject* visibility, vtkTextureObject* occludable,
    vtkTextureObject* lit);
};

#endif
