// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAODenoiseStage
 * @brief   Stage 3: raw ambient visibility to smooth visibility.
 */

#ifndef vtkSSAODenoiseStage_h
#define vtkSSAODenoiseStage_h

#include "vtkSSAOFullScreenStage.h"

struct vtkSSAODenoiseSettings
{
  int Denoiser = 0;     ///< DenoiserType of the public class, not None
  int NoiseSize = 4;    ///< edge of the noise tile, which the mean spans, in estimated pixels
  int Downsampling = 1; ///< edge in pixels of the squares of which one pixel was estimated
  double Radius = 1.0;  ///< of the estimator, in world units
};

class vtkSSAODenoiseStage : public vtkSSAOFullScreenStage
{
public:
  /**
   * Draws to the output texture (one component). False on failure.
   */
  bool Render(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings,
    vtkTextureObject* geometry, vtkTextureObject* visibility);

  ///@{
  /**
   * The two parts of Render with downsampling: the estimated pixels denoised, (visibility, depth),
   * or nullptr on failure; and the others interpolated from these into the output texture.
   */
  vtkTextureObject* DenoiseEstimated(const vtkSSAOView& view,
    const vtkSSAODenoiseSettings& settings, vtkTextureObject* geometry,
    vtkTextureObject* visibility);
  bool Interpolate(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings,
    vtkTextureObject* geometry, vtkTextureObject* estimated);
  ///@}

  /**
   * Set what a program needs that looks visibility up at estimated pixels, one of each square of
   * the edge downsampling. Both textures are active.
   */
  static void SetUniforms(vtkShaderProgram* program, const vtkSSAOView& view, int downsampling,
    vtkTextureObject* geometry, vtkTextureObject* visibility);

  void ReleaseGraphicsResources(vtkWindow* window) override;
  unsigned long GetTextureMemory() const override;

private:
  bool DrawStep(const vtkSSAOView& view, const vtkSSAODenoiseSettings& settings, const char* shader,
    bool across, vtkTextureObject* geometry, vtkTextureObject* visibility,
    vtkSmartPointer<vtkTextureObject>* target);

  vtkSmartPointer<vtkTextureObject> Between; // after the first of two steps
};

#endif
