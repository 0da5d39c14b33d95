// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthSampler
 * @brief   Low-discrepancy directions, the same on every machine, run and thread count.
 *
 * The points are the first two dimensions of Sobol's sequence, a (0,2)-sequence: any first 2^k
 * points have one point in each elementary rectangle of area 2^-k. Each pixel and each replicate
 * scrambles both dimensions independently (Owen's nested scrambling, by hashing: Burley, "Practical
 * Hash-based Owen Scrambling", JCGT 9(4), 2020), so every replicate is an unbiased estimate and
 * replicates are independent of each other.
 *
 * Only integer arithmetic, +, -, *, / and sqrt are used: no sine of a C library, no generator or
 * distribution of a C++ library.
 */

#ifndef vtkSSAOTruthSampler_h
#define vtkSSAOTruthSampler_h

#include <cstdint>

class vtkSSAOTruthSampler
{
public:
  /**
   * The sequence of one replicate (counted from 0) in one pixel.
   */
  vtkSSAOTruthSampler(std::uint32_t x, std::uint32_t y, std::uint32_t replicate);

  /**
   * Point number `index` of the sequence, in [0, 1)^2.
   */
  void GetPoint(std::uint32_t index, double u[2]) const;

  /**
   * Unit direction in the hemisphere about +z, its density cos(theta) / pi.
   */
  static void GetCosineDirection(const double u[2], double w[3]);

  /**
   * Unit direction in the hemisphere about +z, its density 1 / (2 pi).
   */
  static void GetUniformDirection(const double u[2], double w[3]);

private:
  std::uint32_t Seeds[2];
};

#endif
