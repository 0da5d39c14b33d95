// SPDX-License-Identifier: BSD-3-Clause
/**
 * One view of one scene by every system, with its source's values and denoiser, beside the
 * ray-traced truth, and how far each is from it: the root mean square error of the visibility.
 * CompareSystems [picture.png [scene [folder with the data]]]
 */
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOImageError.h>
#include <vtkSSAOPass.h>
#include <vtkSSAOScenes.h>
#include <vtkSSAOTruthCamera.h>
#include <vtkSSAOTruthImage.h>
#include <vtkSSAOTruthScene.h>
#include <vtkSSAOTruthTracer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;
using Visibility = std::vector<float>; // a value per pixel, bottom row first

// Pixels of the sheet.
const int SheetWidth = 1400;
const int Gap = 12;
const int LineHeight = 20;
const int CaptionHeight = 3 * LineHeight + 8;

//------------------------------------------------------------------------------ systems

struct System
{
  std::string Name;
  std::string Settings;
  std::function<vtkSmartPointer<vtkImageProcessingPass>(double radius)> NewPass;
};

/// VTK's pass as applications use it: over the render steps, with its blur, and with a bias of 1 %
/// of the radius, as in the report of speed against error.
vtkSmartPointer<vtkImageProcessingPass> NewPassOfVTK(double radius)
{
  auto pass = vtkSmartPointer<vtkSSAOPass>::New();
  pass->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  pass->SetRadius(radius);
  pass->SetBias(0.01 * radius);
  pass->SetKernelSize(32);
  pass->BlurOn();
  return pass;
}

std::function<vtkSmartPointer<vtkImageProcessingPass>(double)> NewPass(
  int estimator, int samples, int denoiser)
{
  return [=](double radius)
  {
    auto pass = vtkSmartPointer<Pass>::New();
    pass->SetRadius(radius);
    pass->SetEstimator(estimator);
    pass->SetKernelSize(samples); // with directions and steps: their product
    pass->SetDenoiser(denoiser);
    pass->SetOutputModeToOcclusion();
    return pass;
  };
}

std::function<vtkSmartPointer<vtkImageProcessingPass>(double)> NewPreset(void (Pass::*set)())
{
  return [=](double radius)
  {
    auto pass = vtkSmartPointer<Pass>::New();
    pass->SetRadius(radius);
    (pass->*set)();
    pass->SetOutputModeToOcclusion();
    return pass;
  };
}

/// A line for each system.
std::vector<System> Systems()
{
  return {
    { "vtkSSAOPass of VTK", "32 points, Gaussian", NewPassOfVTK },
    { "CrytekSphere (Crytek)", "16 points, box", NewPass(Pass::CrytekSphere, 16, Pass::Box) },
    { "PositionSphere (OGLdev 45)", "128 points, centred box",
      NewPass(Pass::PositionSphere, 128, Pass::BoxCentered) },
    { "DepthSphere (OGLdev 46)", "128 points, centred box",
      NewPass(Pass::DepthSphere, 128, Pass::BoxCentered) },
    { "Hemisphere (LearnOpenGL)", "64 points, box", NewPass(Pass::Hemisphere, 64, Pass::Box) },
    { "HemisphereLinearDepth (older LearnOpenGL)", "64 points, box",
      NewPass(Pass::HemisphereLinearDepth, 64, Pass::Box) },
    { "ReflectedHemisphere (Unity)", "14 points, Gaussian",
      NewPass(Pass::ReflectedHemisphere, 14, Pass::SeparableGaussian) },
    { "HorizonAngle (HBAO)", "6 x 4 samples, Gaussian",
      NewPass(Pass::HorizonAngle, 24, Pass::SeparableGaussian) },
    { "Hemisphere, edge-aware", "32 points", NewPass(Pass::Hemisphere, 32, Pass::EdgeAware) },
    { "Fast: ExactHorizon", "1 slice of 16, a quarter of the pixels",
      NewPreset(&Pass::SetQualityToFast) },
    { "Balanced, the default: LayeredBitmask", "1 slice of 20, a quarter of the pixels",
      NewPreset(&Pass::SetQualityToBalanced) },
  };
}

//------------------------------------------------------------------------------ pictures

/// False where tracing failed.
bool Trace(vtkRenderer* renderer, const int size[2], double radius, vtkSSAOTruthImage& truth)
{
  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  const vtkSSAOTruthCamera camera(renderer->GetActiveCamera(), size[0], size[1], scene.GetOrigin());
  vtkSSAOTruthTracer tracer;
  tracer.SetRadius(radius);
  return tracer.Trace(scene, camera, truth);
}

/// VTK's pass multiplies the finished colour: a white scene without shading shows the visibility.
void MakeWhite(vtkRenderer* renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetMapper()->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
    actor->GetProperty()->SetSpecular(0.0);
  }
}

/// Draws a white scene with a pass. Empty if there is no picture.
Visibility Draw(vtkRenderWindow* window, vtkRenderer* renderer, vtkImageProcessingPass* pass)
{
  renderer->SetPass(pass);
  window->Render();
  Visibility visibility;
  if (auto* ours = Pass::SafeDownCast(pass))
  {
    vtkNew<vtkImageData> image;
    if (ours->GetVisibility(image))
    {
      const auto* first = static_cast<const float*>(image->GetScalarPointer());
      visibility.assign(first, first + image->GetNumberOfPoints());
    }
  }
  else
  {
    const int* size = window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, /*front=*/0, pixels);
    for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
    {
      visibility.push_back(static_cast<float>(pixels->GetTypedComponent(i, 0)) / 255.0F);
    }
  }
  renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(window);
  return visibility;
}

