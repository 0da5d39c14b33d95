// SPDX-License-Identifier: BSD-3-Clause

// Denoisers None, Box and BoxCentered: the means that their sources take, at every pixel, also
// where they leak over edges and reach over the picture's border.

#include "vtkSSAOTestEstimators.h"

namespace
{
//------------------------------------------------------------------------------
float At(const vtkSSAOTestImage& image, int x, int y)
{
  return image.At(
    std::min(std::max(x, 0), image.Width - 1), std::min(std::max(y, 0), image.Height - 1));
}

//------------------------------------------------------------------------------
// Linear filtering at a distance from a pixel's centre.
double Filtered(const vtkSSAOTestImage& image, int x, int y, double right, double up)
{
  const int i = static_cast<int>(std::floor(right));
  const int j = static_cast<int>(std::floor(up));
  const double s = right - i;
  const double t = up - j;
  return (1.0 - t) * ((1.0 - s) * At(image, x + i, y + j) + s * At(image, x + i + 1, y + j)) +
    t * ((1.0 - s) * At(image, x + i, y + j + 1) + s * At(image, x + i + 1, y + j + 1));
}
}

//------------------------------------------------------------------------------
int TestDenoiserBoxes(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 120, 90);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(0.5);
  view.Pass->SetEstimatorToHemisphere(); // its pixels weigh the same, unlike those of slices
  for (int size : { 1, 3, 4, 7 })
  {
    view.Pass->SetNoiseSize(size);
    view.Pass->SetDenoiserToNone();
    const vtkSSAOTestImage raw = view.Visibility();
    const vtkSSAOTestImage surfaces = view.Surfaces();
    for (int denoiser : { 1, 2 })
    {
      const double first = denoiser == 1 ? -(size / 2) : -0.5 * (size - 1);
      vtkSSAOTestImage wanted = raw;
      for (int y = 0; y < raw.Height; ++y)
      {
        for (int x = 0; x < raw.Width && size > 1; ++x)
        {
          double sum = 0.0;
          for (int i = 0; i < size * size; ++i)
          {
            sum += Filtered(raw, x, y, first + i % size, first + i / size);
          }
          wanted.At(x, y) =
            surfaces.At(x, y) > 0.0F ? static_cast<float>(sum / (size * size)) : 1.0F;
        }
      }
      view.Pass->SetDenoiser(denoiser);
      test.ExpectAtMost(vtkSSAOLargestDifference(view.Visibility(), wanted), 2.0e-6,
        (denoiser == 1 ? "Box " : "BoxCentered ") + std::to_string(size) + "x" +
          std::to_string(size) + ", largest difference from the mean");
    }
  }
  return test.GetResult();
}
