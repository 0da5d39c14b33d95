// SPDX-License-Identifier: BSD-3-Clause

// Estimator Hemisphere: its twin, its properties, the banding without rotations and the halo
// without range check.

#include "vtkSSAOTestEstimators.h"

namespace
{
//------------------------------------------------------------------------------
// Mean of the columns of an image, row by row.
std::vector<double> MeanOfRows(const vtkSSAOTestImage& image)
{
  std::vector<double> means;
  for (int y = 0; y < image.Height; ++y)
  {
    means.push_back(vtkSSAOMeasure(image, [y](int, int row) { return row == y; }).Mean);
  }
  return means;
}

//------------------------------------------------------------------------------
// Root mean square of the difference of two profiles after the mean over 4 rows.
double BandsOf(const std::vector<double>& a, const std::vector<double>& b, int first, int last)
{
  double sum = 0.0;
  int tiles = 0;
  for (int y = first; y + 3 <= last; ++y)
  {
    double difference = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      difference += a[y + i] - b[y + i];
    }
    sum += difference * difference / 16.0;
    ++tiles;
  }
  return std::sqrt(sum / tiles);
}
}

//------------------------------------------------------------------------------
int TestEstimatorHemisphere(int, char*[])
{
  vtkSSAOTestMonitor test;
  const auto setUp = [](vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    pass->SetEstimatorToHemisphere();
    pass->SetKernelSize(64);
  };
  vtkSSAOTest::ExpectTwins(test, setUp, "Hemisphere");
  vtkSSAOTest::ExpectTwins(
    test,
    [&](vtkScreenSpaceAmbientOcclusionPass* pass)
    {
      setUp(pass);
      pass->RangeCheckOff();
      pass->SetBias(0.001);
      pass->SetNoiseSize(5);
    },
    "Hemisphere, range check off, little bias");
  vtkSSAOTest::ExpectProperties(test, setUp, 1.0, 0.005, 0.12, "Hemisphere");

  {
    // In a corner V changes with the distance from the crease only, and slowly. Without rotations
    // all pixels share their points, and V changes in steps, which no blur over a tile takes away.
    vtkSSAOTestView view(test, 128, 160);
    vtkSSAOAddCorner(view);
    vtkSSAOLookAtCorner(view, true);
    view.Pass->SetRadius(2.0);
    setUp(view.Pass);
    view.Pass->SetDenoiserToNone();
    view.Pass->SetKernelSize(16);
    view.Pass->SetNoiseSize(64); // a row has 64 rotations
    const std::vector<double> smooth = MeanOfRows(view.Visibility());
    view.Pass->SetNoiseSize(4);
    const double rotated = BandsOf(MeanOfRows(view.Visibility()), smooth, 30, 129);
    view.Pass->SetNoiseSize(1);
    const double banded = BandsOf(MeanOfRows(view.Visibility()), smooth, 30, 129);
    test.ExpectAtLeast(banded, 0.01, "Bands of a corner without rotations, root mean square");
    test.ExpectAtMost(rotated / banded, 0.25, "Share of them that is left with 4 x 4 rotations");
  }
  {
    // A ball far before a wall must not darken it.
    vtkSSAOTestView view(test, 160, 160);
    view.Add(vtkSSAOQuad({ -50, -50, -30 }, { 100, 0, 0 }, { 0, 100, 0 }));
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1.0);
    ball->SetThetaResolution(64);
    ball->SetPhiResolution(48);
    view.Add(ball);
    view.LookParallel({ 0, 0, 10 }, { 0, 0, 0 }, { 0, 1, 0 }, 2.0);
    view.Pass->SetRadius(1.0);
    setUp(view.Pass);
    const double with = vtkSSAOTest::MeanAbout(view, view.Visibility(), 1.1, 0.0, 0.0);
    view.Pass->RangeCheckOff();
    const double without = vtkSSAOTest::MeanAbout(view, view.Visibility(), 1.1, 0.0, 0.0);
    test.ExpectAtLeast(with, 0.99, "V of a wall beside a ball 30 radii before it");
    test.ExpectAtMost(without, 0.9, "The same without range check: a halo");
  }
  return test.GetResult();
}
