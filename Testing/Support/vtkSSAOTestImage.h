// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkSSAOTestImage.h
 * @brief   Images of one float per pixel, and what is measured in them.
 */

#ifndef vtkSSAOTestImage_h
#define vtkSSAOTestImage_h

#include <functional>
#include <vector>

/**
 * Row by row from below, x to the right.
 */
struct vtkSSAOTestImage
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values;

  vtkSSAOTestImage() = default;
  vtkSSAOTestImage(int width, int height, float value = 0.0F)
    : Width(width)
    , Height(height)
    , Values(static_cast<std::size_t>(width) * height, value)
  {
  }
  float& At(int x, int y) { return this->Values[static_cast<std::size_t>(y) * this->Width + x]; }
  float At(int x, int y) const
  {
    return this->Values[static_cast<std::size_t>(y) * this->Width + x];
  }
  bool operator==(const vtkSSAOTestImage& other) const
  {
    return this->Width == other.Width && this->Height == other.Height &&
      this->Values == other.Values;
  }
};

struct vtkSSAOStatistics
{
  int Count = 0;
  double Mean = 0.0;
  double Minimum = 0.0;
  double Maximum = 0.0;
  double Deviation = 0.0; ///< standard deviation
};

/**
 * Over the pixels for which a predicate holds.
 */
vtkSSAOStatistics vtkSSAOMeasure(
  const vtkSSAOTestImage& image, const std::function<bool(int x, int y)>& where);

/**
 * The largest and the mean difference of two images of one size; infinity for different sizes.
 */
double vtkSSAOLargestDifference(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b);
double vtkSSAOMeanDifference(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b);

/**
 * The share of the pixels that differ by more than a limit; 1 for different sizes.
 */
double vtkSSAOShareBeyond(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b, double limit);

#endif
