// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOImageError.h"

#include "vtkSSAOTruthImage.h"

#include "vtkObject.h"

#include <algorithm>
#include <cmath>

namespace
{
const int WindowRadius = 5;

//------------------------------------------------------------------------------
// Sums each pixel's neighbourhood, weighted by a Gaussian of deviation 1.5 that is cut off after
// WindowRadius: along x into a buffer, then along y.
std::vector<double> Smooth(const std::vector<double>& values, int width, int height)
{
  double weights[2 * WindowRadius + 1];
  for (int i = -WindowRadius; i <= WindowRadius; ++i)
  {
    weights[i + WindowRadius] = std::exp(-i * i / (2.0 * 1.5 * 1.5));
  }
  std::vector<double> rows(values.size(), 0.0);
  std::vector<double> result(values.size(), 0.0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      for (int i = std::max(-WindowRadius, -x); i <= std::min(WindowRadius, width - 1 - x); ++i)
      {
        rows[pixel] += weights[i + WindowRadius] * values[pixel + i];
      }
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int i = std::max(-WindowRadius, -y); i <= std::min(WindowRadius, height - 1 - y); ++i)
    {
      const double weight = weights[i + WindowRadius];
      const double* source = rows.data() + static_cast<std::size_t>(y + i) * width;
      double* target = result.data() + static_cast<std::size_t>(y) * width;
      for (int x = 0; x < width; ++x)
      {
        target[x] += weight * source[x];
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
// Smooth(first * second * mask)
std::vector<double> SmoothProduct(const std::vector<double>& first,
  const std::vector<double>& second, const std::vector<double>& mask, int width, int height)
{
  std::vector<double> product(mask.size());
  for (std::size_t i = 0; i < product.size(); ++i)
  {
    product[i] = first[i] * second[i] * mask[i];
  }
  return Smooth(product, width, height);
}

//------------------------------------------------------------------------------
double GetSimilarity(const std::vector<double>& first, const std::vector<double>& second,
  const std::vector<double>& mask, int width, int height)
{
  const double c1 = 0.01 * 0.01;
  const double c2 = 0.03 * 0.03;
  const std::vector<double> one(mask.size(), 1.0);
  const std::vector<double> weight = Smooth(mask, width, height);
  const std::vector<double> mean1 = SmoothProduct(first, one, mask, width, height);
  const std::vector<double> mean2 = SmoothProduct(second, one, mask, width, height);
  const std::vector<double> square1 = SmoothProduct(first, first, mask, width, height);
  const std::vector<double> square2 = SmoothProduct(second, second, mask, width, height);
  const std::vector<double> cross = SmoothProduct(first, second, mask, width, height);
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (mask[i] == 0.0)
    {
      continue;
    }
    const double m1 = mean1[i] / weight[i];
    const double m2 = mean2[i] / weight[i];
    const double variance1 = std::max(0.0, square1[i] / weight[i] - m1 * m1);
    const double variance2 = std::max(0.0, square2[i] / weight[i] - m2 * m2);
    const double covariance = cross[i] / weight[i] - m1 * m2;
    sum += (2.0 * m1 * m2 + c1) * (2.0 * covariance + c2) /
      ((m1 * m1 + m2 * m2 + c1) * (variance1 + variance2 + c2));
    count += 1.0;
  }
  return sum / count;
}
}

//------------------------------------------------------------------------------
void vtkSSAOImageError::Compare(
  const std::vector<float>& visibility, const vtkSSAOTruthImage& truth)
{
  this->Compare(visibility, truth.Visibility, truth.Hit, truth.Width, truth.Height);
}

//------------------------------------------------------------------------------
void vtkSSAOImageError::Compare(const std::vector<float>& visibility,
  const std::vector<float>& truth, const std::vector<unsigned char>& mask, int width, int height)
{
  *this = vtkSSAOImageError();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (visibility.size() != pixels || truth.size() != pixels || mask.size() != pixels)
  {
    vtkGenericWarningMacro("vtkSSAOImageError: the images differ in size");
    return;
  }

  std::vector<double> errors;
  std::vector<double> first(pixels, 0.0);
  std::vector<double> second(pixels, 0.0);
  std::vector<double> weight(pixels, 0.0);
  double sum = 0.0;
  double sumOfSquares = 0.0;
  for (std::size_t i = 0; i < pixels; ++i)
  {
    if (!mask[i])
    {
      continue;
    }
    double value = visibility[i];
    if (!std::isfinite(value) || !std::isfinite(truth[i]))
    {
      ++this->NumberOfBadPixels;
      value = truth[i] < 0.5f ? truth[i] + 1.0 : truth[i] - 1.0;
    }
    const double difference = value - truth[i];
    errors.push_back(std::abs(difference));
    sum += difference;
    sumOfSquares += difference * difference;
    first[i] = value;
    second[i] = truth[i];
    weight[i] = 1.0;
  }
  this->NumberOfPixels = errors.size();
  if (errors.empty())
  {
    return;
  }
  const double count = static_cast<double>(errors.size());
  this->RootMeanSquare = std::sqrt(sumOfSquares / count);
  this->Bias = sum / count;
  this->Maximum = *std::max_element(errors.begin(), errors.end());
  const std::size_t rank = static_cast<std::size_t>(std::ceil(0.99 * count)) - 1;
  std::nth_element(
    errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(rank), errors.end());
  this->Percentile99 = errors[rank];
  this->StructuralSimilarity = GetSimilarity(first, second, weight, width, height);
}
