// SPDX-License-Identifier: BSD-3-Clause

// The tile of rotations leaves no pattern: on smooth shade the denoisers take away what repeats
// with the tile's period, and keep the shade.

#include "vtkNew.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace
{
//------------------------------------------------------------------------------
// Root mean square, over all rows (or columns), of the amplitudes with which the image oscillates
// at the period of the tile and its harmonics within a rectangle. The mean and the slope of the
// rectangle's rows are no part of them: second differences are measured.
double PatternAmplitude(const vtkSSAOTestImage& image, int left, int bottom, int size, int period)
{
  const double pi = std::acos(-1.0);
  double power = 0.0;
  for (bool rows : { true, false })
  {
    for (int line = 0; line < size; ++line)
    {
      const auto at = [&](int i)
      { return rows ? image.At(left + i, bottom + line) : image.At(left + line, bottom + i); };
      for (int harmonic = 1; harmonic <= period / 2; ++harmonic)
      {
        std::complex<double> sum = 0.0;
        for (int i = 1; i + 1 < size - 1; ++i)
        {
          const double second = at(i - 1) - 2.0 * at(i) + at(i + 1);
          sum += second * std::polar(1.0, 2.0 * pi * harmonic * i / period);
        }
        power += std::norm(sum / double(size - 2));
      }
    }
  }
  return std::sqrt(power / (2.0 * size));
}
}

//------------------------------------------------------------------------------
int TestRotationTile(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (bool corner : { true, false })
  {
    vtkSSAOTestView view(test, 160, 160);
    if (corner)
    {
      vtkSSAOAddCorner(view);
      vtkSSAOLookAtCorner(view, true);
    }
    else
    {
      // A large sphere sunk into the floor: smooth shade in two directions.
      vtkSSAOAddFloor(view);
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(3.0);
      sphere->SetCenter(0, 2.0, -6.0);
      sphere->SetThetaResolution(200);
      sphere->SetPhiResolution(100);
      view.Add(sphere);
      view.LookParallel({ 0, 20, 8 }, { 0, 0, -3 }, { 0, 1, 0 }, 3.0);
    }
    view.Pass->SetRadius(2.5);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const std::string what = std::string(corner ? "Corner, " : "Sphere on floor, ") +
        vtkSSAOTestView::GetPresetName(preset) + ": ";
      // 80 x 80 pixels of the floor, in the shade.
      const int left = 40;
      const int bottom = 0;
      const int size = corner ? 72 : 80;
      const int period = view.Pass->GetNoiseSize();
      view.Pass->SetDenoiserToNone();
      const vtkSSAOTestImage noisy = view.Visibility();
      const double before = PatternAmplitude(noisy, left, bottom, size, period);
      // About half of the smallest, so that there is something to take away.
      test.ExpectAtLeast(before, 0.004, what + "pattern without a denoiser");
      const int directions = view.Pass->GetDirections();
      const int layers = view.Pass->GetLayerDownsampling();
      for (int denoiser : { 1, 4 })
      {
        // Where every pixel is estimated, coarser layers would meet each rotation of the tile at
        // one place of theirs.
        view.Pass->SetLayerDownsampling(denoiser == 1 ? 1 : layers);
        // Pixels are averaged as their slices are, by weight, so the mean is that of many slices.
        view.Pass->SetDenoiserToNone();
        view.Pass->SetDirections(64);
        const vtkSSAOTestImage many = view.Visibility();
        view.Pass->SetDirections(directions);
        view.Pass->SetDenoiser(denoiser);
        const std::string name = what + (denoiser == 1 ? "Box" : "EdgeAware");
        const vtkSSAOTestImage v = view.Visibility();
        const double after = PatternAmplitude(
          v, left, bottom, size, denoiser == 1 ? period : period * view.Pass->GetDownsampling());
        // The mean over a tile takes a pattern away but for what the shade changes within it. The
        // interpolation between estimated pixels leaves its kinks, with their period: 1.5e-4 of V,
        // which is .02 of the smallest pattern, that of Accurate.
        test.ExpectAtMost(after / before, denoiser == 1 ? 0.02 : 0.025,
          name + ", share of the pattern that is left");
        const auto inside = [=](int x, int y)
        { return x >= left && x < left + size && y >= bottom && y < bottom + size; };
        // Box with an even tile is half a pixel off: .5 / 72 of the difference of V between the
        // ends of the rectangle, up to .45: .0031. EdgeAware takes pixels of the border for those
        // beyond it and weighs by certainty: .0019.
        test.ExpectNear(vtkSSAOMeasure(v, inside).Mean, vtkSSAOMeasure(many, inside).Mean, 0.0035,
          name + ", mean V");
        if (corner)
        {
          // Along the crease nothing changes but the rotation: nothing must remain of it. Farther
          // from the sides of the picture than the radius, 50 pixels.
          double deviation = 0.0;
          for (int row = 4; row < 72; ++row)
          {
            deviation = std::max(deviation,
              vtkSSAOMeasure(v, [=](int x, int y) { return y == row && x >= 52 && x < 108; })
                .Deviation);
          }
          test.ExpectAtMost(deviation, 1.0e-4, name + ", deviation of V along the crease");
        }
      }
    }
  }
  return test.GetResult();
}
