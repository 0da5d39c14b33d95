// SPDX-License-Identifier: BSD-3-Clause

// The pass outlives its window, its window outlives it, resources are released and made again,
// one pass serves two renderers, windows change their size: pictures stay right, no OpenGL object
// is left behind.

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <algorithm>
#include <string>

namespace
{
//------------------------------------------------------------------------------
int Difference(vtkImageData* a, vtkImageData* b)
{
  return vtkSSAOImageCompare::Difference(a, b, 0).Largest;
}

//------------------------------------------------------------------------------
void TestRelease(vtkSSAOTestMonitor& test, int samples)
{
  const std::string with = ", " + std::to_string(samples) + " samples";
  vtkSSAOTestView view(test, 80, 60, samples);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  vtkNew<vtkImageData> image;
  test.Expect(!view.Pass->GetVisibility(image), "no visibility before any render" + with);
  test.Expect(!view.Pass->GetGeometry(image), "no geometry before any render" + with);
  // Before anything was rendered.
  view.Pass->ReleaseGraphicsResources(view.Window);
  view.Renderer->SetPass(nullptr);
  view.Picture();
  int before[3];
  const char* kinds[3] = { "Texture", "Framebuffer", "Renderbuffer" };
  for (int i = 0; i < 3; ++i)
  {
    before[i] = vtkSSAOCountObjects(view.Window, kinds[i]);
  }
  view.Renderer->SetPass(view.Pass);
  vtkSmartPointer<vtkImageData> first = view.Picture();
  test.ExpectAtLeast(
    static_cast<double>(view.Pass->GetTextureMemory()), 80.0 * 60.0 * 4.0, "texture memory" + with);
  test.ExpectAtLeast(
    vtkSSAOCountObjects(view.Window, "Texture"), before[0] + 3, "textures in use" + with);
  for (int round = 0; round < 3; ++round)
  {
    for (int denoiser : { 0, 1, 4 })
    {
      for (int mode : { 4, 3, 2, 1, 0 })
      {
        view.Pass->SetDenoiser(denoiser);
        view.Pass->SetOutputMode(mode);
        view.Picture();
      }
    }
    view.Pass->ReleaseGraphicsResources(view.Window);
    test.ExpectEqual(static_cast<double>(view.Pass->GetTextureMemory()), 0.0,
      "texture memory after release" + with);
    test.Expect(!view.Pass->GetVisibility(image), "no visibility after release" + with);
    for (int i = 0; i < 3; ++i)
    {
      test.ExpectEqual(vtkSSAOCountObjects(view.Window, kinds[i]), before[i],
        std::string(kinds[i]) + "s after release" + with);
    }
    test.ExpectEqual(Difference(view.Picture(), first), 0, "picture after release" + with);
    view.Pass->ReleaseGraphicsResources(view.Window);
    view.Pass->ReleaseGraphicsResources(view.Window); // twice
  }
  test.ExpectEqual(Difference(view.Picture(), first), 0, "picture after two releases" + with);

  // Frames do not pile up anything, whatever changes.
  view.Picture();
  const int textures = vtkSSAOCountObjects(view.Window, "Texture");
  const int builds = view.Pass->GetNumberOfProgramBuilds();
  for (int i = 0; i < 5; ++i)
  {
    view.Pass->SetRadius(0.2 + 0.1 * i);
    view.Pass->SetKernelSize(8 + i);
    view.Pass->SetNoiseSize(3 + i);
    view.Pass->SetPower(1.0 + i);
    view.Window->SetSize(80 + 7 * i, 60 - 5 * i);
    view.Picture();
  }
  test.ExpectEqual(
    vtkSSAOCountObjects(view.Window, "Texture"), textures, "textures after other sizes" + with);
  test.ExpectEqual(view.Pass->GetNumberOfProgramBuilds(), builds, "programs built" + with);

  // The window goes first, then comes again.
  view.Pass->SetRadius(0.0);
  view.SetPreset(1);
  view.Pass->SetPower(1.0);
  view.Window->SetSize(80, 60);
  view.Window->Finalize();
  test.ExpectEqual(Difference(view.Picture(), first), 0, "picture after Finalize" + with);
}

//------------------------------------------------------------------------------
void TestOrderOfDeath(vtkSSAOTestMonitor& test)
{
  vtkSmartPointer<vtkImageData> first;
  vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass> pass;
  {
    vtkSSAOTestView view(test, 80, 60);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, false);
    first = view.Picture();
    // The pass goes first.
    vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass> old = view.Pass;
    view.Pass = vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass>::New();
    view.Renderer->SetPass(view.Pass);
    old = nullptr;
    test.ExpectEqual(Difference(view.Picture(), first), 0, "picture with a new pass");
    view.Renderer->SetPass(nullptr);
    view.Picture();
    view.Renderer->SetPass(view.Pass);
    test.ExpectEqual(Difference(view.Picture(), first), 0, "picture with the pass set again");
  }
  {
    // The pass outlives the window and serves another one.
    auto window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(80, 60);
    vtkNew<vtkRenderer> renderer;
    pass = vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass>::New();
    renderer->SetPass(pass);
    window->AddRenderer(renderer);
    vtkSSAOTestView props(test, 80, 60);
    vtkSSAOAddStillLife(props);
    window->Render();
    window = nullptr;
  }
  vtkSSAOTestView view(test, 80, 60);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Renderer->SetPass(pass);
  test.ExpectEqual(
    Difference(view.Picture(), first), 0, "picture with the pass of a window that is gone");
  view.Renderer->SetPass(view.Pass);
}

