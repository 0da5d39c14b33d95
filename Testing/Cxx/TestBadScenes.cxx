// SPDX-License-Identifier: BSD-3-Clause

// Scenes and windows with nothing to occlude: they render as without the pass, and nobody
// complains but where it is due.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <functional>
#include <string>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// The picture with the pass equals the one without, in every output mode that shows colours; the
// visibility is 1 everywhere.
void ExpectNothing(vtkSSAOTestMonitor& test, vtkSSAOTestView& view, const std::string& what)
{
  view.Renderer->SetPass(nullptr);
  vtkSmartPointer<vtkImageData> plain = view.Picture();
  view.Renderer->SetPass(view.Pass);
  for (int mode : { 0, 2 })
  {
    view.Pass->SetOutputMode(mode);
    test.ExpectEqual(vtkSSAOImageCompare::Difference(view.Picture(), plain, 0).Largest, 0,
      what + ", mode " + std::to_string(mode) +
        ": largest difference from the picture without pass");
  }
  view.Pass->SetOutputModeToOcclusion();
  vtkSmartPointer<vtkImageData> white = view.Picture();
  const double* range = white->GetScalarRange();
  test.ExpectEqual(range[0], 255.0, what + ": smallest grey of the occlusion");
  for (int mode : { 3, 4 })
  {
    view.Pass->SetOutputMode(mode);
    view.Picture();
  }
  view.Pass->SetOutputModeToComposite();
}

//------------------------------------------------------------------------------
void TestNoSurfaces(vtkSSAOTestMonitor& test)
{
  for (int samples : { 0, 4 })
  {
    const std::string with = ", " + std::to_string(samples) + " samples";
    {
      vtkSSAOTestView view(test, 60, 40, samples);
      view.Renderer->SetBackground(0.2, 0.4, 0.6);
      ExpectNothing(test, view, "no props" + with);
      test.ExpectEqual(view.Pass->GetEffectiveRadius(), 0.0, "radius without props" + with);
    }
    {
      vtkSSAOTestView view(test, 60, 40, samples);
      vtkNew<vtkPolyData> empty;
      view.Add(empty);
      ExpectNothing(test, view, "empty mesh" + with);
      view.Pass->SetRadius(1.0);
      ExpectNothing(test, view, "empty mesh with a radius" + with);
    }
    {
      vtkSSAOTestView view(test, 60, 40, samples);
      vtkNew<vtkActor> none;
      view.Renderer->AddActor(none); // no mapper
      ExpectNothing(test, view, "actor without mapper" + with);
    }
    {
      vtkSSAOTestView view(test, 60, 40, samples);
      vtkSSAOAddFloor(view)->VisibilityOff();
      ExpectNothing(test, view, "all props invisible" + with);
    }
    {
      vtkSSAOTestView view(test, 60, 40, samples);
      vtkSSAOAddFloor(view);
      view.Look({ 0, 10, 10 }, { 0, 20, 20 }, { 0, 1, 0 });
      ExpectNothing(test, view, "all props out of sight" + with);
    }
    {
      // One point, so the automatic radius is 0.
      vtkSSAOTestView view(test, 60, 40, samples);
      view.Add(vtkSSAOQuad({ 1, 1, 1 }, { 0, 0, 0 }, { 0, 0, 0 }));
      view.Look({ 0, 0, 10 }, { 1, 1, 1 }, { 0, 1, 0 });
      ExpectNothing(test, view, "mesh without extent" + with);
    }
  }
}

//------------------------------------------------------------------------------
void TestSizes(vtkSSAOTestMonitor& test)
{
  for (int samples : { 0, 4 })
  {
    vtkSSAOTestView view(test, 1, 1, samples);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, false);
    for (const auto& size :
      { std::pair<int, int>(1, 1), { 1, 50 }, { 50, 1 }, { 3, 2 }, { 64, 64 } })
    {
      view.Window->SetSize(size.first, size.second);
      const vtkSSAOTestImage v = view.Visibility();
      const std::string what = std::to_string(size.first) + " x " + std::to_string(size.second) +
        ", " + std::to_string(samples) + " samples: ";
      test.ExpectEqual(v.Width, size.first, what + "width");
      test.ExpectEqual(v.Height, size.second, what + "height");
      const vtkSSAOStatistics all = vtkSSAOMeasure(v, [](int, int) { return true; });
      test.Expect(all.Minimum >= 0.0 && all.Maximum <= 1.0, what + "V is within 0 and 1");
    }
    for (const auto& size : { std::pair<int, int>(0, 0), { 0, 20 }, { 20, 0 } })
    {
      // VTK may make something of such a window; the pass must only survive.
      view.Window->SetSize(size.first, size.second);
      view.Window->Render();
    }
    view.Window->SetSize(64, 64);
    test.ExpectAtMost(view.MeasureSurfaces(view.Visibility()).Minimum, 0.99,
      "V after a window without pixels, " + std::to_string(samples) + " samples");
  }
}

//------------------------------------------------------------------------------
// A viewport without pixels, or outside the window: nothing is drawn, at most one warning.
void TestViewports(vtkSSAOTestMonitor& test)
{
  vtkSSAOTestView view(test, 60, 40);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  vtkSSAOErrorObserver observer(view.Pass);
  const double viewports[][4] = { { 0.5, 0.5, 0.5, 0.5 }, { 0.2, 0.5, 0.8, 0.5 },
    { 0.5, 0.1, 0.5, 0.9 }, { 0.5, 0.5, 0.505, 0.505 } };
  for (const auto& viewport : viewports)
  {
    view.Renderer->SetViewport(viewport);
    view.Window->Render();
  }
  test.ExpectAtMost(observer.GetWarnings(), 1, "warnings for viewports without pixels");
  test.ExpectEqual(observer.GetErrors(), 0, "errors for viewports without pixels");
  view.Renderer->SetViewport(0, 0, 1, 1);
  test.ExpectAtMost(
    view.MeasureSurfaces(view.Visibility()).Minimum, 0.99, "V in a whole viewport again");
}
}

//------------------------------------------------------------------------------
int TestBadScenes(int, char*[])
{
  vtkSSAOTestMonitor test;
  TestNoSurfaces(test);
  TestSizes(test);
  TestViewports(test);
  return test.GetResult();
}
