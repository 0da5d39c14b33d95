// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOImageError
 * @brief   How far an image of ambient visibility is from the truth.
 *
 * All measures are over the pixels that show opaque geometry, with V in [0, 1]. A value that is not
 * finite counts as an error of 1.
 */

#ifndef vtkSSAOImageError_h
#define vtkSSAOImageError_h

#include <cstddef>
#include <vector>

struct vtkSSAOTruthImage;

class vtkSSAOImageError
{
public:
  /**
   * Compares two images of width x height values. Only pixels where `mask` is not 0 count.
   */
  void Compare(const std::vector<float>& visibility, const std::vector<float>& truth,
    const std::vector<unsigned char>& mask, int width, int height);

  /**
   * Compares an image with the truth, over the pixels where the truth shows a surface.
   */
  void Compare(const std::vector<float>& visibility, const vtkSSAOTruthImage& truth);

  /**
   * Number of pixels compared. All measures are 0, and the similarity 1, where it is 0.
   */
  std::size_t GetNumberOfPixels() const { return this->NumberOfPixels; }

  /**
   * Number of pixels whose value is infinite or not a number.
   */
  std::size_t GetNumberOfBadPixels() const { return this->NumberOfBadPixels; }

  /**
   * Square root of the mean of (V - truth)^2.
   */
  double GetRootMeanSquare() const { return this->RootMeanSquare; }

  /**
   * Mean of V - truth: above 0 too light, below 0 too dark.
   */
  double GetBias() const { return this->Bias; }

  /**
   * |V - truth| that 99 % of the pixels do not exceed (nearest rank).
   */
  double GetPercentile99() const { return this->Percentile99; }

  /**
   * Largest |V - truth|.
   */
  double GetMaximum() const { return this->Maximum; }

  /**
   * Mean structural similarity, 1 for equal images: Wang et al., "Image Quality Assessment: From
   * Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004, with their constants (a
   * Gaussian window of 11 x 11 pixels and deviation 1.5, K1 = 0.01, K2 = 0.03, L = 1). Windows are
   * centred at the pixels compared and weigh only pixels that are compared.
   */
  double GetStructuralSimilarity() const { return this->StructuralSimilarity; }

private:
  std::size_t NumberOfPixels = 0;
  std::size_t NumberOfBadPixels = 0;
  double RootMeanSquare = 0.0;
  double Bias = 0.0;
  double Percentile99 = 0.0;
  double Maximum = 0.0;
  double StructuralSimilarity = 1.0;
};

#endif
