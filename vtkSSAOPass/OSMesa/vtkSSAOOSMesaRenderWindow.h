// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOOSMesaRenderWindow
 * @brief   A render window in memory, for VTK builds that can only open X windows.
 *
 * The window owns an OpenGL core context of libOSMesa, Mesa's software renderer that needs no X
 * server and no graphics card. VTK draws into framebuffer objects of its own, so the buffer that
 * OSMesa asks for is never looked at: it is 4x4 pixels whatever the size of the window, and a
 * resize keeps the context and everything in it.
 *
 * Programs do not name this class. Linking vtkSSAOPass::OSMesa makes vtkRenderWindow::New() return
 * it (see vtkSSAOOSMesaObjectFactory).
 *
 * The window is always off screen. SetOffScreenRendering, SetUseOffScreenBuffers, SetShowWindow and
 * SetFullScreen are accepted and change nothing.
 *
 * Two things must resolve to libOSMesa in the whole process: the extension functions, which GLEW
 * looks up by glXGetProcAddressARB (see vtkSSAOOSMesaProcAddress.cxx), and the OpenGL 1.1 functions
 * that VTK calls as plain symbols, for which libOSMesa has to be loaded before libGL. The CMake
 * target sees to both; a program in which one fails gets an error instead of a crash.
 */

#ifndef vtkSSAOOSMesaRenderWindow_h
#define vtkSSAOOSMesaRenderWindow_h

#include "vtkOpenGLRenderWindow.h"

#include <vector> // for the context stack

class vtkSSAOOSMesaRenderWindow : public vtkOpenGLRenderWindow
{
public:
  /// A window in memory; its context is made by the first render.
  static vtkSSAOOSMesaRenderWindow* New();
  vtkTypeMacro(vtkSSAOOSMesaRenderWindow, vtkOpenGLRenderWindow);
  /// Print the state of the window.
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Create the context unless there is one, and bring it into the state VTK expects. Called by the
   * first render, and again by the first one after ReleaseGraphicsResources or Finalize.
   */
  void Initialize() override;

  /**
   * Free everything in the context and the context itself. The next render makes a new one.
   */
  void Finalize() override;

  /**
   * Finalize and Initialize.
   */
  void WindowRemap() override;

  /**
   * Draw, or report an error and draw nothing if there is no usable context.
   */
  void Render() override;

  /**
   * Bind the framebuffer to draw into. With StencilCapable it really gets a stencil buffer: VTK 9.1
   * allocates one, but does not attach it. StencilCapable may change between renders.
   */
  void Start() override;

  ///@{
  /**
   * The current context of the calling thread. PushContext remembers it and makes this window's
   * own one current; PopContext brings the remembered one back.
   */
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  /**
   * Load the OpenGL functions into GLEW. Unlike the superclass this accepts that GLEW finds no X
   * display, which it only looks for after all OpenGL functions are loaded.
   */
  void OpenGLInitContext() override;

  /**
   * The OSMesaContext, or nullptr before the first render.
   */
  void* GetGenericContext() override { return this->Context; }

  /**
   * There is no screen; 1920 x 1080 for code that places or scales windows by it.
   */
  int* GetScreenSize() override;

  ///@{
  /**
   * Ignored: the window is never shown and never has buffers other than VTK's framebuffer objects.
   */
  void SetShowWindow(bool) override {}
  void SetUseOffScreenBuffers(bool) override {}
  ///@}

protected:
  vtkSSAOOSMesaRenderWindow();
  ~vtkSSAOOSMesaRenderWindow() override;

  ///@{
  /**
   * Create and destroy the context.
   */
  void CreateAWindow() override;
  void DestroyWindow() override;
  ///@}

private:
  vtkSSAOOSMesaRenderWindow(const vtkSSAOOSMesaRenderWindow&) = delete;
  void operator=(const vtkSSAOOSMesaRenderWindow&) = delete;

  /**
   * A context with the buffer it was made current with, since OSMesa wants both to return to it.
   */
  struct CurrentContext
  {
    void* Context = nullptr;
    void* Buffer = nullptr;
    int Type = 0;
    int Width = 0;
    int Height = 0;
  };

  void* Context = nullptr;
  vtkTypeBool FramebufferStencil = 0; // StencilCapable of the existing framebuffers
  std::vector<CurrentContext> ContextStack;
};

#endif
