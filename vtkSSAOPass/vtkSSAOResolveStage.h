// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOResolveStage
 * @brief   Stage 1 under multisampling: one geometry per pixel from the samples.
 */

#ifndef vtkSSAOResolveStage_h
#define vtkSSAOResolveStage_h

#include "vtkSSAOFullScreenStage.h"

class vtkSSAOResolveStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws to the output texture: the geometry of the first sample that has any. False on failure.
   */
  bool Render(const vtkSSAOView& view, vtkTextureObject* geometry);
};

#endif
