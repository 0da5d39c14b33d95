// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOView
 * @brief   Where a frame is drawn and how its pixels relate to view coordinates.
 *
 * The one place where VTK's matrices (row-major, double) become what the shaders get.
 */

#ifndef vtkSSAOView_h
#define vtkSSAOView_h

#include "vtkSSAOProjection.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;

class vtkSSAOView
{
public:
  /**
   * The view of a render state. IsValid() tells whether it can be drawn into.
   */
  explicit vtkSSAOView(const vtkRenderState* state);

  /**
   * True if the framebuffer that the state draws into is known, bound, and has room for the
   * capture; WhyInvalid() says otherwise what is wrong, in words.
   */
  bool IsValid() const { return this->Reason == nullptr; }
  const char* WhyInvalid() const { return this->Reason; }

  /**
   * Set the uniforms that glsl/vtkSSAOPassViewFS.glsl declares, but for the texture.
   */
  void SetUniforms(vtkShaderProgram* program) const;

  /**
   * The view of textures with one pixel for each square of this view's, from the textures' corner
   * on; edge of the squares in pixels, 1 for this view itself.
   */
  vtkSSAOView Coarse(int edge) const;

  /**
   * Set DepthOrigin, and the projection with it.
   */
  void CountDepthsFrom(double origin);

  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  vtkOpenGLFramebufferObject* Framebuffer; ///< draws the scene
  glm::ivec4 Viewport;                     ///< x, y, width, height in pixels of Framebuffer
  glm::ivec4 Drawn;                        ///< the part of Viewport in which stages draw
  glm::ivec2 TextureSize;                  ///< size of textures that share its pixel coordinates
  glm::dvec4 PixelOfTexel;      ///< (scale, offset): pixel of Framebuffer at a texel's centre
  glm::dvec4 DeviceOfScene;     ///< (scale, offset): of normalized device coordinates
  int Samples;                  ///< samples per pixel of Framebuffer, 0 for one
  bool Clamped;                 ///< whether Framebuffer holds colours up to 1 only
  vtkSSAOProjection Projection; ///< with depths counted from DepthOrigin on

  /**
   * How far in front of the camera captured depths begin, world units. In parallel projection the
   * camera may be far from a scene that a narrow clipping range encloses: near depths keep the
   * digits that far ones have not in float32. 0 if there is nothing to gain.
   */
  double DepthOrigin;

  /**
   * (scale, offset): captured depth of a clip coordinate z. 0 where z in view coordinates is as
   * good.
   */
  glm::dvec2 DepthOfClip;

private:
  glm::dmat4 ClipOfView;
  const char* Reason = nullptr;
};

#endif
