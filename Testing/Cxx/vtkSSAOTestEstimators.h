// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tests of the estimators share: the comparison with the same shader text in double, and
 * what holds for every estimator.
 */

#ifndef vtkSSAOTestEstimators_h
#define vtkSSAOTestEstimators_h

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSSAOOcclusionSettings.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkSSAOTwin.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace vtkSSAOTest
{
constexpr const char* EstimatorNames[] = { "CrytekSphere", "PositionSphere", "DepthSphere",
  "Hemisphere", "HemisphereLinearDepth", "ReflectedHemisphere", "HorizonAngle", "ExactHorizon",
  "LayeredBitmask" };
constexpr int NumberOfEstimators = 9;

//------------------------------------------------------------------------------
/// V of a view before denoising, and a twin of what it was made from.
struct RawAndTwin
{
  vtkSSAOTestImage Raw;
  vtkSSAOTwin Twin;
};

inline RawAndTwin RenderWithTwin(vtkSSAOTestView& view)
{
  const int denoiser = view.Pass->GetDenoiser();
  view.Pass->SetDenoiserToNone();
  const vtkSSAOTestImage raw = view.Visibility();
  view.Pass->SetDenoiser(denoiser);
  vtkNew<vtkImageData> geometry;
  view.Pass->GetGeometry(geometry);
  vtkSSAOTwin twin(geometry, view.Renderer->GetActiveCamera());
  vtkNew<vtkImageData> solids;
  if (view.Pass->GetSolids(solids))
  {
    twin.SetSolids(solids);
  }
  return { raw, twin };
}

//------------------------------------------------------------------------------
/**
 * The picture in single precision, not denoised, equals the same text in double to within 1/255.
 *
 * Where a comparison falls within rounding of its threshold (a sample on the edge of a texel, a
 * point on the surface, a surface at the radius), single precision may decide otherwise than
 * double. Such pixels are known by disturbing the twin by about what rounding may do, 1/2000 of a
 * pixel and 2e-6 of the depths: the picture must then lie, to within 1/255, between what the
 * disturbed twins give. They are counted and may be two in a thousand.
 */
inline void ExpectTwin(vtkSSAOTestMonitor& test, vtkSSAOTestView& view, const std::string& what)
{
  const RawAndTwin pair = RenderWithTwin(view);
  const vtkSSAOTestImage& picture = pair.Raw;
  const vtkSSAOTwin& twin = pair.Twin;
  const vtkSSAOOcclusionSettings settings = vtkSSAOOcclusionSettings::Of(view.Pass);
  const std::vector<double> exact = twin.Visibility(settings);

  std::vector<double> low = exact;
  std::vector<double> high = exact;
  for (int i = 0; i < 8; ++i)
  {
    vtkSSAODisturbance disturbance;
    disturbance.X = i & 1 ? 5.0e-4 : -5.0e-4;
    disturbance.Y = i & 2 ? 5.0e-4 : -5.0e-4;
    disturbance.Depth = i & 4 ? 2.0e-6 : -2.0e-6;
    const std::vector<double> disturbed = twin.Visibility(settings, disturbance);
    for (std::size_t j = 0; j < disturbed.size(); ++j)
    {
      low[j] = std::min(low[j], disturbed[j]);
      high[j] = std::max(high[j], disturbed[j]);
    }
  }

  const double tolerance = 1.0 / 255.0;
  int surfaces = 0;
  int atThreshold = 0;
  int wrong = 0;
  double largest = 0.0; // difference of the pixels that are not at a threshold
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const double value = picture.Values[i];
    const double difference = std::abs(value - exact[i]);
    surfaces += exact[i] < 1.0 ? 1 : 0;
    if (difference <= tolerance)
    {
      largest = std::max(largest, difference);
    }
    else if (value >= low[i] - tolerance && value <= high[i] + tolerance)
    {
      ++atThreshold;
    }
    else
    {
      ++wrong; // NaN as well
    }
  }
  test.ExpectAtLeast(surfaces, 1000, what + ", pixels with occlusion");
  test.ExpectEqual(wrong, 0, what + ", pixels that differ from the twin by more than 1/255");
  test.ExpectAtMost(255.0 * largest, 1.0, what + ", largest difference in 1/255");
  test.ExpectAtMost(static_cast<double>(atThreshold) / exact.size(), 0.002,
    what + ", share of pixels where rounding decides a comparison");
}

//------------------------------------------------------------------------------
/// ExpectTwin on the still life, in both projections, the second in a viewport off the corner.
inline void ExpectTwins(vtkSSAOTestMonitor& test,
  const std::function<void(vtkScreenSpaceAmbientOcclusionPass*)>& setUp, const std::string& what)
{
  for (bool parallel : { false, true })
  {
    vtkSSAOTestView view(test, parallel ? 250 : 120, parallel ? 190 : 90);
    vtkSSAOAddStillLife(view);
    view.Pass->SetRadius(0.5);
    setUp(view.Pass);
    if (parallel)
    {
      view.Renderer->SetViewport(0.503, 0.507, 0.99, 0.99);
    }
    vtkSSAOLookAtStillLife(view, parallel);
    // The floor reaches below the camera: what a depth buffer would make of that is not the matter.
    view.Renderer->GetActiveCamera()->SetClippingRange(2.0, 20.0);
    ExpectTwin(test, view, what + (parallel ? ", parallel" : ", perspective"));
  }
}

