// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTestView.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOReportMethods.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <cstdlib>
#include <string>
#include <utility>

namespace
{
//------------------------------------------------------------------------------
vtkSSAOTestImage Component(vtkImageData* image, int component)
{
  vtkSSAOTestImage result(image->GetDimensions()[0], image->GetDimensions()[1]);
  const int components = image->GetNumberOfScalarComponents();
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < result.Values.size(); ++i)
  {
    result.Values[i] = values[i * components + component];
  }
  return result;
}
}

//------------------------------------------------------------------------------
vtkSSAOTestView::vtkSSAOTestView(
  vtkSSAOTestMonitor& monitor, int width, int height, int multiSamples)
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Window(vtkSmartPointer<vtkRenderWindow>::New())
  , Pass(vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass>::New())
  , Monitor(monitor)
{
  if (const char* className = std::getenv("SSAO_TEST_WINDOW"))
  {
    // On screen, where the window has one.
    monitor.Expect(this->Window->IsA(className),
      std::string("the window is a ") + className + ", got " + this->Window->GetClassName());
  }
  else
  {
    this->Window->SetOffScreenRendering(1);
  }
  this->Window->SetMultiSamples(multiSamples);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetPass(this->Pass);
}

//------------------------------------------------------------------------------
vtkSSAOTestView::~vtkSSAOTestView()
{
  vtkWeakPointer<vtkRenderWindow> window = this->Window.Get();
  vtkWeakPointer<vtkRenderer> renderer = this->Renderer.Get();
  vtkWeakPointer<vtkScreenSpaceAmbientOcclusionPass> pass = this->Pass.Get();
  this->Pass = nullptr;
  this->Renderer = nullptr;
  this->Window = nullptr;
  if (window || renderer || pass)
  {
    this->Monitor.Expect(false, "window, renderer and pass are deleted at the end");
  }
}

//------------------------------------------------------------------------------
const char* vtkSSAOTestView::GetPresetName(int preset)
{
  const char* names[] = { "Fast", "Balanced", "Accurate" };
  return names[preset];
}

//------------------------------------------------------------------------------
void vtkSSAOTestView::SetPreset(int preset)
{
  switch (preset)
  {
    case 0:
      this->Pass->SetQualityToFast();
      break;
    case 1:
      this->Pass->SetQualityToBalanced();
      break;
    default:
      this->Pass->SetQualityToAccurate();
      break;
  }
}

//------------------------------------------------------------------------------
vtkActor* vtkSSAOTestView::Add(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* vtkSSAOTestView::Add(vtkAlgorithm* source)
{
  source->Update();
  return this->Add(vtkPolyData::SafeDownCast(source->GetOutputDataObject(0)));
}

//------------------------------------------------------------------------------
void vtkSSAOTestView::Look(const std::vector<double>& from, const std::vector<double>& at,
  const std::vector<double>& up, double viewAngle)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(at.data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(viewAngle);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkSSAOTestView::LookParallel(const std::vector<double>& from, const std::vector<double>& at,
  const std::vector<double>& up, double scale)
{
  this->Look(from, at, up);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(scale);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkSSAOTestView::Render()
{
  this->Window->Render();
  if (!this->Watched)
  {
    this->Watched = true;
    this->Monitor.Watch(this->Window);
    this->Pass->Modified();
    this->Window->Render();
  }
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::Visibility()
{
  this->Pass->Modified(); // not what is left of the last frame
  this->Render();
  vtkNew<vtkImageData> image;
  if (!this->Pass->GetVisibility(image))
  {
    this->Monitor.Expect(false, "the pass has a visibility to give");
    return vtkSSAOTestImage();
  }
  return Component(image, 0);
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::VisibilityOfVTK(double radius)
{
  std::vector<std::pair<vtkActor*, vtkSmartPointer<vtkProperty>>> shown;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    shown.emplace_back(actor, actor->GetProperty());
    vtkNew<vtkProperty> white;
    white->DeepCopy(actor->GetProperty());
    white->SetColor(1.0, 1.0, 1.0);
    white->SetAmbient(1.0);
    white->SetDiffuse(0.0);
    white->SetSpecular(0.0);
    actor->SetProperty(white);
  }
  vtkSmartPointer<vtkImageProcessingPass> pass;
  for (const vtkSSAOReportMethod& method : vtkSSAOReportMethods(true))
  {
    pass = method.IsVTK && method.Samples == 64 ? method.NewPass(radius) : pass;
  }
  this->Renderer->SetPass(pass);
  vtkSmartPointer<vtkImageData> picture = this->Picture();
  pass->ReleaseGraphicsResources(this->Window);
  this->Renderer->SetPass(this->Pass);
  for (const auto& pair : shown)
  {
    pair.first->SetProperty(pair.second);
  }

  const int* place = this->Renderer->GetOrigin();
  const int* size = this->Renderer->GetSize();
  vtkSSAOTestImage image(size[0], size[1]);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* pixel =
        static_cast<unsigned char*>(picture->GetScalarPointer(place[0] + x, place[1] + y, 0));
      image.At(x, y) = *pixel / 255.0F;
    }
  }
  return image;
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::ReadGeometry(int component)
{
  vtkNew<vtkImageData> image;
  if (!this->Pass->GetGeometry(image))
  {
    this->Monitor.Expect(false, "the pass has a geometry to give");
    return vtkSSAOTestImage();
  }
  return Component(image, component);
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::Depth()
{
  return this->ReadGeometry(0);
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::Surfaces()
{
  vtkSSAOTestImage surfaces = this->Depth();
  for (float& value : surfaces.Values)
  {
    value = value > 0.0F ? 1.0F : 0.0F;
  }
  return surfaces;
}

//------------------------------------------------------------------------------
vtkSSAOTestImage vtkSSAOTestView::Normal(int component)
{
  return this->ReadGeometry(1 + component);
}

//------------------------------------------------------------------------------
vtkSSAOStatistics vtkSSAOTestView::MeasureSurfaces(const vtkSSAOTestImage& image)
{
  const vtkSSAOTestImage surfaces = this->Surfaces();
  return vtkSSAOMeasure(image, [&](int x, int y) { return surfaces.At(x, y) > 0.0F; });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSSAOTestView::Picture()
{
  this->Render();
  return vtkSSAOReadWindow(this->Window);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkSSAOReadWindow(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  pixels->SetName("Colors");
  picture->GetPointData()->SetScalars(pixels);
  return picture;
}
