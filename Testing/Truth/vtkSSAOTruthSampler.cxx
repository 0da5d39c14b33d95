// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthSampler.h"

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// A permutation of the 32-bit integers in which every input bit changes every output bit
// ("lowbias32", Wellons).
std::uint32_t Mix(std::uint32_t x)
{
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return x;
}

//------------------------------------------------------------------------------
std::uint32_t ReverseBits(std::uint32_t x)
{
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  x = ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
  return x;
}

//------------------------------------------------------------------------------
// Owen's scrambling of a number whose bits are reversed: each bit is flipped depending only on the
// bits below it (Burley 2020, listing 3).
std::uint32_t ScrambleReversed(std::uint32_t x, std::uint32_t seed)
{
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

//------------------------------------------------------------------------------
// Second dimension of Sobol's sequence: direction numbers v_0 = 2^31, v_k = v_(k-1) xor
// v_(k-1) / 2.
std::uint32_t SecondDimension(std::uint32_t index)
{
  std::uint32_t result = 0;
  for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1)
  {
    if (index & 1u)
    {
      result ^= v;
    }
  }
  return result;
}

//------------------------------------------------------------------------------
// sin and cos of 2 pi turn, turn in [0, 1): Taylor series about the nearest quarter turn, where
// the angle is at most pi / 4 and the first term left out is below 1e-15.
void SinCos(double turn, double& sine, double& cosine)
{
  const int quarter = static_cast<int>(4.0 * turn + 0.5);
  const double a = 6.283185307179586 * (turn - 0.25 * quarter);
  const double b = a * a;
  const double s = a *
    (1.0 -
      b / 6.0 *
        (1.0 -
          b / 20.0 *
            (1.0 -
              b / 42.0 *
                (1.0 - b / 72.0 * (1.0 - b / 110.0 * (1.0 - b / 156.0 * (1.0 - b / 210.0)))))));
  const double c = 1.0 -
    b / 2.0 *
      (1.0 -
        b / 12.0 *
          (1.0 -
            b / 30.0 *
              (1.0 - b / 56.0 * (1.0 - b / 90.0 * (1.0 - b / 132.0 * (1.0 - b / 182.0))))));
  switch (quarter & 3)
  {
    case 0:
      sine = s;
      cosine = c;
      break;
    case 1:
      sine = c;
      cosine = -s;
      break;
    case 2:
      sine = -s;
      cosine = -c;
      break;
    default:
      sine = -c;
      cosine = s;
      break;
  }
}
}

//------------------------------------------------------------------------------
vtkSSAOTruthSampler::vtkSSAOTruthSampler(std::uint32_t x, std::uint32_t y, std::uint32_t replicate)
{
  const std::uint32_t pixel = Mix(x + Mix(y + Mix(replicate)));
  this->Seeds[0] = Mix(pixel ^ 0x9e3779b9u);
  this->Seeds[1] = Mix(pixel ^ 0x7f4a7c15u);
}

//------------------------------------------------------------------------------
void vtkSSAOTruthSampler::GetPoint(std::uint32_t index, double u[2]) const
{
  // The first dimension is the reversed index, so its reverse is the index itself.
  const double scale = 1.0 / 4294967296.0;
  u[0] = scale * ReverseBits(ScrambleReversed(index, this->Seeds[0]));
  u[1] = scale * ReverseBits(ScrambleReversed(ReverseBits(SecondDimension(index)), this->Seeds[1]));
}

//------------------------------------------------------------------------------
void vtkSSAOTruthSampler::GetCosineDirection(const double u[2], double w[3])
{
  double sine, cosine;
  SinCos(u[1], sine, cosine);
  const double radius = std::sqrt(u[0]);
  w[0] = radius * cosine;
  w[1] = radius * sine;
  w[2] = std::sqrt(std::max(0.0, 1.0 - u[0]));
}

//------------------------------------------------------------------------------
void vtkSSAOTruthSampler::GetUniformDirection(const double u[2], double w[3])
{
  double sine, cosine;
  SinCos(u[1], sine, cosine);
  w[2] = 1.0 - u[0];
  const double radius = std::sqrt(std::max(0.0, 1.0 - w[2] * w[2]));
  w[0] = radius * cosine;
  w[1] = radius * sine;
}
