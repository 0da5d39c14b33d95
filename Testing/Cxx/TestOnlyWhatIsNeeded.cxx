// SPDX-License-Identifier: BSD-3-Clause

// Work that changes nothing is not done, and leaving it out changes nothing: an unchanged frame
// keeps its visibility, pixels without surfaces are not estimated, layers are drawn for the
// estimator that looks at them only, no sample is taken where the radius covers less than 1.3
// pixels or only one plane, and light that is the whole colour is not captured.

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
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
#include <array>
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
// Over a part of two images. columns, rows: the first and the one after the last.
double LargestDifference(const vtkSSAOTestImage& one, const vtkSSAOTestImage& other,
  const std::array<int, 2>& columns, const std::array<int, 2>& rows)
{
  double largest = 0.0;
  for (int y = rows[0]; y < rows[1]; ++y)
  {
    for (int x = columns[0]; x < columns[1]; ++x)
    {
      largest = std::max(largest, std::abs(double(one.At(x, y)) - double(other.At(x, y))));
    }
  }
  return largest;
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
  view.Add(vtkSSAOQuad({ -2, 0, 2 }, { 4, 0, 0 }, { 0, 0, -4 }));
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-1.0, 0.0, 0.0, 1.0, -0.5, 0.5);
  view.Add(box);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.6, 0.4, 0.5);
  view.Add(sphere);
  view.Look({ 4, 10, 14 }, { 0, 0, 0 }, { 0, 1, 0 });
  view.SetPreset(preset);
  view.Pass->SetRadius(0.6);
  const vtkSSAOTestImage partly = view.Visibility();
  const int estimated = view.Pass->GetNumberOfEstimatedPixels();
  const int squares = view.Pass->GetDownsampling() * view.Pass->GetDownsampling();
  test.Expect(estimated > 0, what + "pixels are estimated");
  test.ExpectAtMost(4 * estimated * squares, 200 * 150,
    what + "four times the pixels for a scene in the middle of the screen");

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
  // The square and its radius are to the right.
  const double largest = LargestDifference(with, without, { 0, 120 }, { 0, 150 });
  // Layers end behind what they enter, and what is seen only begins there: an arc that ends a
  // sector farther on, 1/60 of V in one of 16 pixels.
  test.ExpectAtMost(255.0 * largest, 1.0, what + "largest difference of V, in 1/255");
}

//------------------------------------------------------------------------------
// A radius that covers less than 1.3 pixels costs no samples and no layers; where it covers a
// little more there is next to nothing to see yet.
void TestTinyRadius(vtkSSAOTestMonitor& test, int preset, bool parallel)
{
  const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) +
    (parallel ? ", parallel: " : ", perspective: ");
  vtkSSAOTestView view(test, 160, 120);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, parallel);
  view.SetPreset(preset);
  // Of the nearest surface, for which the radius covers the most.
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  const double half = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  view.Visibility();
  const double nearest = view.MeasureSurfaces(view.Depth()).Minimum;
  const double pixel = (parallel ? camera->GetParallelScale() : half * nearest) / 60.0;

  // Away from the middle of the picture a ray is longer, by up to a fifteenth here.
  view.Pass->SetRadius(1.2 * pixel);
  const vtkSSAOTestImage none = view.Visibility();
  test.ExpectEqual(view.Pass->GetNumberOfSampledPixels(), 0, what + "sampled pixels, 1.2 pixels");
  // Means of ones are rounded.
  test.ExpectAtLeast(
    view.MeasureSurfaces(none).Minimum, 1.0 - 1.0e-6, what + "smallest V, 1.2 pixels");
  view.Pass->SetRadius(0.9 * pixel);
  view.Visibility();
  test.ExpectEqual(
    view.Pass->GetNumberOfLayerDrawings(), 0, what + "drawings of layers, 0.9 pixels");

  view.Pass->SetRadius(2.0 * pixel);
  const vtkSSAOTestImage some = view.Visibility();
  test.Expect(view.Pass->GetNumberOfSampledPixels() > 0, what + "there are samples at 2 pixels");
  // What the samples of a smaller radius could have told is less than this.
  test.ExpectAtLeast(
    view.MeasureSurfaces(some).Mean, 1.0 - 1.0 / 255.0, what + "mean V at 2 pixels");
}

//------------------------------------------------------------------------------
// A step on a floor that fills the picture. Far from it the floor is all that is in reach.
void TestOnePlane(vtkSSAOTestMonitor& test, int preset, bool parallel)
{
  const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) +
    (parallel ? ", parallel: " : ", perspective: ");
  const bool proves = preset > 0; // Fast does not look for layers
  const auto fill = [&](vtkSSAOTestView& view)
  {
    vtkSSAOAddFloor(view);
    parallel ? view.LookParallel({ 2, 9, 7 }, { 0, 0, 0 }, { 0, 1, 0 }, 3.0)
             : view.Look({ 2, 9, 7 }, { 0, 0, 0 }, { 0, 1, 0 });
    view.SetPreset(preset);
    view.Pass->SetRadius(0.6);
  };
  vtkSSAOTestView floor(test, 240, 180);
  fill(floor);
  const vtkSSAOTestImage open = floor.Visibility();
  const int all = floor.Pass->GetNumberOfEstimatedPixels();
  test.ExpectEqual(floor.Pass->GetNumberOfSampledPixels(), proves ? 0 : all,
    what + "sampled pixels of a floor alone");
  test.ExpectAtLeast(floor.MeasureSurfaces(open).Minimum, 0.998, what + "smallest V of it");

  vtkSSAOTestView view(test, 240, 180);
  fill(view);
  vtkNew<vtkCubeSource> step;
  step->SetBounds(-0.7, 0.3, -0.5, 0.4, -0.5, 0.5);
  view.Add(step);
  const vtkSSAOTestImage partly = view.Visibility();
  const int sampled = view.Pass->GetNumberOfSampledPixels();
  test.ExpectAtMost(view.MeasureSurfaces(partly).Minimum, 0.8, what + "smallest V at a step");
  if (proves)
  {
    test.ExpectAtMost(sampled, 0.6 * all, what + "sampled pixels about a step");
  }
  else
  {
    test.ExpectEqual(sampled, all, what + "sampled pixels about a step");
  }

  // Specks in two corners, and nothing is proven any more. They are too small to matter
  // elsewhere.
  for (double side : { -1.0, 1.0 })
  {
    vtkNew<vtkSphereSource> speck;
    speck->SetRadius(0.2);
    // Where the floor is seen there: on the line between two points of the view's depth.
    double ends[2][3] = { { 0.98 * side, 0.98 * side, -0.5 }, { 0.98 * side, 0.98 * side, 0.5 } };
    for (double(&end)[3] : ends)
    {
      view.Renderer->ViewToWorld(end[0], end[1], end[2]);
    }
    const double share = ends[0][1] / (ends[0][1] - ends[1][1]);
    speck->SetCenter(ends[0][0] + share * (ends[1][0] - ends[0][0]), 0.0,
      ends[0][2] + share * (ends[1][2] - ends[0][2]));
    view.Add(speck);
  }
  const vtkSSAOTestImage wholly = view.Visibility();
  test.ExpectAtLeast(
    view.Pass->GetNumberOfSampledPixels(), 0.98 * all, what + "sampled pixels with two specks");
  // The specks and their radius are outside.
  const double largest = LargestDifference(wholly, partly, { 60, 180 }, { 45, 135 });
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
    for (bool parallel : { false, true })
    {
      TestTinyRadius(test, preset, parallel);
      TestOnePlane(test, preset, parallel);
    }
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
