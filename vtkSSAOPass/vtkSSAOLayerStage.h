// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOLayerStage
 * @brief   Between stages 1 and 2: what lies behind the first surface, for estimators that ask.
 *
 * The captured props are drawn again without lighting and depth test, and blending keeps of what
 * lies behind the first surface the nearest front, the farthest front, the nearest back and the
 * farthest back of each pixel: four layers in one drawing. A second drawing gives the four between
 * these (after Bavoil, Myers, "Order Independent Transparency with Dual Depth Peeling", 2008). Then
 * the layers of each pixel become the stretches of its ray that lie inside solids, see ssaoAddLayer
 * in glsl/vtkSSAOPass0SliceFunctions.glsl.
 */

#ifndef vtkSSAOLayerStage_h
#define vtkSSAOLayerStage_h

#include "vtkSSAOFullScreenStage.h"

#include <glm/vec4.hpp>

#include <array>
#include <vector>

class vtkRenderState;
class vtkSSAOCapturePass;

/// What the stage needs to know.
struct vtkSSAOLayerSettings
{
  int Layers = 5;          ///< the first surface included, up to vtkSSAOLayerStage::MostLayers
  int Downsampling = 1;    ///< edge of the squares in pixels of which one is looked behind
  double Radius = 1.0;     ///< of the estimator, world units
  double Sheet = 0.0;      ///< thickness of what has no known back, world units
  bool SheetsOnly = false; ///< every surface has that thickness
};

class vtkSSAOLayerStage : public vtkSSAOFullScreenStage
{
public:
  static constexpr int MostLayers = 9;

  vtkSSAOLayerStage();
  ~vtkSSAOLayerStage() override;

  /**
   * Draws the layers behind the geometry that was captured, unless they cannot matter, and the
   * solids. False on failure.
   */
  bool Render(const vtkRenderState* s, const vtkSSAOView& view, vtkSSAOCapturePass* capture,
    const vtkSSAOLayerSettings& settings, vtkTextureObject* geometry);

  /**
   * Stretches (front, back, front, back) of each pixel's ray inside solids.
   */
  vtkTextureObject* GetSolids() const { return this->Solids; }

  /**
   * The third and fourth stretch.
   */
  vtkTextureObject* GetMoreSolids() const { return this->MoreSolids; }

  /**
   * How often the props were drawn in the last render.
   */
  int GetNumberOfRounds() const { return this->Rounds; }

  /**
   * Where the solids' texels lie in the picture: (scale, offset) from them to pixels; and the
   * texels of the viewport: (x, y, width, height).
   */
  const glm::vec4& GetPixelOfTexel() const { return this->PixelOfTexel; }
  const glm::ivec4& GetViewport() const { return this->Viewport; }

  /**
   * What is known of where nothing is in reach: outside of a rectangle in pixels (x, y, end of x,
   * end of y) all texels go on as one plane, where their packed facet normal is this one. 0 if it
   * is not known.
   */
  const glm::vec4& GetUneven() const { return this->Uneven; }
  float GetEvenFacet() const { return this->EvenFacet; }

  void ReleaseGraphicsResources(vtkWindow* window) override;
  unsigned long GetTextureMemory() const override;

private:
  /**
   * Whether a surface ends before another one, so that layers may matter, and where all is one
   * plane. False on failure.
   */
  bool FindGaps(const vtkSSAOView& scene, const vtkSSAOView& view, double radius,
    vtkTextureObject* geometry, bool& gaps);
  void FindUneven(const vtkSSAOView& view, const std::vector<float>& changes);

  bool DrawRound(const vtkRenderState* s, const vtkSSAOView& view, vtkSSAOCapturePass* capture,
    const vtkSSAOLayerSettings& settings, int round, vtkTextureObject* before);
  bool FindSolids(
    const vtkSSAOView& view, const vtkSSAOLayerSettings& settings, vtkTextureObject* geometry);

  static constexpr int MostRounds = (MostLayers - 1) / 4;
  std::array<vtkSmartPointer<vtkTextureObject>, MostRounds> Layers;
  vtkSmartPointer<vtkTextureObject> Changes; // see glsl/vtkSSAOPass1GapsFS.glsl
  vtkSmartPointer<vtkTextureObject> Solids;
  vtkSmartPointer<vtkTextureObject> MoreSolids;
  vtkNew<vtkOpenGLFramebufferObject> LayerFramebuffer;
  int Rounds = 0;
  glm::vec4 PixelOfTexel = glm::vec4(1.0F, 1.0F, 0.0F, 0.0F);
  glm::ivec4 Viewport = glm::ivec4(0);
  glm::vec4 Uneven = glm::vec4(0.0F);
  float EvenFacet = 0.0F;
};

#endif