//------------------------------------------------------------------------------
/// Mean of an image over the 5 x 5 pixels about a point of the world.
inline double MeanAbout(
  vtkSSAOTestView& view, const vtkSSAOTestImage& image, double x, double y, double z)
{
  view.Renderer->SetWorldPoint(x, y, z, 1.0);
  view.Renderer->WorldToDisplay();
  const double* display = view.Renderer->GetDisplayPoint();
  const int column = static_cast<int>(display[0]);
  const int row = static_cast<int>(display[1]);
  return vtkSSAOMeasure(
    image, [=](int i, int j) { return std::abs(i - column) <= 2 && std::abs(j - row) <= 2; })
    .Mean;
}

//------------------------------------------------------------------------------
/// Camera over the middle of a floor at an elevation in degrees, from a distance of 15.
inline void LookAtFloor(vtkSSAOTestView& view, double elevation, bool parallel)
{
  const double angle = elevation * std::acos(-1.0) / 180.0;
  const std::vector<double> from = { 0.0, 15.0 * std::sin(angle), 15.0 * std::cos(angle) };
  if (parallel)
  {
    view.LookParallel(from, { 0, 0, 0 }, { 0, 1, 0 }, 4.0);
  }
  else
  {
    view.Look(from, { 0, 0, 0 }, { 0, 1, 0 });
  }
}

//------------------------------------------------------------------------------
/// Mean V of an open floor in the inner part of the picture, where no sample leaves it.
inline vtkSSAOStatistics OpenFloor(vtkSSAOTestView& view, double elevation, bool parallel)
{
  LookAtFloor(view, elevation, parallel);
  const vtkSSAOTestImage v = view.Visibility();
  return vtkSSAOMeasure(v,
    [&](int x, int y) {
      return std::abs(x - v.Width / 2) < v.Width / 4 && std::abs(y - v.Height / 2) < v.Height / 8;
    });
}

//------------------------------------------------------------------------------
/**
 * What holds for every estimator: V from 0 to 1 and never NaN for any radius and any angle of view,
 * 1 where there is no surface; an open floor has the V given, seen at 60 and at 30 degrees; under a
 * ball the floor is darker than away from it by at least the contrast given.
 */
inline void ExpectProperties(vtkSSAOTestMonitor& test,
  const std::function<void(vtkScreenSpaceAmbientOcclusionPass*)>& setUp, double openV,
  double tolerance, double contrast, const std::string& what)
{
  {
    vtkSSAOTestView view(test, 120, 90);
    vtkSSAOAddStillLife(view);
    setUp(view.Pass);
    int backgrounds = 0;
    int darkBackgrounds = 0;
    bool finite = true;
    for (double radius : { 1.0e-9, 0.01, 0.5, 20.0, 1.0e9 })
    {
      for (double viewAngle : { 30.0, 130.0 })
      {
        view.Pass->SetRadius(radius);
        view.Look({ 0.6, 1.1, 1.9 }, { -0.1, 0.5, 0.0 }, { 0, 1, 0 }, viewAngle);
        const vtkSSAOTestImage v = view.Visibility();
        const vtkSSAOTestImage surfaces = view.Surfaces();
        for (std::size_t i = 0; i < v.Values.size(); ++i)
        {
          finite = finite && v.Values[i] >= 0.0F && v.Values[i] <= 1.0F;
          backgrounds += surfaces.Values[i] > 0.0F ? 0 : 1;
          darkBackgrounds += surfaces.Values[i] > 0.0F || v.Values[i] == 1.0F ? 0 : 1;
        }
      }
    }
    test.Expect(finite, what + ": V is a number from 0 to 1, for any radius and angle of view");
    test.ExpectAtLeast(backgrounds, 100, what + ", pixels without a surface");
    test.ExpectEqual(darkBackgrounds, 0, what + ", of these with V below 1");
  }

  vtkSSAOTestView view(test, 240, 160);
  vtkSSAOAddFloor(view);
  view.Pass->SetRadius(0.8);
  setUp(view.Pass);
  for (bool parallel : { false, true })
  {
    for (double elevation : { 60.0, 30.0 })
    {
      test.ExpectNear(OpenFloor(view, elevation, parallel).Mean, openV, tolerance,
        what + ", V of an open floor at " + std::to_string(static_cast<int>(elevation)) +
          (parallel ? " degrees, parallel" : " degrees, perspective"));
    }
  }
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, 0.8, 0.0);
  ball->SetRadius(0.8);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(48);
  view.Add(ball);
  for (bool parallel : { false, true })
  {
    LookAtFloor(view, 45.0, parallel);
    const vtkSSAOTestImage v = view.Visibility();
    const double near = MeanAbout(view, v, 0.0, 0.0, 0.4);
    const double away = MeanAbout(view, v, 0.0, 0.0, 2.6);
    test.ExpectAtLeast(away - near, contrast,
      what + ", V away from a ball minus V under it, " + (parallel ? "parallel" : "perspective"));
  }
}
}

#endif