//------------------------------------------------------------------------------ sheet

/// Grey pictures in rows, each with lines of text below, on white.
class Sheet
{
public:
  Sheet(int columns, int rows, const int cell[2])
    : Columns(columns)
    , Cell{ cell[0], cell[1] }
  {
    this->Image->SetDimensions(
      columns * (cell[0] + Gap) + Gap, rows * (cell[1] + Gap + CaptionHeight) + Gap, 1);
    this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::memset(this->Image->GetScalarPointer(), 255, this->Image->GetNumberOfPoints());
  }

  void Add(const Visibility& picture, const std::vector<std::string>& lines)
  {
    const int* size = this->Image->GetDimensions();
    const int left = Gap + this->Used % this->Columns * (this->Cell[0] + Gap);
    const int bottom = size[1] -
      (this->Used / this->Columns + 1) * (this->Cell[1] + Gap + CaptionHeight) + CaptionHeight;
    ++this->Used;
    for (int y = -1; y <= this->Cell[1]; ++y)
    {
      for (int x = -1; x <= this->Cell[0]; ++x)
      {
        const bool inside = x >= 0 && y >= 0 && x < this->Cell[0] && y < this->Cell[1];
        const double grey = inside ? picture[y * this->Cell[0] + x] : 0.6; // a frame
        this->At(left + x, bottom + y) =
          static_cast<unsigned char>(std::lround(255.0 * std::clamp(grey, 0.0, 1.0)));
      }
    }
    for (size_t i = 0; i < lines.size(); ++i)
    {
      this->Write(lines[i], left, bottom - 6 - LineHeight * (static_cast<int>(i) + 1), i == 0);
    }
  }

  vtkImageData* GetImage() { return this->Image; }

private:
  unsigned char& At(int x, int y)
  {
    return *static_cast<unsigned char*>(this->Image->GetScalarPointer(x, y, 0));
  }

  /// In the middle of a cell's width, and no wider than that.
  void Write(const std::string& text, int left, int bottom, bool bold)
  {
    vtkNew<vtkTextProperty> font;
    font->SetColor(0.0, 0.0, 0.0);
    font->SetBold(bold);
    vtkNew<vtkImageData> drawn;
    int extent[2] = { 0, 0 };
    int fontSize = 15;
    do
    {
      font->SetFontSize(fontSize);
      if (!vtkTextRenderer::GetInstance() ||
        !vtkTextRenderer::GetInstance()->RenderString(font, text, drawn, extent, 72))
      {
        return;
      }
    } while (extent[0] > this->Cell[0] && --fontSize > 8);
    left += std::max(0, (this->Cell[0] - extent[0]) / 2);
    for (int y = 0; y < std::min(extent[1], LineHeight); ++y)
    {
      for (int x = 0; x < std::min(extent[0], this->Cell[0]); ++x)
      {
        const double cover = drawn->GetScalarComponentAsDouble(
          drawn->GetExtent()[0] + x, drawn->GetExtent()[2] + y, 0, 3);
        this->At(left + x, bottom + y) = static_cast<unsigned char>(255.0 - cover);
      }
    }
  }

  vtkNew<vtkImageData> Image;
  int Columns;
  int Cell[2];
  int Used = 0;
};

int Fail(const std::string& what)
{
  std::cerr << "CompareSystems: error: " << what << "\n";
  return EXIT_FAILURE;
}
}

int main(int argc, char* argv[])
{
  const std::string fileName = argc > 1 ? argv[1] : "compare_systems.png";
  const std::string sceneName = argc > 2 ? argv[2] : "corner_room";
  const std::vector<System> systems = Systems();
  const int columns = static_cast<int>(std::ceil(std::sqrt(systems.size() + 1.0)));
  const int rows = (static_cast<int>(systems.size()) + columns) / columns;
  const int width = (SheetWidth - Gap) / columns - Gap;
  const int size[2] = { width, width * 3 / 4 };

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  std::string error;
  if (!vtkSSAOScenes::Build(sceneName, 0, renderer, argc > 3 ? argv[3] : "data", &error))
  {
    error += " Scenes:";
    for (const std::string& name : vtkSSAOScenes::Names())
    {
      error += " " + name;
    }
    return Fail(error);
  }
  const double radius = vtkSSAOScenes::GetInfo(sceneName).Radius;
  renderer->ResetCameraClippingRange();

  vtkSSAOTruthImage truth;
  if (!Trace(renderer, size, radius, truth))
  {
    return Fail("the truth could not be traced");
  }
  Sheet sheet(columns, rows, size);
  sheet.Add(truth.Visibility,
    { "truth", "ray-traced, 256 rays", vtkSSAOScenes::GetInfo(sceneName).Description });
  MakeWhite(renderer);
  for (const System& system : systems)
  {
    const Visibility visibility = Draw(window, renderer, system.NewPass(radius));
    if (visibility.size() != truth.Visibility.size())
    {
      return Fail("no picture of " + system.Name);
    }
    vtkSSAOImageError difference;
    difference.Compare(visibility, truth);
    char text[32];
    std::snprintf(text, sizeof(text), "RMSE %.3f", difference.GetRootMeanSquare());
    sheet.Add(visibility, { system.Name, system.Settings, text });
    std::cout << system.Name << ", " << system.Settings << ": " << text << "\n";
  }

  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(sheet.GetImage());
  writer->SetFileName(fileName.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
