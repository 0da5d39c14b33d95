// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A floor with boxes on and above it, and the visibility that rays find there.
 */

#ifndef vtkSSAOTestBoxes_h
#define vtkSSAOTestBoxes_h

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkSSAOTestEstimators.h"

#include <array>
#include <limits>

namespace vtkSSAOTest
{
/// Bounds as VTK has them: x from, to, y from, to, z from, to.
using Box = std::array<double, 6>;

inline vtkActor* AddBox(vtkSSAOTestView& view, const Box& box)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(box.data());
  return view.Add(source);
}

//------------------------------------------------------------------------------
/// Where a ray enters a box; infinity if it does not.
inline double Entry(const Box& box, const double (&from)[3], const double (&direction)[3])
{
  double entry = 0.0;
  double exit = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const double a = (box[2 * i] - from[i]) / direction[i];
    const double b = (box[2 * i + 1] - from[i]) / direction[i];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return entry < exit ? entry : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
/**
 * V of the point (x, 0, z) of the floor by 180 x 720 rays, distributed by the cosine, that a box
 * stops within the radius.
 */
inline double RayTracedV(const std::vector<Box>& boxes, double x, double z, double radius)
{
  const double from[3] = { x, 0.0, z };
  const int rings = 180;
  const int rays = 720;
  int open = 0;
  for (int i = 0; i < rings; ++i)
  {
    const double squaredSine = (i + 0.5) / rings;
    for (int j = 0; j < rays; ++j)
    {
      const double angle = 2.0 * std::acos(-1.0) * (j + 0.37) / rays;
      const double direction[3] = { std::sqrt(squaredSine) * std::cos(angle),
        std::sqrt(1.0 - squaredSine), std::sqrt(squaredSine) * std::sin(angle) };
      bool hidden = false;
      for (const Box& box : boxes)
      {
        hidden = hidden || Entry(box, from, direction) <= radius;
      }
      open += hidden ? 0 : 1;
    }
  }
  return open / static_cast<double>(rings * rays);
}

//------------------------------------------------------------------------------
/// Whether the camera sees the point (x, 0, z) of the floor past the boxes.
inline bool IsSeen(vtkSSAOTestView& view, const std::vector<Box>& boxes, double x, double z)
{
  const double from[3] = { x, 0.0, z };
  double position[3];
  view.Renderer->GetActiveCamera()->GetPosition(position);
  const double direction[3] = { position[0] - x, position[1], position[2] - z };
  for (const Box& box : boxes)
  {
    if (std::isfinite(Entry(box, from, direction)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
struct ErrorOfV
{
  int Points = 0;
  double Bias = 0.0;
  double Largest = 0.0;
};

/// What the picture's V differs from the rays' along x = 0 on the floor, where that is seen.
inline ErrorOfV ErrorAlongFloor(
  vtkSSAOTestView& view, const std::vector<Box>& boxes, double from, double to, double radius)
{
  const vtkSSAOTestImage v = view.Visibility();
  ErrorOfV error;
  for (int i = 0; i <= 16; ++i)
  {
    const double z = from + (to - from) * i / 16.0;
    // With a margin for the 5 x 5 pixels of the mean.
    if (!IsSeen(view, boxes, 0.0, z - 0.05) || !IsSeen(view, boxes, 0.0, z + 0.05))
    {
      continue;
    }
    const double difference = MeanAbout(view, v, 0.0, 0.0, z) - RayTracedV(boxes, 0.0, z, radius);
    ++error.Points;
    error.Bias += difference;
    error.Largest = std::max(error.Largest, std::abs(difference));
  }
  error.Bias /= std::max(error.Points, 1);
  return error;
}
}

#endif
