// SPDX-License-Identifier: BSD-3-Clause

// The size of the picture does not matter: the error against the ray-traced truth is the same from
// 222 to 4218 pixels square, in an odd size, and in the middle of very wide and very high ones;
// pictures of one pixel are drawn.

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestTruth.h"
#include "vtkSSAOTestView.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double Radius = 0.5;
constexpr int Smallest = 222; // pixels
constexpr int Largest = 19;   // times the smallest; odd, see EachOf()
constexpr int NumberOfMethods = vtkSSAOTestView::NumberOfPresets + 1; // the last is VTK's pass
constexpr int MethodOfVTK = vtkSSAOTestView::NumberOfPresets;
using Errors = std::array<double, NumberOfMethods>;

//------------------------------------------------------------------------------
vtkSSAOTestImage Render(vtkSSAOTestView& view, int method)
{
  if (method == MethodOfVTK)
  {
    return view.VisibilityOfVTK(Radius);
  }
  view.SetPreset(method);
  return view.Visibility();
}

//------------------------------------------------------------------------------
// Every factor-th pixel of each row and column, the middle one: with an odd factor its centre is
// that of the pixel of a smaller picture.
vtkSSAOTestImage EachOf(const vtkSSAOTestImage& image, int factor)
{
  vtkSSAOTestImage part(image.Width / factor, image.Height / factor);
  for (int y = 0; y < part.Height; ++y)
  {
    for (int x = 0; x < part.Width; ++x)
    {
      part.At(x, y) = image.At(factor * x + factor / 2, factor * y + factor / 2);
    }
  }
  return part;
}

//------------------------------------------------------------------------------
void Note(vtkSSAOStability& row, const Errors& errors, const Errors& first, const std::string& what)
{
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    row.Ours(preset, std::abs(errors[preset] - first[preset]), what);
  }
  row.VTK(std::abs(errors[MethodOfVTK] - first[MethodOfVTK]), what);
}

//------------------------------------------------------------------------------
void CompareErrors(vtkSSAOTestMonitor& test)
{
  vtkSSAOStability row(test, "Pictures of 222 to 4218 pixels square",
    "difference of the RMSE against the truth from 222 pixels", vtkSSAOStability::AtMost, 0.01);
  vtkSSAOTestView view(test, Smallest, Smallest);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(Radius);
  const vtkSSAOTruthImage truth = vtkSSAOTest::TraceTruth(view, Radius, 64);
  Errors first{};
  for (int factor : { 1, 3, 9 })
  {
    view.Window->SetSize(Smallest * factor, Smallest * factor);
    Errors errors{};
    for (int method = 0; method < NumberOfMethods; ++method)
    {
      errors[method] = vtkSSAOTest::ErrorAgainst(truth, EachOf(Render(view, method), factor));
    }
    first = factor == 1 ? errors : first;
    Note(row, errors, first, std::to_string(Smallest * factor) + " pixels square");
  }
  // As large as is asked for, with the presets only, to save time.
  view.Window->SetSize(Smallest * Largest, Smallest * Largest);
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    row.Ours(preset,
      std::abs(
        vtkSSAOTest::ErrorAgainst(truth, EachOf(Render(view, preset), Largest)) - first[preset]),
      std::to_string(Smallest * Largest) + " pixels square");
  }

  const int odd = Smallest + 1;
  view.Window->SetSize(odd, odd);
  const vtkSSAOTruthImage oddTruth = vtkSSAOTest::TraceTruth(view, Radius, 64);
  Errors errors{};
  for (int method = 0; method < NumberOfMethods; ++method)
  {
    errors[method] = vtkSSAOTest::ErrorAgainst(oddTruth, Render(view, method));
  }
  Note(row, errors, first, std::to_string(odd) + " pixels square");
}

//------------------------------------------------------------------------------
// The middle of pictures fifty times as wide as high, and as high as wide: a square of the same
// scene and the same scale, whose error is known.
void CompareAspects(vtkSSAOTestMonitor& test)
{
  vtkSSAOStability row(test, "Pictures of 50:1 and 1:50",
    "difference of the RMSE against the truth from a square of that scale",
    vtkSSAOStability::AtMost, 0.01);
  constexpr int edge = 96; // the middle begins at a multiple of the noise tile
  constexpr double scale = 1.3;
  const std::vector<double> from = { 10.3, 17.3, 36.8 }; // before all of the floor
  const std::vector<double> at = { -0.1, 0.5, 0.0 };
  vtkSSAOTestView view(test, edge, edge);
  vtkSSAOAddStillLife(view);
  view.Pass->SetRadius(Radius);
  view.LookParallel(from, at, { 0, 1, 0 }, scale);
  const vtkSSAOTruthImage truth = vtkSSAOTest::TraceTruth(view, Radius, 256);
  Errors square{};
  for (int method = 0; method < NumberOfMethods; ++method)
  {
    square[method] = vtkSSAOTest::ErrorAgainst(truth, Render(view, method));
  }
  for (bool wide : { true, false })
  {
    const int width = wide ? 50 * edge : edge;
    const int height = wide ? edge : 50 * edge;
    view.Window->SetSize(width, height);
    view.Renderer->GetActiveCamera()->SetParallelScale(wide ? scale : 50 * scale);
    Errors errors{};
    for (int method = 0; method < NumberOfMethods; ++method)
    {
      const vtkSSAOTestImage whole = Render(view, method);
      vtkSSAOTestImage middle(edge, edge);
      for (int y = 0; y < edge; ++y)
      {
        for (int x = 0; x < edge; ++x)
        {
          middle.At(x, y) = whole.At((width - edge) / 2 + x, (height - edge) / 2 + y);
        }
      }
      errors[method] = vtkSSAOTest::ErrorAgainst(truth, middle);
    }
    Note(row, errors, square, std::to_string(width) + " x " + std::to_string(height) + " pixels");
  }
}

//------------------------------------------------------------------------------
void DrawUnusual(vtkSSAOTestMonitor& test)
{
  vtkSSAOStability row(test, "1 x 1, 1 x 50, 1000 x 20, 20 x 1000, 4096 x 4096 pixels",
    "pixels with V not from 0 to 1", vtkSSAOStability::AtMost, 0.0);
  vtkSSAOTestView view(test, 1, 1);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Pass->SetRadius(Radius);
  for (const auto& size :
    { std::pair<int, int>(1, 1), { 1, 50 }, { 1000, 20 }, { 20, 1000 }, { 4096, 4096 } })
  {
    if (size.first == 4096)
    {
      // Small in the middle of the large picture, to save time.
      view.LookParallel({ 1.2, 2.6, 4.6 }, { -0.1, 0.5, 0.0 }, { 0, 1, 0 }, 30.0);
    }
    view.Window->SetSize(size.first, size.second);
    const std::string what = std::to_string(size.first) + " x " + std::to_string(size.second);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.SetPreset(preset);
      const vtkSSAOTestImage v = view.Visibility();
      test.ExpectEqual(v.Width, size.first, what + ": width");
      test.ExpectEqual(v.Height, size.second, what + ": height");
      const vtkSSAOStatistics bad = vtkSSAOMeasure(
        v, [&](int x, int y) { return !(v.At(x, y) >= 0.0F && v.At(x, y) <= 1.0F); });
      row.Ours(preset, bad.Count, what);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStablePictureSizes(int, char*[])
{
  vtkSSAOTestMonitor test;
  CompareErrors(test);
  CompareAspects(test);
  DrawUnusual(test);
  return test.GetResult();
}
