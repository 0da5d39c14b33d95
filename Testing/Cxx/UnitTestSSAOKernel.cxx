// SPDX-License-Identifier: BSD-3-Clause

// The sample points and the tile of rotations: where they lie, how they are spread, and that they
// are the same everywhere.

#include "vtkSSAOKernel.h"
#include "vtkSSAOTestMonitor.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
//------------------------------------------------------------------------------
void TestHemisphere(vtkSSAOTestMonitor& test)
{
  for (int size : { 1, 2, 16, 32, 64, 1024 })
  {
    const std::string what = "kernel of " + std::to_string(size) + ": ";
    const std::vector<glm::vec4> kernel = vtkSSAOHemisphereKernel(size);
    test.ExpectEqual(static_cast<double>(kernel.size()), size, what + "size");
    double lowest = 1.0;
    double longest = 0.0;
    double beyond = -1.0;
    double fourth = 0.0;
    for (int i = 0; i < size; ++i)
    {
      const double length = glm::length(glm::dvec3(kernel[i]));
      const double share = static_cast<double>(i) / size;
      lowest = std::min(lowest, static_cast<double>(kernel[i].z));
      longest = std::max(longest, length);
      beyond = std::max(beyond, length - (0.1 + 0.9 * share * share));
      fourth = std::max(fourth, std::abs(static_cast<double>(kernel[i].w)));
    }
    test.ExpectAtLeast(lowest, 0.0, what + "smallest z");
    test.Expect(lowest > 0.0, what + "no point lies in the surface");
    test.ExpectAtMost(longest, 1.0, what + "largest length");
    test.ExpectAtMost(beyond, 1.0e-6, what + "excess over the accelerating length");
    test.ExpectEqual(fourth, 0.0, what + "w");
  }

  // Spread about the normal: the mean of the directions has no side.
  const std::vector<glm::vec4> kernel = vtkSSAOHemisphereKernel(64);
  glm::dvec3 sum(0.0);
  double early = 0.0;
  double late = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    const glm::dvec3 point(kernel[i]);
    sum += glm::normalize(point) / 64.0;
    (i < 32 ? early : late) += glm::length(point) / 32.0;
  }
  test.ExpectAtMost(std::hypot(sum.x, sum.y), 0.05, "sideways mean of 64 directions");
  test.ExpectAtLeast(sum.z, 0.4, "mean of 64 directions along the normal");
  // Means of rnd (.1 + .9 s^2) over both halves: .5 (.1 + .9/12) and .5 (.1 + .9 7/12).
  test.ExpectNear(early, 0.0875, 0.02, "mean length of the first half");
  test.ExpectNear(late, 0.3125, 0.04, "mean length of the second half");
  bool grid[2][2] = { { false, false }, { false, false } };
  for (const glm::vec4& point : kernel)
  {
    grid[point.x > 0.0F][point.y > 0.0F] = true;
  }
  test.Expect(grid[0][0] && grid[0][1] && grid[1][0] && grid[1][1], "points in every quarter");
}

//------------------------------------------------------------------------------
// The recurrence written out: a wrong constant, or a standard library's own generator, shows here.
void TestExactValues(vtkSSAOTestMonitor& test)
{
  // g^5 = g + 1; steps 1/g, 1/g^2, 1/g^3, 1/g^4.
  const double g = 1.1673039782614187;
  test.ExpectNear(std::pow(g, 5.0), g + 1.0, 1.0e-12, "the constant of the recurrence");
  const std::vector<glm::vec4> kernel = vtkSSAOHemisphereKernel(32);
  for (int i : { 0, 1, 7, 31 })
  {
    double random[4];
    for (int k = 0; k < 4; ++k)
    {
      const double value = 0.5 + (i + 1) * std::pow(g, -(k + 1));
      random[k] = value - std::floor(value);
    }
    const glm::dvec3 direction =
      glm::normalize(glm::dvec3(2.0 * random[0] - 1.0, 2.0 * random[1] - 1.0, random[2]));
    const glm::dvec3 wanted = direction * random[3] * (0.1 + 0.9 * (i / 32.0) * (i / 32.0));
    test.ExpectAtMost(glm::length(glm::dvec3(kernel[i]) - wanted), 1.0e-6,
      "distance of point " + std::to_string(i) + " from its place");
  }
  test.Expect(vtkSSAOHemisphereKernel(32) == kernel, "the same points again");

  // Known digits, in float32: the same on every machine.
  test.ExpectNear(kernel[0].x, -0.00179012725, 1.0e-9, "x of point 0");
  test.ExpectNear(kernel[0].z, 0.000803771953, 1.0e-9, "z of point 0");
  test.ExpectNear(kernel[31].x, 0.405556232, 1.0e-7, "x of point 31");
  test.ExpectNear(kernel[31].z, 0.303294778, 1.0e-7, "z of point 31");
}

//------------------------------------------------------------------------------
void TestRotations(vtkSSAOTestMonitor& test)
{
  for (int size : { 1, 2, 3, 4, 5, 8, 64 })
  {
    const std::string what = "tile of " + std::to_string(size) + ": ";
    const std::vector<glm::vec2> tile = vtkSSAORotationTile(size);
    test.ExpectEqual(static_cast<double>(tile.size()), size * size, what + "size");
    std::vector<double> angles;
    double norm = 0.0;
    for (const glm::vec2& rotation : tile)
    {
      norm = std::max(norm, std::abs(glm::length(glm::dvec2(rotation)) - 1.0));
      const double angle = std::atan2(rotation.y, rotation.x) / (2.0 * std::acos(-1.0));
      angles.push_back(angle < -1.0e-6 ? angle + 1.0 : angle);
    }
    test.ExpectAtMost(norm, 1.0e-6, what + "excess of a length over 1");
    std::sort(angles.begin(), angles.end());
    double uneven = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      uneven = std::max(uneven, std::abs(angles[i] - static_cast<double>(i) / angles.size()));
    }
    test.ExpectAtMost(uneven, 1.0e-6, what + "distance of an angle from its even place, in turns");
    test.Expect(vtkSSAORotationTile(size) == tile, what + "the same again");
  }

  // Neighbours are far apart, over the tile's edges too.
  const std::vector<glm::vec2> tile = vtkSSAORotationTile(4);
  double smallest = 2.0;
  for (int y = 0; y < 4; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      const glm::vec2 here = tile[y * 4 + x];
      smallest = std::min(smallest,
        static_cast<double>(std::min(glm::length(here - tile[y * 4 + (x + 1) % 4]),
          glm::length(here - tile[(y + 1) % 4 * 4 + x]))));
    }
  }
  test.Expect(smallest > 0.35, "neighbouring rotations differ by more than 20 degrees");
}
}

//------------------------------------------------------------------------------
int UnitTestSSAOKernel(int, char*[])
{
  vtkSSAOTestMonitor test;
  TestHemisphere(test);
  TestExactValues(test);
  TestRotations(test);
  return test.GetResult();
}
