// SPDX-License-Identifier: BSD-3-Clause

// The colour of the background, a gradient, a texture or its depth do not change the visibility of
// any surface by a single bit, and the background itself has visibility 1.

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkTexture.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// A checkerboard.
vtkSmartPointer<vtkTexture> NewTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 64 * 3; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = (i / 3 + i / 24) % 2 ? 250 : 10;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

//------------------------------------------------------------------------------
// The first of them is what the others are compared with.
std::vector<std::pair<std::string, std::function<void(vtkRenderer*)>>> Backgrounds()
{
  return {
    { "black",
      [](vtkRenderer* renderer)
      {
        renderer->SetBackground(0, 0, 0);
        renderer->SetBackgroundAlpha(0.0);
        renderer->TexturedBackgroundOff();
        renderer->GradientBackgroundOff();
      } },
    { "white", [](vtkRenderer* renderer) { renderer->SetBackground(1, 1, 1); } },
    { "gradient",
      [](vtkRenderer* renderer)
      {
        renderer->SetBackground2(1, 0.2, 0);
        renderer->GradientBackgroundOn();
      } },
    { "opaque", [](vtkRenderer* renderer) { renderer->SetBackgroundAlpha(1.0); } },
    { "texture",
      [](vtkRenderer* renderer)
      {
        renderer->SetBackgroundTexture(NewTexture());
        renderer->TexturedBackgroundOn();
      } },
  };
}
}

//------------------------------------------------------------------------------
int TestStableBackground(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(test, "Background black, white, gradient, texture",
    "largest difference of V in 1/255", vtkSSAOStability::AtMost, 0.0);
  vtkSSAOTestView view(test, 150, 100);
  vtkSSAOAddStillLife(view);
  view.Pass->SetRadius(0.5);
  for (bool parallel : { false, true })
  {
    vtkSSAOLookAtStillLife(view, parallel);
    // Under EdgeAware, as the presets have it, and under others, which average over the background.
    for (int denoiser : { 4, 0, 1 })
    {
      std::vector<vtkSSAOTestImage> onBlack;
      vtkSSAOTestImage ofVTK;
      for (const auto& background : Backgrounds())
      {
        background.second(view.Renderer);
        const std::string what = std::string(parallel ? "parallel" : "perspective") +
          ", denoiser " + std::to_string(denoiser) + ", " + background.first;
        for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
        {
          view.SetPreset(preset);
          view.Pass->SetDenoiser(denoiser);
          const vtkSSAOTestImage v = view.Visibility();
          if (static_cast<int>(onBlack.size()) == preset)
          {
            onBlack.push_back(v);
            test.ExpectAtMost(view.MeasureSurfaces(v).Minimum, 0.8, what + ": smallest V");
          }
          const vtkSSAOTestImage surfaces = view.Surfaces();
          const vtkSSAOStatistics open =
            vtkSSAOMeasure(v, [&](int x, int y) { return surfaces.At(x, y) == 0.0F; });
          test.ExpectAtLeast(open.Count, 100, what + ": pixels of the background");
          test.ExpectEqual(open.Minimum, 1.0, what + ": smallest V of the background");
          row.Ours(preset, 255.0 * vtkSSAOLargestDifference(v, onBlack[preset]), what);
        }
        if (denoiser == 4)
        {
          // VTK's pass shows the background's own colour there.
          vtkSSAOTestImage v = view.VisibilityOfVTK(0.5);
          const vtkSSAOTestImage surfaces = view.Surfaces();
          for (std::size_t i = 0; i < v.Values.size(); ++i)
          {
            v.Values[i] = surfaces.Values[i] > 0.0F ? v.Values[i] : 1.0F;
          }
          ofVTK = ofVTK.Width ? ofVTK : v;
          row.VTK(255.0 * vtkSSAOLargestDifference(v, ofVTK), what);
        }
      }
    }
  }
  return test.GetResult();
}
