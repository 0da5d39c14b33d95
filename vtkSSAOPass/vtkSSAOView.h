// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOView
 * @brief   Where a frame is drawn and how its pixels relate to view coordinates.
 *
 * The one place where VTK's matrices (row-major, double) become what the shaders get.
 */

#ifndef vtkSSAOView_h
#define vtkSSAOView_h

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;

/**
 * The projection as ssaoPositionVC and ssaoPixelOf in glsl/vtkSSAOPass0Functions.glsl take it.
 */
struct vtkSSAOProjection
{
  glm::dvec4 PixelToRay = glm::dvec4(1.0, 0.0, 0.0, 1.0);
  glm::dvec4 RayToPixel = glm::dvec4(1.0, 0.0, 0.0, 1.0);
  glm::dvec4 RayOffset = glm::dvec4(0.0);
  glm::dvec2 DepthSlope = glm::dvec2(0.0);
  glm::dvec4 DepthOfWindow = glm::dvec4(0.0);
  double Perspective = 1.0;

  /**
   * From a matrix that takes view to clip coordinates and a viewport (x, y, width, height) in
   * pixels. The clip w must be -z (perspective) or 1 (parallel).
   */
  static vtkSSAOProjection FromMatrix(const glm::dmat4& clipOfView, const glm::ivec4& viewport);
};

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

  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  vtkOpenGLFramebufferObject* Framebuffer; ///< draws the scene
  glm::ivec4 Viewport;                     ///< x, y, width, height in pixels of Framebuffer
  glm::ivec2 TextureSize;                  ///< size of textures that share its pixel coordinates
  int Samples;                             ///< samples per pixel of Framebuffer, 0 for one
  bool Clamped;                            ///< whether Framebuffer holds colours up to 1 only
  vtkSSAOProjection Projection;

private:
  const char* Reason = nullptr;
};

#endif
