// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTileMargin
 * @brief   Draws more than one tile of a picture that is put together from tiles.
 *
 * vtkWindowToImageFilter and vtkRenderLargeImage draw a large picture as tiles of the window's
 * size. What occludes a pixel beside a seam may lie in the next tile, so while this object lives,
 * the scene is drawn with a margin about the tile, into a framebuffer of its own. The noise pattern
 * goes through all tiles. On destruction camera and framebuffer are as before.
 */

#ifndef vtkSSAOTileMargin_h
#define vtkSSAOTileMargin_h

#include "vtkOpenGLState.h"  // For members
#include "vtkRenderState.h"  // For members
#include "vtkSSAOView.h"     // For members
#include "vtkSmartPointer.h" // For members

#include <memory>
#include <vector>

class vtkCamera;
class vtkOpenGLFramebufferObject;
class vtkProp;
class vtkTextureObject;

class vtkSSAOTileMargin
{
public:
  /**
   * Whether a view shows one tile of several.
   */
  static bool IsNeeded(const vtkSSAOView& view);

  /**
   * tile: what is drawn of the picture; radius: how far occluders are looked for, in world units;
   * period: edge in pixels of what the stages repeat over the picture.
   */
  vtkSSAOTileMargin(const vtkSSAOView& tile, double radius, int period);
  ~vtkSSAOTileMargin();
  vtkSSAOTileMargin(const vtkSSAOTileMargin&) = delete;
  void operator=(const vtkSSAOTileMargin&) = delete;

  /**
   * All visible props of the renderer, also those that do not show in the tile, and the
   * framebuffer.
   */
  const vtkRenderState* GetState() const { return &this->State; }

  /**
   * The view of tile and margin. It is not valid if the framebuffer could not be made.
   */
  vtkSSAOView& GetView() { return *this->View; }

  /**
   * The tile's part of a texture of the view, as a texture with the tile's pixel coordinates.
   */
  vtkSmartPointer<vtkTextureObject> CutTile(vtkTextureObject* texture);

private:
  const vtkSSAOView& Tile;
  vtkOpenGLState::ScopedglViewport ViewportSaver;
  vtkOpenGLState::ScopedglScissor ScissorSaver;
  vtkSmartPointer<vtkCamera> CameraOfTile;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  glm::ivec2 Offset = glm::ivec2(0); // of the tile within the view, in pixels
  std::vector<vtkProp*> Props;
  vtkRenderState State;
  std::unique_ptr<vtkSSAOView> View;
};

#endif
