// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The measures of error against values computed by hand.
 */

#include "UnitTestTruthCommon.h"

#include "vtkSSAOImageError.h"

#include <cstdlib>

using namespace TruthTest;

//------------------------------------------------------------------------------
int UnitTestTruthImageError(int, char*[])
{
  const int width = 40;
  const int height = 30;
  const std::size_t pixels = width * height;
  std::vector<float> truth(pixels), image(pixels);
  std::vector<unsigned char> mask(pixels, 1);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    truth[i] = 0.25f + 0.5f * static_cast<float>((7 * i) % 64) / 64.0f;
    image[i] = truth[i];
  }

  vtkSSAOImageError error;
  error.Compare(image, truth, mask, width, height);
  bool good = CheckNear("equal: RMSE", 0.0, error.GetRootMeanSquare(), 0.0);
  good &= CheckNear("equal: bias", 0.0, error.GetBias(), 0.0);
  good &= CheckNear("equal: 99th percentile", 0.0, error.GetPercentile99(), 0.0);
  good &= CheckNear("equal: maximum", 0.0, error.GetMaximum(), 0.0);
  good &= CheckNear("equal: similarity", 1.0, error.GetStructuralSimilarity(), 1e-12);
  good &= CheckNear("equal: pixels", 1200.0, static_cast<double>(error.GetNumberOfPixels()), 0.0);

  // 1200 pixels: 600 are 0.125 too dark, and of the others 12 are 0.25 too light. The 99th
  // percentile is number 1188 of 1200 in rising order, which is 0.125; with 13 it is 0.25.
  for (std::size_t i = 0; i < pixels; ++i)
  {
    image[i] = truth[i] + (i < 600 ? -0.125f : (i < 612 ? 0.25f : 0.0f));
  }
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear(
    "RMSE", std::sqrt((600.0 / 64.0 + 12.0 / 16.0) / 1200.0), error.GetRootMeanSquare(), 1e-7);
  good &= CheckNear("bias", (-600.0 / 8.0 + 12.0 / 4.0) / 1200.0, error.GetBias(), 1e-7);
  good &= CheckNear("99th percentile of 12", 0.125, error.GetPercentile99(), 1e-7);
  good &= CheckNear("maximum", 0.25, error.GetMaximum(), 1e-7);
  image[612] = truth[612] + 0.25f;
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear("99th percentile of 13", 0.25, error.GetPercentile99(), 1e-7);

  // Pixels outside the mask count for nothing, not even for the similarity of their neighbours.
  image = truth;
  for (std::size_t i = 0; i < pixels; i += 3)
  {
    mask[i] = 0;
    image[i] = std::nanf("");
  }
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear("masked: RMSE", 0.0, error.GetRootMeanSquare(), 0.0);
  good &= CheckNear("masked: similarity", 1.0, error.GetStructuralSimilarity(), 1e-12);
  good &= CheckNear("masked: pixels", 800.0, static_cast<double>(error.GetNumberOfPixels()), 0.0);

  // A value that is not a number is an error of 1.
  image[1] = std::nanf("");
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear("bad pixels", 1.0, static_cast<double>(error.GetNumberOfBadPixels()), 0.0);
  good &= CheckNear("bad: RMSE", std::sqrt(1.0 / 800.0), error.GetRootMeanSquare(), 1e-12);

  // Constant images: SSIM is the luminance term (2 a b + c1) / (a^2 + b^2 + c1).
  mask.assign(pixels, 1);
  truth.assign(pixels, 0.75f);
  image.assign(pixels, 0.5f);
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear("constant: similarity", (0.75 + 1e-4) / (0.5625 + 0.25 + 1e-4),
    error.GetStructuralSimilarity(), 1e-9);

  // An image with the contrast turned round is dissimilar.
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const float wave = 0.3f * std::sin(0.9f * static_cast<float>(i % width));
    truth[i] = 0.5f + wave;
    image[i] = 0.5f - wave;
  }
  error.Compare(image, truth, mask, width, height);
  good &= CheckTrue("turned round: similarity " + std::to_string(error.GetStructuralSimilarity()) +
      " is below -0.8",
    error.GetStructuralSimilarity() < -0.8);

  mask.assign(pixels, 0);
  error.Compare(image, truth, mask, width, height);
  good &= CheckNear("nothing: pixels", 0.0, static_cast<double>(error.GetNumberOfPixels()), 0.0);
  good &= CheckNear("nothing: similarity", 1.0, error.GetStructuralSimilarity(), 0.0);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
