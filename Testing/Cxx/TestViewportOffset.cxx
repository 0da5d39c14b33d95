// SPDX-License-Identifier: BSD-3-Clause

// A renderer whose viewport does not start at (0, 0) shows the same as one that does, bit by bit,
// and leaves the rest of the window alone.

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <cstring>

namespace
{
//------------------------------------------------------------------------------
// Part of a picture.
vtkSmartPointer<vtkImageData> Part(
  vtkImageData* picture, int left, int bottom, int width, int height)
{
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->SetDimensions(width, height, 1);
  part->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    std::memcpy(part->GetScalarPointer(0, y, 0), picture->GetScalarPointer(left, bottom + y, 0),
      static_cast<std::size_t>(3) * width);
  }
  return part;
}
}

//------------------------------------------------------------------------------
int TestViewportOffset(int, char*[])
{
  constexpr int Width = 120;
  constexpr int Height = 80;
  vtkSSAOTestMonitor test;

  for (int samples : { 0, 4 })
  {
    for (bool parallel : { false, true })
    {
      vtkSSAOTestView alone(test, Width, Height, samples);
      vtkSSAOAddStillLife(alone);
      vtkSSAOLookAtStillLife(alone, parallel);
      alone.Pass->SetRadius(0.5);
      const vtkSSAOTestImage aloneV = alone.Visibility();
      vtkSmartPointer<vtkImageData> alonePicture = alone.Picture();

      // Four of them in a window of twice the size; odd numbers of the rotation tile apart.
      vtkSSAOTestView view(test, 2 * Width + 3, 2 * Height + 5, samples);
      vtkSSAOAddStillLife(view);
      vtkSSAOLookAtStillLife(view, parallel);
      view.Pass->SetRadius(0.5);
      const double windowWidth = 2 * Width + 3;
      const double windowHeight = 2 * Height + 5;
      vtkNew<vtkRenderer> other;
      other->SetBackground(0.1, 0.2, 0.3);
      other->SetViewport(0, 0, 1, 1);
      const int places[][2] = { { 0, 0 }, { Width + 3, 0 }, { 0, Height + 5 },
        { Width + 3, Height + 5 }, { 61, 43 } };
      for (const auto& place : places)
      {
        view.Renderer->SetViewport(place[0] / windowWidth, place[1] / windowHeight,
          (place[0] + Width) / windowWidth, (place[1] + Height) / windowHeight);
        const std::string what = std::string(parallel ? "Parallel, " : "Perspective, ") +
          std::to_string(samples) + " samples, viewport at " + std::to_string(place[0]) + ", " +
          std::to_string(place[1]) + ": ";
        const vtkSSAOTestImage v = view.Visibility();
        test.ExpectEqual(v.Width, Width, what + "width");
        test.ExpectEqual(v.Height, Height, what + "height");
        // The position of a pixel is a float times its number plus an offset; another offset rounds
        // the last bit otherwise, and a sample may fall to the other side of the surface.
        test.ExpectAtMost(vtkSSAOMeanDifference(v, aloneV), 2.0e-5, what + "mean difference of V");
        vtkSmartPointer<vtkImageData> picture = view.Picture();
        const vtkSSAODifference difference = vtkSSAOImageCompare::Difference(
          Part(picture, place[0], place[1], Width, Height), alonePicture, 0);
        test.ExpectAtMost(difference.Largest, 1, what + "largest difference of the picture");
        test.ExpectAtMost(difference.Fraction, 0.002, what + "share of pixels that differ");
      }
    }
  }
  return test.GetResult();
}
