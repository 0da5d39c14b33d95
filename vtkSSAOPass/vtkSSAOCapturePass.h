// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOCapturePass
 * @brief   Stage 1: draws the opaque props and captures their geometry and light.
 *
 * The props are drawn into the renderer's own framebuffer, to which up to three textures are
 * attached meanwhile:
 *  - geometry (RGBA32F): linear view depth as the mapper interpolates it, in float32, packed
 *    shading normal, packed facet normal, 1. Depth 0: no lit surface. Position is rebuilt from
 *    depth and pixel, which loses nothing: the pixel is exact and the depth is the mapper's own
 *    float, so the error is one rounding, where a stored position would take three channels more.
 *    A depth rebuilt from the depth buffer would be wrong from near/far 1e6 on.
 *  - occludable (RGBA32F): the part of the colour that occlusion may take, alpha as the colour's.
 *  - lit (RGBA32F): the colour before clamping; only where a prop may exceed what the picture
 *    holds or is drawn in linear light (PBR).
 *
 * Props whose shaders cannot be hooked (anything but actors with a mapper and assemblies of them)
 * are left over and drawn by RenderRemainder() once the occlusion has been applied, so nothing can
 * darken them.
 */

#ifndef vtkSSAOCapturePass_h
#define vtkSSAOCapturePass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h" // For members
#include "vtkTimeStamp.h"    // For members

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

class vtkSSAOView;
class vtkTextureObject;

class vtkSSAOCapturePass : public vtkOpenGLRenderPass
{
public:
  static vtkSSAOCapturePass* New();
  vtkTypeMacro(vtkSSAOCapturePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The pass that draws opaque props, not owned; set while it is in use.
   */
  void SetOpaquePass(vtkRenderPass* pass) { this->OpaquePass = pass; }

  /**
   * Shares of the ambient, the diffuse and the whole colour that occlusion may take, each 0 or 1.
   * All 0: only geometry is captured.
   */
  void SetOccludableWeights(const glm::vec3& weights) { this->Weights = weights; }

  /**
   * Whether the driver takes what this pass adds to the shaders of mappers: VTK 9.1 does not
   * survive a mapper whose shader fails. layers: the shaders of DrawLayers, otherwise those of
   * Capture.
   */
  bool CanCompile(const vtkSSAOView& view, bool layers);

  /**
   * Find the props that can be captured. If depths of the view do not begin at the camera, let them
   * begin near these, if it can be told where they are.
   */
  void Prepare(const vtkRenderState* s, vtkSSAOView& view);

  /**
   * Draw the props that can be captured, and capture them. False if the textures could not be
   * attached: then nothing was drawn.
   */
  bool Capture(const vtkRenderState* s, const vtkSSAOView& view);

  /**
   * The part of the viewport outside which the captured props draw nothing: (x, y, width, height)
   * in pixels. The whole viewport if a prop may draw beyond its bounds.
   */
  glm::ivec4 RectangleOnScreen(const vtkSSAOView& view);

  /**
   * All that the shape and place of the captured surfaces depend on, as numbers to compare: equal
   * lists, equal geometry. Empty if that cannot be told.
   */
  std::vector<double> DescribeFrame(const vtkSSAOView& view);

  /**
   * Draw the captured props again into the framebuffer that is bound, as four numbers for each
   * fragment: -depth, and depth again if it is within reach of the first surface or -depth if not,
   * if it shows its front, and the same if it shows its back, -1e30 each otherwise. Only what lies
   * behind the first surface counts, or, if before is what such a drawing left, between its nearest
   * and farthest. before: the captured geometry, one sample per pixel, or the layers; sheet:
   * thickness of sprites, reach: how far behind the first surface layers matter, in world units.
   */
  void DrawLayers(const vtkRenderState* s, const vtkSSAOView& view, vtkTextureObject* before,
    bool first, double sheet, double reach);

  /**
   * Whether a captured prop draws points as spheres, whose size VTK gives in pixels.
   */
  bool DrawsPointSprites() const;

  /**
   * Draw what Capture left over, without capturing.
   */
  void RenderRemainder(const vtkRenderState* s);

  /**
   * Draw everything without capturing.
   */
  void Render(const vtkRenderState* s) override;

  ///@{
  /**
   * What was captured; nullptr for what was not needed. Multisampled if the view is. Without
   * occludable light, if any was asked for, the whole colour of the captured surfaces is.
   */
  vtkTextureObject* GetGeometry() const { return this->Geometry; }
  vtkTextureObject* GetOccludable() const;
  vtkTextureObject* GetLit() const;
  ///@}

  /**
   * Whether the context in which something was captured is gone.
   */
  bool HasLostContext() const;

  /**
   * Bytes that the textures take, used in the last frame or not.
   */
  unsigned long GetTextureMemory() const;

  /**
   * Whether any prop was drawn that writes lit surfaces.
   */
  bool HasSurfaces() const { return this->Surfaces; }

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  vtkMTimeType GetShaderStageMTime() override { return this->ShadersChanged.GetMTime(); }

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSSAOCapturePass() = default;
  ~vtkSSAOCapturePass() override = default;

private:
  vtkSSAOCapturePass(const vtkSSAOCapturePass&) = delete;
  void operator=(const vtkSSAOCapturePass&) = delete;

  void CountDepthsFromProps(vtkSSAOView& view);
  bool ShowsOccludableLightOnly(const vtkSSAOView& view) const;
  bool Attach(const vtkSSAOView& view, unsigned int outputs);
  void Detach(const vtkSSAOView& view, unsigned int outputs);
  void RenderHooked(const vtkRenderState* s, bool layers);
  void RenderProps(const vtkRenderState* s, std::vector<vtkProp*>& props);

  vtkRenderPass* OpaquePass = nullptr;
  std::array<bool, 2> Compiles = {}; // known to, by CanCompile
  glm::vec3 Weights = glm::vec3(0.0F);
  glm::vec4 DepthOfWindow = glm::vec4(0.0F);
  glm::vec2 DepthOfClip = glm::vec2(0.0F);
  float DepthOrigin = 0.0F;
  float Perspective = 1.0F;
  bool Surfaces = false;
  bool Layers = false; // whether the shaders draw layers instead of the picture
  unsigned int Outputs = 1;
  std::vector<vtkProp*> Captured;
  std::vector<vtkProp*> Remainder;
  vtkTextureObject* LayersBefore = nullptr; // set while layers are drawn
  bool FirstRound = true;
  glm::vec4 BeforePlace = glm::vec4(1.0F);
  glm::vec4 DeviceOfScene = glm::vec4(1.0F);
  float Sheet = 0.0F;
  float Reach = 0.0F;
  glm::vec2 Margin = glm::vec2(0.0F);
  float FirstKnown = 1.0F;
  vtkTimeStamp ShadersChanged;
  vtkSmartPointer<vtkTextureObject> Geometry;
  vtkSmartPointer<vtkTextureObject> Occludable;
  vtkSmartPointer<vtkTextureObject> Lit;
};

#endif
