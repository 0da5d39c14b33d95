// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOKernel.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace
{
//------------------------------------------------------------------------------
// Element `index` of the additive recurrence in `Dimension` dimensions: multiples of the powers of
// 1/g, where g is the positive root of g^(Dimension+1) = g + 1.
template <int Dimension>
std::array<double, Dimension> Quasirandom(int index)
{
  double g = 1.5;
  for (int i = 0; i < 64; ++i)
  {
    g = std::pow(1.0 + g, 1.0 / (Dimension + 1));
  }
  std::array<double, Dimension> element;
  double step = 1.0;
  for (double& coordinate : element)
  {
    step /= g;
    const double value = 0.5 + step * (index + 1);
    coordinate = value - std::floor(value);
  }
  return element;
}

//------------------------------------------------------------------------------
// Two numbers from 0 to 1 to a unit vector, uniform over the sphere.
glm::dvec3 Direction(double height, double turn)
{
  const double z = height * 2.0 - 1.0;
  const double angle = glm::two_pi<double>() * turn;
  const double across = std::sqrt(1.0 - z * z);
  return { across * std::cos(angle), across * std::sin(angle), z };
}

//------------------------------------------------------------------------------
// For each value its place among the sorted values.
std::vector<std::size_t> Ranks(const std::vector<double>& values)
{
  std::vector<std::size_t> sorted(values.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t(0));
  std::sort(sorted.begin(), sorted.end(),
    [&values](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::size_t> ranks(values.size());
  for (std::size_t rank = 0; rank < sorted.size(); ++rank)
  {
    ranks[sorted[rank]] = rank;
  }
  return ranks;
}
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkSSAOHemisphereKernel(int size)
{
  std::vector<glm::vec4> kernel;
  kernel.reserve(size);
  for (int i = 0; i < size; ++i)
  {
    const std::array<double, 4> random = Quasirandom<4>(i);
    const glm::dvec3 direction = glm::normalize(
      glm::dvec3(random[0] * 2.0 - 1.0, random[1] * 2.0 - 1.0, std::max(random[2], 1.0e-3)));
    const double share = static_cast<double>(i) / size;
    kernel.emplace_back(direction * random[3] * (0.1 + 0.9 * share * share), 0.0);
  }
  return kernel;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkSSAOSphereKernel(int size)
{
  std::vector<glm::vec4> kernel;
  kernel.reserve(size);
  for (int i = 0; i < size; ++i)
  {
    if (i % 2 == 1)
    {
      kernel.push_back(-kernel.back());
      continue;
    }
    const std::array<double, 2> random = Quasirandom<2>(i / 2);
    const double length = std::pow(1.0 + 2.4 / size, std::min(i + 2, size) - size);
    kernel.emplace_back(Direction(random[0], random[1]) * length, 0.0);
  }
  return kernel;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkSSAOBallKernel(int size)
{
  std::vector<glm::vec4> kernel;
  kernel.reserve(size);
  for (int i = 0; i < size; ++i)
  {
    const std::array<double, 3> random = Quasirandom<3>(i);
    kernel.emplace_back(Direction(random[0], random[1]) * std::cbrt(random[2]), 0.0);
  }
  return kernel;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkSSAOCubeKernel(int size)
{
  std::vector<glm::vec4> kernel;
  kernel.reserve(size);
  for (int i = 0; i < size; ++i)
  {
    const std::array<double, 3> random = Quasirandom<3>(i);
    const double share = static_cast<double>(i) / size;
    kernel.emplace_back(
      (glm::dvec3(random[0], random[1], random[2]) * 2.0 - 1.0) * (0.1 + 0.9 * share * share), 0.0);
  }
  return kernel;
}

//------------------------------------------------------------------------------
std::vector<glm::vec2> vtkSSAORotationTile(int size)
{
  std::vector<glm::vec2> tile;
  for (const glm::vec4& noise : vtkSSAONoiseTile(size))
  {
    tile.emplace_back(noise.z, noise.w);
  }
  return tile;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkSSAONoiseTile(int size)
{
  std::vector<double> order;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      // Roberts' two-dimensional constants used as a dither: neighbours differ by about .75 and
      // .57.
      const double value = x * 0.7548776662466927 + y * 0.5698402909980532;
      order.push_back(value - std::floor(value));
    }
  }
  const std::vector<std::size_t> turns = Ranks(order);

  // Multiples of the golden ratio, in the order of the turns: a pixel's second number and its first
  // cover the square evenly.
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    const double value = turns[i] * 0.6180339887498949;
    order[i] = value - std::floor(value);
  }
  const std::vector<std::size_t> seconds = Ranks(order);

  std::vector<glm::vec4> tile;
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    const double turn = static_cast<double>(turns[i]) / turns.size();
    const double angle = glm::two_pi<double>() * turn;
    tile.emplace_back(
      glm::dvec4(turn, (seconds[i] + 0.5) / seconds.size(), std::cos(angle), std::sin(angle)));
  }
  return tile;
}
