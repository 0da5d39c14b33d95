// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthImage
 * @brief   Ray-traced ambient visibility of one view, with what is needed to check and compare it.
 *
 * Every array holds Width x Height pixels, row by row from the bottom left, as vtkImageData and
 * glReadPixels do. Vectors take three consecutive values per pixel.
 */

#ifndef vtkSSAOTruthImage_h
#define vtkSSAOTruthImage_h

#include <cstddef>
#include <vector>

struct vtkSSAOTruthImage
{
  ///@{
  /// Size in pixels.
  int Width = 0;
  int Height = 0;
  ///@}

  /// Ambient visibility V in [0, 1]: 1 open, 0 closed; 1 where Hit is 0.
  std::vector<float> Visibility;

  /// Estimated standard deviation of Visibility, in [0, 1]; 0 where Hit is 0.
  std::vector<float> StandardError;

  /// 1 where the pixel centre shows an opaque lit surface, else 0.
  std::vector<unsigned char> Hit;

  /// Distance in front of the camera along its axis (-z in view coordinates), world units; 0 where
  /// Hit is 0.
  std::vector<float> Depth;

  ///@{
  /// Unit shading normal N and unit facet normal Ng in view coordinates, both on the side that
  /// faces the viewer; 0 where Hit is 0.
  std::vector<float> Normal;
  std::vector<float> GeometricNormal;
  ///@}

  /**
   * Makes an image of background: V = 1, everything else 0.
   */
  void Allocate(int width, int height)
  {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    this->Width = width;
    this->Height = height;
    this->Visibility.assign(pixels, 1.0f);
    this->StandardError.assign(pixels, 0.0f);
    this->Hit.assign(pixels, 0);
    this->Depth.assign(pixels, 0.0f);
    this->Normal.assign(3 * pixels, 0.0f);
    this->GeometricNormal.assign(3 * pixels, 0.0f);
  }
};

#endif
