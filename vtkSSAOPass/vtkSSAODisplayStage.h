// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAODisplayStage
 * @brief   Shows visibility, normals or depth in place of the picture.
 */

#ifndef vtkSSAODisplayStage_h
#define vtkSSAODisplayStage_h

#include "vtkSSAOFullScreenStage.h"

#include <glm/vec4.hpp>

class vtkSSAODisplayStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws over the whole viewport of view. mode is an OutputModeType of the public class; source
   * the viewport within the textures. False on failure.
   */
  bool Render(const vtkSSAOView& view, int mode, const glm::ivec4& source,
    vtkTextureObject* geometry, vtkTextureObject* visibility);
};

#endif
