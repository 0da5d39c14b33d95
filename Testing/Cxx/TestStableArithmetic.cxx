// SPDX-License-Identifier: BSD-3-Clause

// What single precision costs: the picture before denoising against the same shader text in double,
// over the cases of the other tests of stability.

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestEstimators.h"

#include <cmath>
#include <sstream>
#include <string>

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
  }
  return test.GetResult();
}
