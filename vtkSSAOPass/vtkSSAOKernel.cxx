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
std::vector<glm::vec2> vtkSSAORotationTile(int size)
{
  std::vector<double> order;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      // Roberts' two-dimensional constants used as a dither: neighbours differ by about .75 and .57.
      const double value = x * 0.7548776662466927 + y * 0.5698402909980532;
      order.push_back(value - std::floor(value));
    }
  }
  std::vector<std::size_t> ranked(order.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t(0));
  std::sort(ranked.begin(), ranked.end(),
    [&order](std::size_t a, std::size_t b) { return order[a] < order[b]; });

  std::vector<glm::vec2> tile(order.size());
  for (std::size_t rank = 0; rank < ranked.size(); ++rank)
  {
    const double angle = glm::two_pi<double>() * rank / ranked.size();
    tile[ranked[rank]] = glm::dvec2(std::cos(angle), std::sin(angle));
  }
  return tile;
}
