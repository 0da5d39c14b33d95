// SPDX-License-Identifier: BSD-3-Clause

// Denoiser SeparableGaussian: the weights of its source's blur, across and then down, of pixels
// that are alike; smooth where the surface is, sharp at its edges.

#include "vtkSSAOTestEstimators.h"

namespace
{
//------------------------------------------------------------------------------
struct Surface
{
  vtkSSAOTestImage Depth;
  vtkSSAOTestImage Normal[3];

  bool Alike(int x, int y, int i, int j, double radius) const
  {
    double cosine = 0.0;
    for (const vtkSSAOTestImage& component : this->Normal)
    {
      cosine += component.At(x, y) * component.At(i, j);
    }
    return this->Depth.At(i, j) > 0.0F && cosine > 0.75 &&
      std::abs(this->Depth.At(i, j) - this->Depth.At(x, y)) < 0.5 * radius;
  }
};

//------------------------------------------------------------------------------
vtkSSAOTestImage Blurred(
  const vtkSSAOTestImage& image, const Surface& surface, bool across, int size, double radius)
{
  vtkSSAOTestImage result = image;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      double sum = 0.0;
      double weights = 0.0;
      for (int k = -size; k <= size; ++k)
      {
        const int i = across ? x + k : x;
        const int j = across ? y : y + k;
        if (i >= 0 && j >= 0 && i < image.Width && j < image.Height &&
          (k == 0 || surface.Alike(x, y, i, j, radius)))
        {
          const double weight = std::exp(-2.0 * k * k / (size * size));
          sum += weight * image.At(i, j);
          weights += weight;
        }
      }
      result.At(x, y) = surface.Depth.At(x, y) > 0.0F ? static_cast<float>(sum / weights) : 1.0F;
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
int TestDenoiserSeparableGaussian(int, char*[])
{
  vtkSSAOTestMonitor test;
  {
    vtkSSAOTestView view(test, 120, 90);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, false);
    view.Pass->SetRadius(0.5);
    view.Pass->SetEstimatorToHemisphere(); // its pixels weigh the same, unlike those of slices
    for (int size : { 2, 4, 5 })
    {
      view.Pass->SetNoiseSize(size);
      view.Pass->SetDenoiserToNone();
      const vtkSSAOTestImage raw = view.Visibility();
      Surface surface;
      surface.Depth = view.Depth();
      for (int i = 0; i < 3; ++i)
      {
        surface.Normal[i] = view.Normal(i);
      }
      view.Pass->SetDenoiserToSeparableGaussian();
      const vtkSSAOTestImage wanted =
        Blurred(Blurred(raw, surface, true, size, 0.5), surface, false, size, 0.5);
      const vtkSSAOTestImage got = view.Visibility();
      int differing = 0;
      for (std::size_t i = 0; i < got.Values.size(); ++i)
      {
        differing += std::abs(got.Values[i] - wanted.Values[i]) <= 1.0e-5F ? 0 : 1;
      }
      // Normals that are 41 degrees apart to within rounding.
      test.ExpectAtMost(differing, 4,
        "Pixels that differ from the Gaussian of deviation " + std::to_string(0.5 * size));
    }
  }
  {
    // Along the crease of a corner V changes by noise alone.
    vtkSSAOTestView view(test, 160, 120);
    vtkSSAOAddCorner(view);
    vtkSSAOLookAtCorner(view, true);
    view.Pass->SetRadius(2.0);
    view.Pass->SetEstimatorToHemisphere(); // noisy enough
    view.Pass->SetDenoiserToNone();
    const auto row = [](int x, int y) { return y == 54 && x >= 30 && x < 130; };
    const double noisy = vtkSSAOMeasure(view.Visibility(), row).Deviation;
    view.Pass->SetDenoiserToSeparableGaussian();
    const double smooth = vtkSSAOMeasure(view.Visibility(), row).Deviation;
    test.ExpectAtLeast(noisy, 0.02, "Deviation of V along a crease without a denoiser");
    test.ExpectAtMost(smooth / noisy, 0.1, "Share of it that is left");
  }
  return test.GetResult();
}
