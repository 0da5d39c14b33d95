// SPDX-License-Identifier: BSD-3-Clause

// The sample points of the sphere estimators, the tile of random numbers, and the mirrors made of
// it.

#include "vtkSSAOKernel.h"
#include "vtkSSAOShaderFunctions.h"
#include "vtkSSAOTestMonitor.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
void TestSphere(vtkSSAOTestMonitor& test)
{
  for (int size : { 1, 2, 7, 32, 1024 })
  {
    const std::string what = "sphere of " + std::to_string(size) + ": ";
    const std::vector<glm::vec4> kernel = vtkSSAOSphereKernel(size);
    test.ExpectEqual(static_cast<double>(kernel.size()), size, what + "size");
    bool paired = true;
    bool growing = true;
    double longest = 0.0;
    for (int i = 0; i < size; ++i)
    {
      const double length = glm::length(glm::dvec3(kernel[i]));
      paired = paired && (i % 2 == 0 || kernel[i] == -kernel[i - 1]);
      growing = growing && length > longest - 1.0e-6;
      longest = std::max(longest, length);
    }
    test.Expect(paired, what + "every second point is the one before through the centre");
    test.Expect(growing, what + "lengths grow");
    test.ExpectNear(longest, 1.0, 1.0e-6, what + "largest length");
    test.ExpectAtLeast(glm::length(glm::dvec3(kernel[0])), 1.0 / 11.1, what + "smallest length");
  }
}

//------------------------------------------------------------------------------
void TestBallAndCube(vtkSSAOTestMonitor& test)
{
  const std::vector<glm::vec4> ball = vtkSSAOBallKernel(1024);
  glm::dvec3 mean(0.0);
  double inner = 0.0;
  double longest = 0.0;
  for (const glm::vec4& point : ball)
  {
    const double length = glm::length(glm::dvec3(point));
    mean += glm::dvec3(point) / 1024.0;
    inner += length < 0.5 ? 1.0 / 1024.0 : 0.0;
    longest = std::max(longest, length);
  }
  test.ExpectAtMost(glm::length(mean), 0.01, "ball: distance of the mean from the centre");
  test.ExpectNear(inner, 0.125, 0.01, "ball: share of the points within half of it");
  test.ExpectAtMost(longest, 1.0 + 1.0e-6, "ball: largest length");

  const std::vector<glm::vec4> cube = vtkSSAOCubeKernel(128);
  double beyond = -1.0;
  double corner = 0.0;
  double nearest = 1.0;
  glm::dvec3 behind(0.0);
  for (int i = 0; i < 128; ++i)
  {
    const double share = i / 128.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double distance = std::abs(cube[i][axis]);
      beyond = std::max(beyond, distance - (0.1 + 0.9 * share * share));
      corner = std::max(corner, distance);
      behind[axis] += cube[i][axis] < 0.0F ? 1.0 / 128.0 : 0.0;
    }
    nearest = std::min(nearest, std::abs(static_cast<double>(cube[i].z)));
  }
  test.ExpectAtMost(beyond, 1.0e-6, "cube: excess over the accelerating size");
  test.ExpectAtLeast(corner, 0.8, "cube: largest coordinate");
  test.ExpectAtLeast(nearest, 1.0e-4, "cube: no point lies in the plane that faces the viewer");
  for (int axis = 0; axis < 3; ++axis)
  {
    test.ExpectNear(
      behind[axis], 0.5, 0.04, "cube: share of the points behind plane " + std::to_string(axis));
  }
}

//------------------------------------------------------------------------------
void TestTile(vtkSSAOTestMonitor& test)
{
  for (int size : { 1, 2, 4, 5, 16 })
  {
    const std::string what = "tile of " + std::to_string(size) + ": ";
    const int count = size * size;
    const std::vector<glm::vec4> tile = vtkSSAONoiseTile(size);
    const std::vector<glm::vec2> rotations = vtkSSAORotationTile(size);
    bool same = static_cast<int>(tile.size()) == count;
    std::vector<double> turns;
    std::vector<double> seconds;
    glm::dvec3 mirrors(0.0);
    double length = 0.0;
    for (int i = 0; i < count; ++i)
    {
      same = same && tile[i].z == rotations[i].x && tile[i].w == rotations[i].y;
      turns.push_back(tile[i].x);
      seconds.push_back(tile[i].y);
      const glm::vec3 mirror = shader::ssaoMirror(tile[i]);
      mirrors += glm::dvec3(mirror) / static_cast<double>(count);
      length = std::max(length, std::abs(glm::length(glm::dvec3(mirror)) - 1.0));
    }
    test.Expect(same, what + "its rotations are those of the tile of rotations");
    std::sort(turns.begin(), turns.end());
    std::sort(seconds.begin(), seconds.end());
    double uneven = 0.0;
    for (int i = 0; i < count; ++i)
    {
      uneven = std::max(uneven, std::abs(turns[i] - i / double(count)));
      uneven = std::max(uneven, std::abs(seconds[i] - (i + 0.5) / count));
    }
    test.ExpectAtMost(uneven, 1.0e-6, what + "both numbers are evenly spaced");
    test.ExpectAtMost(length, 1.0e-6, what + "mirrors are unit vectors");
    if (size > 2)
    {
      // Even over the upper half of the sphere: mean (0, 0, 1/2).
      test.ExpectAtMost(
        glm::length(mirrors - glm::dvec3(0, 0, 0.5)), 0.12, what + "mean of the mirrors");
    }
  }
}

//------------------------------------------------------------------------------
// Depth to a depth buffer in single precision and back.
void TestWindowDepth(vtkSSAOTestMonitor& test)
{
  for (double ratio : { 2.0, 100.0, 10000.0 })
  {
    const double low = 1.5;
    const double high = low * ratio;
    const double range = high - low;
    const glm::vec4 perspective(-(high + low) / range, -2.0 * high * low / range, -1.0, 0.0);
    const glm::vec4 parallel(-2.0 / range, -(high + low) / range, 0.0, 1.0);
    double error[2] = { 0.0, 0.0 };
    for (int i = 0; i <= 1000; ++i)
    {
      const auto depth = static_cast<float>(low * std::pow(ratio, i / 1000.0));
      for (int kind = 0; kind < 2; ++kind)
      {
        const glm::vec4 rows = kind ? parallel : perspective;
        const double back = shader::ssaoDepthOfWindow(shader::ssaoWindowOfDepth(depth, rows), rows);
        // What one step of the buffer, 2^-24, is in depth.
        const double step =
          (kind ? range : double(depth) * depth * range / (high * low)) * std::pow(2.0, -24.0);
        error[kind] = std::max(error[kind], std::abs(back - depth) / step);
      }
    }
    const std::string what = ", far / near " + std::to_string(static_cast<int>(ratio)) +
      ": steps of the buffer that a depth is off";
    test.ExpectAtMost(error[0], 3.0, "perspective" + what);
    test.ExpectAtMost(error[1], 3.0, "parallel" + what);
  }
}
}

//------------------------------------------------------------------------------
int UnitTestEstimatorKernels(int, char*[])
{
  vtkSSAOTestMonitor test;
  TestSphere(test);
  TestBallAndCube(test);
  TestTile(test);
  TestWindowDepth(test);
  return test.GetResult();
}
