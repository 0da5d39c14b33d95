// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The traced image is the same to the last bit for any number of threads, progress is told
 * and stops it, and bad settings are refused.
 */

#include "UnitTestTruthCommon.h"

#include "vtkObject.h"
#include "vtkSphereSource.h"

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <set>

namespace
{
using namespace TruthTest;

//------------------------------------------------------------------------------
bool AreEqual(const vtkSSAOTruthImage& a, const vtkSSAOTruthImage& b)
{
  return a.Width == b.Width && a.Height == b.Height && a.Visibility == b.Visibility &&
    a.StandardError == b.StandardError && a.Hit == b.Hit && a.Depth == b.Depth &&
    a.Normal == b.Normal && a.GeometricNormal == b.GeometricNormal;
}
}

//------------------------------------------------------------------------------
int UnitTestTruthThreads(int, char*[])
{
  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, MakeFloor(5.0, 0.0));
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(20);
  sphere->Update();
  for (int i = 0; i < 9; ++i)
  {
    AddPolyData(renderer, sphere->GetOutput())
      ->AddPosition(0.9 * (i % 3) - 0.9, 0.9 * (i / 3), 0.4);
  }
  SetCamera(renderer, false, { 0.0, -5.0, 4.0 }, { 0.0, 0.5, 0.3 }, 1.0, 30.0);

  vtkSSAOTruthTracer tracer;
  tracer.SetRadius(1.5);
  tracer.SetRaysPerPixel(64);
  tracer.SetThreads(1);
  const TracedView reference(renderer, 97, 71, tracer);
  bool good = CheckTrue("one thread traces", reference.Good);
  double sum = 0.0;
  for (std::size_t i = 0; i < reference.Image.Hit.size(); ++i)
  {
    sum += reference.Image.Hit[i];
  }
  good &= CheckTrue("most pixels show a surface", sum > 0.5 * 97 * 71);
  for (int threads : { 0, 2, 3, 7, 200 })
  {
    tracer.SetThreads(threads);
    good &= CheckTrue(std::to_string(threads) + " threads give the same image",
      AreEqual(TracedView(renderer, 97, 71, tracer).Image, reference.Image));
  }
  const std::string digest = tracer.GetDigest();
  tracer.SetThreads(1);
  good &= CheckTrue("threads are not part of the digest", tracer.GetDigest() == digest);

  tracer.SetRaysPerPixel(128);
  good &= CheckTrue("more rays give another image",
    !AreEqual(TracedView(renderer, 97, 71, tracer).Image, reference.Image));

  // Each row tells a share of its own, the last all; who says no traces no further.
  tracer.SetThreads(3);
  std::mutex mutex;
  std::set<double> shares;
  tracer.SetProgress(
    [&](double share)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      shares.insert(share);
      return true;
    });
  good &= CheckTrue("tracing with progress", TracedView(renderer, 97, 71, tracer).Good);
  good &= CheckTrue("71 rows, 71 shares", shares.size() == 71 && *shares.rbegin() == 1.0);
  std::atomic<int> rows(0);
  tracer.SetProgress([&rows](double) { return ++rows < 10; });
  good &= CheckTrue("tracing is stopped", !TracedView(renderer, 97, 71, tracer).Good);
  good &= CheckTrue("within a row of each thread", rows >= 10 && rows <= 12);

  // What is refused, with a warning each.
  vtkObject::GlobalWarningDisplayOff();
  for (double radius : { 0.0, -1.0, std::nan("") })
  {
    vtkSSAOTruthTracer bad;
    bad.SetRadius(radius);
    good &= CheckTrue(
      "radius " + std::to_string(radius) + " is refused", !TracedView(renderer, 8, 8, bad).Good);
  }
  vtkSSAOTruthTracer bad;
  bad.SetRaysPerPixel(0);
  good &= CheckTrue("no rays are refused", !TracedView(renderer, 8, 8, bad).Good);
  vtkObject::GlobalWarningDisplayOn();

  vtkNew<vtkRenderer> empty;
  SetCamera(empty, false, { 0.0, -5.0, 4.0 }, { 0.0, 0.5, 0.3 }, 1.0, 30.0);
  const TracedView nothing(empty, 8, 8, vtkSSAOTruthTracer());
  good &= CheckTrue("an empty scene is all background",
    nothing.Good && nothing.Image.Visibility == std::vector<float>(64, 1.0f) &&
      nothing.Image.Hit == std::vector<unsigned char>(64, 0));
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