//------------------------------------------------------------------------------
// The context goes while the pass is not in use, so that nobody tells it.
void TestLossUnnoticed(vtkSSAOTestMonitor& test, int samples)
{
  const std::string with = ", " + std::to_string(samples) + " samples";
  vtkSSAOTestView view(test, 80, 60, samples);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  vtkSmartPointer<vtkImageData> first = view.Picture();
  view.Renderer->SetPass(nullptr);
  view.Picture();
  view.Window->Finalize();
  vtkNew<vtkImageData> image;
  test.Expect(!view.Pass->GetVisibility(image), "no visibility of a context that is gone" + with);
  test.Expect(!view.Pass->GetGeometry(image), "no geometry of a context that is gone" + with);
  test.Expect(!view.Pass->GetSolids(image), "no solids of a context that is gone" + with);
  view.Picture();
  view.Renderer->SetPass(view.Pass);
  test.ExpectEqual(
    Difference(view.Picture(), first), 0, "picture after a loss that nobody told of" + with);

  // The same with the renderer out of the window.
  view.Window->RemoveRenderer(view.Renderer);
  view.Window->Finalize();
  test.Expect(!view.Pass->GetVisibility(image), "no visibility without the window" + with);
  view.Window->AddRenderer(view.Renderer);
  test.ExpectEqual(Difference(view.Picture(), first), 0, "picture in the window again" + with);

  // A renderer and its pass move to another window, and the first one dies.
  vtkSmartPointer<vtkRenderWindow> old = view.Window;
  old->RemoveRenderer(view.Renderer);
  view.Window = vtkSmartPointer<vtkRenderWindow>::New();
  view.Window->SetOffScreenRendering(1);
  view.Window->SetMultiSamples(samples);
  view.Window->SetSize(80, 60);
  view.Window->AddRenderer(view.Renderer);
  test.ExpectEqual(Difference(view.Picture(), first), 0, "picture in another window" + with);
  old = nullptr;
  test.ExpectEqual(
    Difference(view.Picture(), first), 0, "picture after the death of the first window" + with);
  // And back to one of the same kind, after the window died first.
  view.Renderer->SetPass(nullptr);
  view.Window->RemoveRenderer(view.Renderer);
  view.Window = nullptr;
  test.Expect(!view.Pass->GetVisibility(image), "no visibility of a dead window" + with);
  view.Window = vtkSmartPointer<vtkRenderWindow>::New();
  view.Window->SetOffScreenRendering(1);
  view.Window->SetMultiSamples(samples);
  view.Window->SetSize(80, 60);
  view.Window->AddRenderer(view.Renderer);
  view.Renderer->SetPass(view.Pass);
  test.ExpectEqual(Difference(view.Picture(), first), 0, "picture in a third window" + with);
}

