// SPDX-License-Identifier: BSD-3-Clause

// What single precision costs: the picture before denoising against the same shader text in double,
// over the cases of the other tests of stability.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestEstimators.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkSphereSource.h"

#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// Root mean square of the difference, over the pixels that show a surface.
double ArithmeticError(vtkSSAOTestView& view)
{
  const vtkSSAOTest::RawAndTwin pair = vtkSSAOTest::RenderWithTwin(view);
  const std::vector<double> exact = pair.Twin.Visibility(vtkSSAOOcclusionSettings::Of(view.Pass));
  const vtkSSAOTestImage surfaces = view.Surfaces();
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    if (surfaces.Values[i] > 0.0F)
    {
      const double difference = pair.Raw.Values[i] - exact[i];
      sum += difference * difference;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

//------------------------------------------------------------------------------
void Measure(vtkSSAOStability& row, vtkSSAOTestView& view, const std::string& what)
{
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    view.SetPreset(preset);
    row.Ours(preset, 255.0 * ArithmeticError(view), what);
  }
}

//------------------------------------------------------------------------------
// Where nothing occludes: a floor seen flat and from above, a body of few facets, normals of
// length 0.
void MeasureOpen(
  vtkSSAOTestMonitor& test, vtkSSAOStability& row, bool parallel, const std::string& projection)
{
  vtkSSAOTestView floor(test, 120, 90);
  vtkSSAOAddFloor(floor);
  floor.Pass->SetRadius(1.0);
  for (double elevation : { 5.0, 89.0 })
  {
    vtkSSAOTest::LookAtFloor(floor, elevation, parallel);
    Measure(row, floor, "floor at " + std::to_string(elevation) + " degrees" + projection);
  }
  vtkSSAOTestView body(test, 120, 90);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(6);
  sphere->SetPhiResolution(6);
  vtkActor* actor = body.Add(sphere);
  vtkSSAOTest::LookAtFloor(body, 30.0, parallel);
  actor->SetScale(5.0);
  body.Renderer->ResetCameraClippingRange();
  body.Pass->SetRadius(1.0);
  Measure(row, body, "sphere of few facets" + projection);
  vtkPolyData* data = sphere->GetOutput();
  data->GetPointData()->GetNormals()->Fill(0.0);
  data->GetPointData()->GetNormals()->Modified();
  Measure(row, body, "normals of length 0" + projection);
}

//------------------------------------------------------------------------------
// The controls at both ends, as far as the twin needs no minutes for it.
void MeasureControls(
  vtkSSAOTestMonitor& test, vtkSSAOStability& row, bool parallel, const std::string& projection)
{
  using Pass = vtkScreenSpaceAmbientOcclusionPass;
  const std::vector<std::pair<std::string, std::function<void(Pass*)>>> ends = {
    { "1 direction, 1 step",
      [](Pass* pass)
      {
        pass->SetDirections(1);
        pass->SetSteps(1);
      } },
    { "64 directions", [](Pass* pass) { pass->SetDirections(64); } },
    { "64 steps", [](Pass* pass) { pass->SetSteps(64); } },
    { "1 layer", [](Pass* pass) { pass->SetLayers(1); } },
    { "9 layers", [](Pass* pass) { pass->SetLayers(9); } },
    { "noise size 64", [](Pass* pass) { pass->SetNoiseSize(64); } },
    { "radius 1e30", [](Pass* pass) { pass->SetRadius(1.0e30); } },
  };
  for (const auto& end : ends)
  {
    vtkSSAOTestView view(test, 60, 45);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, parallel);
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      view.Pass->SetRadius(0.5);
      view.SetPreset(preset);
      end.second(view.Pass);
      row.Ours(preset, 255.0 * ArithmeticError(view), end.first + projection);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableArithmetic(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability row(test, "Single against double precision, on these cases",
    "RMS of the difference before denoising in 1/255", vtkSSAOStability::AtMost, 1.0);
  for (bool parallel : { false, true })
  {
    const std::string projection = parallel ? ", parallel" : ", perspective";
    for (double scale : { 1.0, 1.0e-6, 1.0e6 })
    {
      std::ostringstream what;
      what << "scale " << scale << projection;
      vtkSSAOTestView view(test, 120, 90);
      vtkSSAOAddStillLife(view, scale);
      vtkSSAOLookAtStillLife(view, parallel, scale);
      view.Pass->SetRadius(0.5 * scale);
      Measure(row, view, what.str());
    }

    vtkSSAOTestView view(test, 120, 90);
    vtkSSAOAddStillLife(view);
    for (double radius : { 0.02, 6.0 })
    {
      std::ostringstream what;
      what << "radius " << radius << projection;
      vtkSSAOLookAtStillLife(view, parallel);
      view.Pass->SetRadius(radius);
      Measure(row, view, what.str());
    }
    view.Pass->SetRadius(0.5);
    for (double nearest : { 2.0, 0.01 })
    {
      std::ostringstream what;
      what << "near and far at " << nearest << " and 1e4" << projection;
      view.Renderer->GetActiveCamera()->SetClippingRange(nearest, 1.0e4);
      Measure(row, view, what.str());
    }
    // In parallel projection from afar nearly all of the difference is the twin's: it gets depths
    // from the camera on in float32, and the pass works with finer ones. At 20,000 R, in steps of
    // .002 R, that alone is 1.08/255 with Fast.
    for (double away : { 10.0, 2000.0, parallel ? 10000.0 : 20000.0 })
    {
      const std::vector<double> at = { -0.1, 0.5, 0.0 };
      const double distance = 0.5 * away;
      const std::vector<double> from = { at[0] + 0.25 * distance, at[1] + 0.4 * distance,
        at[2] + 0.8818 * distance };
      std::ostringstream what;
      what << away << " R away" << projection;
      if (parallel)
      {
        view.LookParallel(from, at, { 0, 1, 0 }, 1.3);
      }
      else
      {
        view.Look(from, at, { 0, 1, 0 }, 2.0 * std::atan(1.3 / distance) * 180.0 / std::acos(-1.0));
      }
      Measure(row, view, what.str());
    }

    for (const std::array<double, 3>& offset :
      { std::array<double, 3>{ 2.683e6, 1.247e6, 400.0 }, { 1.0e7, 1.0e7, 1.0e7 } })
    {
      vtkSSAOTestView moved(test, 120, 90);
      vtkSSAOAddStillLife(moved);
      vtkSSAOLookAtStillLife(moved, parallel);
      vtkSSAOMoveScene(moved, offset);
      moved.Pass->SetRadius(0.5);
      Measure(row, moved, "moved by " + std::to_string(offset[0]) + projection);
    }
    for (const auto& size : { std::pair<int, int>(201, 133), { 500, 10 }, { 10, 500 } })
    {
      vtkSSAOTestView shaped(test, size.first, size.second);
      vtkSSAOAddStillLife(shaped);
      vtkSSAOLookAtStillLife(shaped, parallel);
      shaped.Pass->SetRadius(0.5);
      Measure(row, shaped,
        std::to_string(size.first) + " x " + std::to_string(size.second) + " pixels" + projection);
    }
    MeasureOpen(test, row, parallel, projection);
    MeasureControls(test, row, parallel, projection);
  }
  return test.GetResult();
}
