// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTestImage.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
vtkSSAOStatistics vtkSSAOMeasure(
  const vtkSSAOTestImage& image, const std::function<bool(int x, int y)>& where)
{
  vtkSSAOStatistics result;
  result.Minimum = std::numeric_limits<double>::infinity();
  result.Maximum = -result.Minimum;
  double sum = 0.0;
  double squares = 0.0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      if (where(x, y))
      {
        const double value = image.At(x, y);
        ++result.Count;
        sum += value;
        squares += value * value;
        result.Minimum = std::min(result.Minimum, value);
        result.Maximum = std::max(result.Maximum, value);
      }
    }
  }
  if (result.Count)
  {
    result.Mean = sum / result.Count;
    result.Deviation = std::sqrt(std::max(squares / result.Count - result.Mean * result.Mean, 0.0));
  }
  return result;
}

//------------------------------------------------------------------------------
double vtkSSAOLargestDifference(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    largest = std::max(largest, std::abs(static_cast<double>(a.Values[i]) - b.Values[i]));
  }
  return largest;
}

//------------------------------------------------------------------------------
double vtkSSAOMeanDifference(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    sum += std::abs(static_cast<double>(a.Values[i]) - b.Values[i]);
  }
  return sum / a.Values.size();
}

//------------------------------------------------------------------------------
double vtkSSAOShareBeyond(const vtkSSAOTestImage& a, const vtkSSAOTestImage& b, double limit)
{
  if (a.Width != b.Width || a.Height != b.Height)
  {
    return 1.0;
  }
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    // NaN counts as well.
    beyond += std::abs(static_cast<double>(a.Values[i]) - b.Values[i]) <= limit ? 0 : 1;
  }
  return static_cast<double>(beyond) / a.Values.size();
}
