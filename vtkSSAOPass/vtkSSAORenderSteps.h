// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAORenderSteps
 * @brief   The steps of a renderer that has no pass, with one's own opaque step.
 *
 * Opaque props (the opaque step sets up the lights), translucent props (depth peeling or
 * order-independent translucency, as the renderer's flags say), FXAA, volumes, overlays: the order
 * of vtkOpenGLRenderer::UpdateGeometry. Used below a vtkCameraPass.
 */

#ifndef vtkSSAORenderSteps_h
#define vtkSSAORenderSteps_h

#include "vtkNew.h" // For members
#include "vtkRenderPass.h"

class vtkOpenGLFXAAFilter;
class vtkOpenGLRenderer;
class vtkShadowMapPass;

class vtkSSAORenderSteps : public vtkRenderPass
{
public:
  static vtkSSAORenderSteps* New();
  vtkTypeMacro(vtkSSAORenderSteps, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The pass that draws the opaque props, not owned; set while it is in use.
   */
  void SetOpaquePass(vtkRenderPass* pass) { this->OpaquePass = pass; }

  /**
   * Why the opaque props are drawn by another pass than the one that was set, in words, or nullptr.
   */
  static const char* WhyOtherPass(const vtkRenderState* s);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSSAORenderSteps();
  ~vtkSSAORenderSteps() override;

private:
  vtkSSAORenderSteps(const vtkSSAORenderSteps&) = delete;
  void operator=(const vtkSSAORenderSteps&) = delete;

  void RenderOpaque(const vtkRenderState* s);
  void RenderFXAA(vtkOpenGLRenderer* renderer);

  vtkRenderPass* OpaquePass = nullptr;
  vtkNew<vtkOpenGLFXAAFilter> FXAAFilter;
  vtkNew<vtkShadowMapPass> ShadowMapPass; // for a renderer with shadows
};

#endif
