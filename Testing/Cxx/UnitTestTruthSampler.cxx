// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The directions of the ray-traced reference: well spread, independent, the same everywhere.
 */

#include "UnitTestTruthCommon.h"

#include "vtkSSAOTruthSampler.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace
{
using namespace TruthTest;

//------------------------------------------------------------------------------
// Every elementary rectangle of area 1 / 64 must hold one of the first 64 points, for any pixel.
bool TestStratification()
{
  bool good = true;
  for (std::uint32_t pixel = 0; pixel < 50; ++pixel)
  {
    const vtkSSAOTruthSampler sampler(pixel, 7 * pixel, pixel % 4);
    for (int bits = 0; bits <= 6; ++bits)
    {
      const int columns = 1 << bits;
      const int rows = 64 / columns;
      std::vector<int> counts(64, 0);
      for (std::uint32_t i = 0; i < 64; ++i)
      {
        double u[2];
        sampler.GetPoint(i, u);
        ++counts[static_cast<int>(u[0] * columns) + columns * static_cast<int>(u[1] * rows)];
      }
      for (int count : counts)
      {
        good &= count == 1;
      }
    }
  }
  return CheckTrue("64 points fill all elementary rectangles of 1 / 64", good);
}

//------------------------------------------------------------------------------
// Directions are unit vectors above the plane with the mean that their density gives.
bool TestDirections()
{
  double cosineMean[3] = { 0.0, 0.0, 0.0 };
  double uniformMean[3] = { 0.0, 0.0, 0.0 };
  double worstLength = 0.0;
  const std::uint32_t count = 4096;
  const vtkSSAOTruthSampler sampler(3, 5, 0);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    double u[2], w[3];
    sampler.GetPoint(i, u);
    vtkSSAOTruthSampler::GetCosineDirection(u, w);
    worstLength = std::max(worstLength, std::abs(std::hypot(w[0], w[1], w[2]) - 1.0));
    for (int axis = 0; axis < 3; ++axis)
    {
      cosineMean[axis] += w[axis] / count;
    }
    vtkSSAOTruthSampler::GetUniformDirection(u, w);
    worstLength = std::max(worstLength, std::abs(std::hypot(w[0], w[1], w[2]) - 1.0));
    for (int axis = 0; axis < 3; ++axis)
    {
      uniformMean[axis] += w[axis] / count;
    }
  }
  bool good = CheckNear("length of a direction - 1", 0.0, worstLength, 1e-12);
  const double expectedCosine[3] = { 0.0, 0.0, 2.0 / 3.0 };
  const double expectedUniform[3] = { 0.0, 0.0, 0.5 };
  for (int axis = 0; axis < 3; ++axis)
  {
    good &= CheckNear("mean of cosine directions", expectedCosine[axis], cosineMean[axis], 1e-3);
    good &= CheckNear("mean of uniform directions", expectedUniform[axis], uniformMean[axis], 1e-3);
  }
  return good;
}

//------------------------------------------------------------------------------
// Replicates and neighbouring pixels must not repeat each other: means over many of them of the
// product of deviations vanish.
bool TestIndependence()
{
  const int count = 4000;
  double betweenReplicates = 0.0;
  double betweenPixels = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t x = static_cast<std::uint32_t>(i % 80);
    const std::uint32_t y = static_cast<std::uint32_t>(i / 80);
    double a[2], b[2], c[2];
    vtkSSAOTruthSampler(x, y, 0).GetPoint(0, a);
    vtkSSAOTruthSampler(x, y, 1).GetPoint(0, b);
    vtkSSAOTruthSampler(x + 1, y, 0).GetPoint(0, c);
    betweenReplicates += 12.0 * (a[0] - 0.5) * (b[0] - 0.5) / count;
    betweenPixels += 12.0 * (a[1] - 0.5) * (c[1] - 0.5) / count;
  }
  const double fourDeviations = 4.0 / std::sqrt(static_cast<double>(count));
  bool good = CheckNear("correlation of replicates", 0.0, betweenReplicates, fourDeviations);
  good &= CheckNear("correlation of neighbours", 0.0, betweenPixels, fourDeviations);
  return good;
}

//------------------------------------------------------------------------------
// Recorded values: any machine and library must give them to the last bit.
bool TestRecordedValues()
{
  double u[2], w[3];
  vtkSSAOTruthSampler(12, 34, 2).GetPoint(5, u);
  vtkSSAOTruthSampler::GetCosineDirection(u, w);
  std::cout.precision(17);
  bool good = CheckNear("recorded u", 0.67401666939258575, u[0], 0.0);
  good &= CheckNear("recorded v", 0.80393628822639585, u[1], 0.0);
  good &= CheckNear("recorded x", 0.27292997778647599, w[0], 0.0);
  good &= CheckNear("recorded y", -0.77429057634589582, w[1], 0.0);
  good &= CheckNear("recorded z", 0.57094949917432647, w[2], 0.0);
  return good;
}
}

//------------------------------------------------------------------------------
int UnitTestTruthSampler(int, char*[])
{
  bool good = TestStratification();
  good &= TestDirections();
  good &= TestIndependence();
  good &= TestRecordedValues();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