//------------------------------------------------------------------------------
void TestSharedPass(vtkSSAOTestMonitor& test, int samples)
{
  const std::string with = ", " + std::to_string(samples) + " samples";
  vtkSSAOTestView left(test, 80, 60, samples);
  vtkSSAOAddStillLife(left);
  vtkSSAOLookAtStillLife(left, false);
  vtkSSAOTestView right(test, 80, 60, samples);
  vtkSSAOAddCorner(right);
  vtkSSAOLookAtCorner(right, true);
  vtkSmartPointer<vtkImageData> leftPicture = left.Picture();
  vtkSmartPointer<vtkImageData> rightPicture = right.Picture();

  // Two renderers in one window share one pass, and take turns in size.
  vtkSSAOTestView both(test, 160, 60, samples);
  vtkSSAOAddStillLife(both);
  vtkSSAOLookAtStillLife(both, false);
  both.Renderer->SetViewport(0, 0, 0.5, 1);
  vtkNew<vtkRenderer> second;
  second->SetViewport(0.5, 0, 1, 1);
  second->SetPass(both.Pass);
  second->SetActiveCamera(right.Renderer->GetActiveCamera());
  {
    vtkSSAOTestView corner(test, 80, 60, samples);
    vtkSSAOAddCorner(corner);
    vtkCollectionSimpleIterator it;
    vtkActorCollection* actors = corner.Renderer->GetActors();
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
    {
      second->AddActor(actor);
    }
  }
  both.Window->AddRenderer(second);
  for (int frame = 0; frame < 3; ++frame)
  {
    vtkSmartPointer<vtkImageData> picture = both.Picture();
    int largest = 0;
    for (int y = 0; y < 60; ++y)
    {
      for (int x = 0; x < 80; ++x)
      {
        const auto* a = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
        const auto* b = static_cast<unsigned char*>(leftPicture->GetScalarPointer(x, y, 0));
        const auto* c = static_cast<unsigned char*>(picture->GetScalarPointer(x + 80, y, 0));
        const auto* d = static_cast<unsigned char*>(rightPicture->GetScalarPointer(x, y, 0));
        for (int i = 0; i < 3; ++i)
        {
          largest = std::max({ largest, std::abs(a[i] - b[i]), std::abs(c[i] - d[i]) });
        }
      }
    }
    // The position of the viewport rounds differently, see TestViewportOffset.
    test.ExpectAtMost(largest, 1, "largest difference of two renderers with one pass" + with);
  }
  both.Window->RemoveRenderer(second);

  // One pass in two windows, taking turns.
  vtkSSAOTestView other(test, 80, 60, samples);
  vtkSSAOAddCorner(other);
  vtkSSAOLookAtCorner(other, true);
  for (int frame = 0; frame < 2; ++frame)
  {
    left.Renderer->SetPass(both.Pass);
    test.ExpectEqual(Difference(left.Picture(), leftPicture), 0, "one window of two" + with);
    other.Renderer->SetPass(both.Pass);
    test.ExpectEqual(Difference(other.Picture(), rightPicture), 0, "the other window" + with);
  }
  left.Renderer->SetPass(left.Pass);
  other.Renderer->SetPass(other.Pass);
}

//------------------------------------------------------------------------------
void TestResize(vtkSSAOTestMonitor& test, int samples)
{
  vtkSSAOTestView view(test, 80, 60, samples);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  view.Picture();
  for (const auto& size :
    { std::pair<int, int>(120, 90), { 40, 200 }, { 7, 5 }, { 300, 20 }, { 80, 60 } })
  {
    view.Window->SetSize(size.first, size.second);
    vtkSmartPointer<vtkImageData> picture = view.Picture();
    vtkSSAOTestView fresh(test, size.first, size.second, samples);
    vtkSSAOAddStillLife(fresh);
    vtkSSAOLookAtStillLife(fresh, false);
    // The clipping range depends on nothing but the props.
    test.ExpectEqual(Difference(picture, fresh.Picture()), 0,
      "picture resized to " + std::to_string(size.first) + " x " + std::to_string(size.second) +
        ", " + std::to_string(samples) + " samples, against a new window");
  }
}
}

//------------------------------------------------------------------------------
int TestLifetime(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (int samples : { 0, 4 })
  {
    TestRelease(test, samples);
    TestResize(test, samples);
    TestLossUnnoticed(test, samples);
    TestSharedPass(test, samples);
  }
  TestOrderOfDeath(test);
  return test.GetResult();
}
