// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOFullScreenStage
 * @brief   What the stages that draw one quad over the viewport share.
 *
 * A stage has one program for each text of its shader that it was ever drawn with, and may have one
 * output texture, which shares the pixel coordinates of the renderer's framebuffer.
 */

#ifndef vtkSSAOFullScreenStage_h
#define vtkSSAOFullScreenStage_h

#include "vtkNew.h"          // For members
#include "vtkSmartPointer.h" // For members

#include <glm/vec4.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkSSAOView;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkSSAOFullScreenStage
{
public:
  vtkSSAOFullScreenStage();
  virtual ~vtkSSAOFullScreenStage();
  vtkSSAOFullScreenStage(const vtkSSAOFullScreenStage&) = delete;
  void operator=(const vtkSSAOFullScreenStage&) = delete;

  /**
   * The texture the stage has drawn, or nullptr before.
   */
  vtkTextureObject* GetOutput() const { return this->Output; }

  /**
   * Number of programs built since construction.
   */
  int GetNumberOfProgramBuilds() const { return this->ProgramBuilds; }

  virtual void ReleaseGraphicsResources(vtkWindow* window);

  /**
   * Bytes that the textures of the stage take now.
   */
  virtual unsigned long GetTextureMemory() const { return GetBytes(this->Output); }

  /**
   * Bytes that a texture of NewTexture takes; 0 for nullptr.
   */
  static unsigned long GetBytes(vtkTextureObject* texture);

  /**
   * Set so many draw buffers of the framebuffer that is bound to none. VTK's cache looks at the
   * buffers that are asked for only, and keeps the others when another framebuffer is bound: what
   * has used more than one must not leave them there, or the next one does not get its second.
   */
  static void ForgetDrawBuffers(vtkOpenGLRenderWindow* window, unsigned int count);

  /**
   * A texture with the format's number of float components, 1, 2 or 4 with 32 bits each, nearest
   * filtered, not initialised. samples 0: one sample per pixel.
   */
  static vtkSmartPointer<vtkTextureObject> NewTexture(
    vtkOpenGLRenderWindow* window, int width, int height, int components, int samples);

  /**
   * The part of a texture that lies in a rectangle (x, y, width, height), row by row, all
   * components of a pixel together; empty without a texture, if its context is gone, or if the
   * rectangle lies outside.
   */
  static std::vector<float> Download(vtkTextureObject* texture, const glm::ivec4& rectangle);

protected:
  /**
   * The program of a fragment shader, bound and ready for uniforms, or nullptr if it does not
   * compile (VTK has then reported the compiler's messages).
   */
  vtkShaderProgram* UseProgram(vtkOpenGLRenderWindow* window, const std::string& fragmentShader);

  /**
   * Draw the quad over the viewport into the framebuffer that is bound.
   */
  void Draw(const vtkSSAOView& view);

  /**
   * Draw the quad into the output texture, which gets so many components and the view's size.
   * False if the framebuffer is incomplete.
   */
  bool DrawToOutput(const vtkSSAOView& view, int components);

  /**
   * The same with another texture, which is made if it is nullptr.
   */
  bool DrawToTexture(
    const vtkSSAOView& view, int components, vtkSmartPointer<vtkTextureObject>& texture);

  /**
   * The same with several outputs, in the order of the shader's.
   */
  bool DrawToTextures(const vtkSSAOView& view, int components,
    const std::vector<vtkSmartPointer<vtkTextureObject>*>& textures);

  /**
   * Release a texture's resources and forget it; it may be nullptr.
   */
  static void Release(vtkSmartPointer<vtkTextureObject>& texture, vtkWindow* window);

private:
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads; // by fragment shader
  vtkOpenGLQuadHelper* Quad = nullptr;                               // the one in use
  int ProgramBuilds = 0;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkTextureObject> Output;
  int OutputComponents = 0;
};

#endif
