// SPDX-License-Identifier: BSD-3-Clause

// Work that changes nothing is not done, and leaving it out changes nothing: an unchanged frame
// keeps its visibility, pixels without surfaces are not estimated, layers are drawn for the
// estimator that looks at them only, and light that is the whole colour is not captured.

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
//------------------------------------------------------------------------------
vtkSSAOTestImage Kept(vtkSSAOTestMonitor& test, vtkSSAOTestView& view)
{
  vtkNew<vtkImageData> image;
  test.Expect(view.Pass->GetVisibility(image), "there is a visibility");
  vtkSSAOTestImage values(image->GetDimensions()[0], image->GetDimensions()[1]);
  const auto* first = static_cast<const float*>(image->GetScalarPointer());
  values.Values.assign(first, first + values.Values.size());
  return values;
}

//------------------------------------------------------------------------------
void TestUnchangedFrames(vtkSSAOTestMonitor& test, int preset)
{
  const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) + ", ";
  vtkSSAOTestView view(test, 120, 90);
  vtkNew<vtkSphereSource> source;
  vtkActor* sphere = view.Add(source);
  vtkPolyDataMapper::SafeDownCast(sphere->GetMapper())->SetInputConnection(source->GetOutputPort());
  sphere->SetPosition(0.3, 0.2, 0.6);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, -5.0);
  plane->SetNormal(0.0, 0.0, 1.0);
  sphere->GetMapper()->AddClippingPlane(plane);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.SetPreset(preset);

  view.Window->Render();
  test.Expect(view.Pass->GetNumberOfEstimatedPixels() > 0, what + "the first frame is estimated");
  const vtkSSAOTestImage first = Kept(test, view);
  vtkSmartPointer<vtkImageData> picture = view.Picture();
  view.Window->Render();
  test.ExpectEqual(
    view.Pass->GetNumberOfEstimatedPixels(), 0, what + "pixels estimated for the same frame");
  test.ExpectEqual(
    view.Pass->GetNumberOfLayerDrawings(), 0, what + "drawings of layers for the same frame");
  test.Expect(Kept(test, view) == first, what + "V of the same frame");
  test.ExpectEqual(vtkSSAOImageCompare::Difference(view.Picture(), picture, 0).Largest, 0,
    what + "largest difference of the picture of the same frame");

  // What is interpolated only when it is asked for is that of the frame, not of later settings.
  const int downsampling = view.Pass->GetDownsampling();
  for (int denoiser :
    { vtkScreenSpaceAmbientOcclusionPass::EdgeAware, vtkScreenSpaceAmbientOcclusionPass::None })
  {
    view.Window->Render();
    view.Pass->SetDownsampling(downsampling % 4 + 1);
    view.Pass->SetDenoiser(denoiser);
    test.Expect(Kept(test, view) == first, what + "V of the frame before other settings");
    view.Pass->SetDownsampling(downsampling);
    view.Pass->SetDenoiserToEdgeAware();
  }

  // Whatever V depends on brings a new estimate, the same as a pass without a past gives.
  const std::vector<std::pair<std::string, std::function<void()>>> changes = {
    { "camera", [&] { view.Renderer->GetActiveCamera()->Azimuth(10.0); } },
    { "clipping range", [&] { view.Renderer->GetActiveCamera()->SetClippingRange(0.1, 100.0); } },
    { "position", [&] { sphere->SetPosition(0.0, 0.0, 0.9); } },
    { "scale", [&] { sphere->SetScale(1.5, 1.0, 1.0); } },
    { "mesh", [&] { source->SetRadius(0.7); } },
    { "clipping plane", [&] { plane->SetOrigin(0.0, 0.0, 0.9); } },
    { "visibility", [&] { sphere->VisibilityOff(); } },
    { "radius", [&] { view.Pass->SetRadius(0.5); } },
    { "directions", [&] { view.Pass->SetDirections(5); } },
    { "coincident topology", [] { vtkMapper::SetResolveCoincidentTopologyToPolygonOffset(); } },
    { "shift of coincident topology",
      [] { vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(3.0, 5.0); } },
    { "window", [&] { view.Window->SetSize(90, 90); } },
  };
  for (const auto& change : changes)
  {
    change.second();
    view.Window->Render();
    test.Expect(
      view.Pass->GetNumberOfEstimatedPixels() > 0, what + change.first + " brings an estimate");
    const vtkSSAOTestImage after = Kept(test, view);
    test.Expect(view.Visibility() == after, what + change.first + ", V estimated once more");
    view.Window->Render();
    test.ExpectEqual(view.Pass->GetNumberOfEstimatedPixels(), 0,
      what + change.first + ", pixels estimated for the frame after");
  }
  // For all mappers of the process.
  vtkMapper::SetResolveCoincidentTopologyToDefault();
  vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(2.0, 2.0);
}

