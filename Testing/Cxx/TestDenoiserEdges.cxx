// SPDX-License-Identifier: BSD-3-Clause

// The denoisers at an edge: a table, dark under a ball, before a ground that is far below. The
// plain means carry the one's V over to the other, those that know of edges do not.

#include "vtkSSAOTestEstimators.h"

//------------------------------------------------------------------------------
int TestDenoiserEdges(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (bool parallel : { false, true })
  {
    vtkSSAOTestView view(test, 160, 120);
    view.Add(vtkSSAOQuad({ -90, -20, 90 }, { 180, 0, 0 }, { 0, 0, -180 }));
    view.Add(vtkSSAOQuad({ -2, 0, 0.3 }, { 4, 0, 0 }, { 0, 0, -2 }));
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0, 0.5, 0);
    ball->SetRadius(0.5);
    ball->SetThetaResolution(64);
    ball->SetPhiResolution(48);
    view.Add(ball);
    parallel ? view.LookParallel({ 0, 8, 8 }, { 0, 0, 0 }, { 0, 1, 0 }, 1.2)
             : view.Look({ 0, 8, 8 }, { 0, 0, 0 }, { 0, 1, 0 }, 12.0);
    view.Pass->SetRadius(1.0);
    view.Pass->SetNoiseSize(4);
    view.Visibility();
    const vtkSSAOTestImage depth = view.Depth();
    // Pixels of the ground below the ball, within two pixels of the table.
    const auto beside = [&](int x, int y) {
      return std::abs(x - 80) < 8 && y < 60 && depth.At(x, y) > 20.0F && depth.At(x, y + 2) < 20.0F;
    };
    view.Pass->SetDenoiserToNone();
    const vtkSSAOStatistics raw = vtkSSAOMeasure(view.Visibility(), beside);
    const std::string projection = parallel ? ", parallel" : ", perspective";
    test.ExpectAtLeast(raw.Count, 20, "Pixels of the ground beside the table" + projection);
    test.ExpectAtLeast(raw.Minimum, 0.99, "Their least V" + projection);
    const char* names[] = { "None", "Box", "BoxCentered", "SeparableGaussian", "EdgeAware" };
    for (int denoiser : { 1, 2, 3, 4 })
    {
      view.Pass->SetDenoiser(denoiser);
      const double least = vtkSSAOMeasure(view.Visibility(), beside).Minimum;
      const std::string what =
        std::string("Least V of the ground with ") + names[denoiser] + projection;
      denoiser <= 2 ? test.ExpectAtMost(least, 0.95, what) : test.ExpectAtLeast(least, 0.99, what);
    }
  }
  return test.GetResult();
}
