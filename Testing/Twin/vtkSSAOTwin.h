// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTwin
 * @brief   The estimators' shader functions as C++ in double, evaluated on captured buffers.
 *
 * The difference between the picture and its twin is the error of single precision; the difference
 * between the twin and the truth is the error of the method.
 */

#ifndef vtkSSAOTwin_h
#define vtkSSAOTwin_h

#include "vtkSSAOProjection.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkCamera;
class vtkImageData;
struct vtkSSAOOcclusionSettings;

/**
 * What rounding might do: a shift of the pixels, in pixels, and a relative change of the depths
 * that are looked up.
 */
struct vtkSSAODisturbance
{
  double X = 0.0;
  double Y = 0.0;
  double Depth = 0.0;
};

class vtkSSAOTwin
{
public:
  /**
   * geometry as vtkScreenSpaceAmbientOcclusionPass::GetGeometry gives it, and the camera that
   * rendered it into a viewport of the same size.
   */
  vtkSSAOTwin(vtkImageData* geometry, vtkCamera* camera);

  /**
   * What LayeredBitmask needs besides: the solids as the pass's GetSolids gives them, with the
   * settings that Visibility gets.
   */
  void SetSolids(vtkImageData* solids);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  /**
   * Raw visibility, before denoising, of every pixel, row by row from the bottom left. Empty for an
   * estimator that has no twin. All processors take part.
   */
  std::vector<double> Visibility(const vtkSSAOOcclusionSettings& settings,
    const vtkSSAODisturbance& disturbance = vtkSSAODisturbance()) const;

private:
  int Width;
  int Height;
  vtkSSAOProjection Projection;
  std::vector<glm::vec4> Solids; // two for each texel
  int SolidsWidth = 0;
  int SolidsHeight = 0;
  std::vector<glm::vec4> Geometry; // as in the texture: depth, packed normal, packed facet, 1
};

#endif