//------------------------------------------------------------------------------
void TestEmptyScreen(vtkSSAOTestMonitor& test, int preset)
{
  const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) + ", ";
  vtkSSAOTestView view(test, 200, 150);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Renderer->GetActiveCamera()->Zoom(0.25);
  view.SetPreset(preset);
  view.Pass->SetRadius(0.6);
  const vtkSSAOTestImage partly = view.Visibility();
  const int estimated = view.Pass->GetNumberOfEstimatedPixels();
  const int squares = view.Pass->GetDownsampling() * view.Pass->GetDownsampling();
  test.ExpectAtMost(4 * estimated * squares, 200 * 150,
    what + "four times the pixels for a still life in the middle of the screen");

  // A prop that may draw beyond its bounds costs the screen; points are not drawn here.
  vtkNew<vtkSphereSource> hidden;
  hidden->SetRadius(1.0e-6);
  vtkActor* actor = view.Add(hidden);
  actor->GetProperty()->SetPointSize(3.0);
  actor->SetPosition(0.0, 0.0, 0.05);
  const vtkSSAOTestImage wholly = view.Visibility();
  test.ExpectEqual(view.Pass->GetNumberOfEstimatedPixels() * squares, 200 * 150,
    what + "pixels that may be drawn to");
  test.ExpectEqual(vtkSSAOLargestDifference(partly, wholly), 0.0,
    what + "largest difference of V with the whole screen estimated");
}

//------------------------------------------------------------------------------
// Where one surface goes on over the whole picture, layers are not drawn; with them, because of a
// gap somewhere else, V is the same.
void TestGaps(vtkSSAOTestMonitor& test, int preset, bool parallel)
{
  const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) +
    (parallel ? ", parallel: " : ", perspective: ");
  vtkSSAOTestView view(test, 200, 150);
  vtkSSAOAddCorner(view);
  vtkNew<vtkSphereSource> hill; // less steep than the view on it
  hill->SetRadius(3.0);
  hill->SetCenter(-2.0, -2.4, 2.0);
  hill->SetThetaResolution(120);
  hill->SetPhiResolution(60);
  view.Add(hill);
  vtkSSAOLookAtCorner(view, parallel);
  view.SetPreset(preset);
  view.Pass->SetRadius(1.0);
  const vtkSSAOTestImage without = view.Visibility();
  test.ExpectAtMost(view.MeasureSurfaces(without).Minimum, 0.8, what + "smallest V");
  test.ExpectEqual(
    view.Pass->GetNumberOfLayerDrawings(), 0, what + "drawings of layers without a gap");

  view.Add(vtkSSAOQuad({ 3.5, 1.0, 3.0 }, { 1, 0, 0 }, { 0, 0, -1 }));
  const vtkSSAOTestImage with = view.Visibility();
  test.ExpectEqual(view.Pass->GetNumberOfLayerDrawings(), preset == 0 ? 0 : 1,
    what + "drawings of layers with a gap");
  double largest = 0.0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 120; ++x) // the square and its radius are to the right
    {
      largest = std::max(largest, std::abs(double(with.At(x, y)) - double(without.At(x, y))));
    }
  }
  // Layers end behind what they enter, and what is seen only begins there: an arc that ends a
  // sector farther on, 1/60 of V in one of 16 pixels.
  test.ExpectAtMost(255.0 * largest, 1.0, what + "largest difference of V, in 1/255");
}

//------------------------------------------------------------------------------
// A highlight too weak to be seen: what may be occluded is no more the whole colour, but looks
// alike.
void TestCapturedLight(vtkSSAOTestMonitor& test)
{
  vtkSSAOTestView view(test, 120, 90);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  const auto setHighlights = [&](double specular)
  {
    vtkCollectionSimpleIterator it;
    vtkActorCollection* actors = view.Renderer->GetActors();
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
    {
      actor->GetProperty()->SetDiffuse(0.6); // with the highlight it fits into the picture
      actor->GetProperty()->SetSpecular(specular);
    }
  };
  setHighlights(0.0);
  const vtkSmartPointer<vtkImageData> whole = view.Picture();
  const unsigned long memory = view.Pass->GetTextureMemory();
  setHighlights(1.0e-6);
  const vtkSmartPointer<vtkImageData> parts = view.Picture();
  test.ExpectEqual(double(view.Pass->GetTextureMemory() - memory), 120 * 90 * 16,
    "bytes for the light that may be occluded, where it is not the whole colour");
  // Each way rounds the picture's eight bits in its own way.
  test.ExpectAtMost(vtkSSAOImageCompare::Difference(parts, whole, 0).Largest, 1,
    "largest difference in 1/255 to the picture from the whole colour");
}
}

//------------------------------------------------------------------------------
int TestOnlyWhatIsNeeded(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    TestUnchangedFrames(test, preset);
    TestEmptyScreen(test, preset);
    TestGaps(test, preset, false);
    TestGaps(test, preset, true);
  }

  TestCapturedLight(test);

  vtkSSAOTestView view(test, 60, 40);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  const int drawings[] = { 0, 0, 1, 1, 1, 1, 2, 2, 2, 2 };
  view.Pass->SetEstimatorToLayeredBitmask();
  for (int layers = 1; layers <= 9; ++layers)
  {
    view.Pass->SetLayers(layers);
    view.Visibility();
    test.ExpectEqual(view.Pass->GetNumberOfLayerDrawings(), drawings[layers],
      "drawings for " + std::to_string(layers) + " layers");
  }
  view.Pass->SetEstimatorToExactHorizon();
  view.Visibility();
  test.ExpectEqual(view.Pass->GetNumberOfLayerDrawings(), 0, "drawings of layers nobody looks at");
  return test.GetResult();
}
