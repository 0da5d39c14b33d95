// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ambient occlusion in deferred lighting, as in LearnOpenGL's "SSAO": the visibility is a factor of
 * the ambient term of Blinn-Phong, and of nothing else. The buffers come from the pass; the formula
 * is in DeferredLighting/Lighting.cxx and runs on the CPU, pixel by pixel, to be read.
 * DeferredLighting [--ambient-without-albedo] [mesh.vtp [folder]]
 */
#include "DeferredLighting/GeometryBuffer.h"
#include "DeferredLighting/Lighting.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkSphereSource.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace deferred;

/// Adds an actor whose colour is drawn as it is: the albedo.
void AddAlbedo(vtkRenderer* renderer, vtkAlgorithm* source, const vtkVector3d& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  actor->GetProperty()->SetSpecular(0.0);
  renderer->AddActor(actor);
}

void AddBox(
  vtkRenderer* renderer, const vtkVector3d& low, const vtkVector3d& high, const vtkVector3d& color)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
  AddAlbedo(renderer, box, color);
}

void AddBall(
  vtkRenderer* renderer, const vtkVector3d& center, double radius, const vtkVector3d& color)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  ball->SetCenter(center[0], center[1], center[2]);
  ball->SetRadius(radius);
  AddAlbedo(renderer, ball, color);
}

/// A corner of a room with boxes and balls in it.
void AddRoom(vtkRenderer* renderer)
{
  const vtkVector3d wall(0.9, 0.88, 0.84);
  AddBox(renderer, { 0.0, 0.0, -0.2 }, { 8.0, 6.0, 0.0 }, { 0.75, 0.6, 0.45 });
  AddBox(renderer, { -0.2, 0.0, -0.2 }, { 0.0, 6.2, 4.0 }, wall);
  AddBox(renderer, { -0.2, 6.0, -0.2 }, { 8.0, 6.2, 4.0 }, wall);
  AddBox(renderer, { 0.4, 3.2, 0.0 }, { 1.9, 5.8, 1.6 }, { 0.45, 0.6, 0.75 });
  AddBox(renderer, { 0.6, 3.6, 1.6 }, { 1.6, 4.8, 2.3 }, { 0.8, 0.45, 0.4 });
  AddBox(renderer, { 4.8, 4.6, 0.0 }, { 7.4, 5.9, 0.7 }, { 0.5, 0.7, 0.5 });
  for (int i = 0; i < 5; ++i)
  {
    AddBall(renderer, { 2.6 + 1.1 * i, 3.9 - 0.5 * (i % 2), 0.5 }, 0.5, { 0.9, 0.75, 0.35 });
  }
  AddBall(renderer, { 3.5, 5.0, 1.0 }, 1.0, { 0.7, 0.72, 0.75 });
}

/// False, with a message, if there is nothing to draw.
bool AddScene(vtkRenderer* renderer, const std::string& file)
{
  renderer->GetActiveCamera()->SetPosition(0.5, -1.0, 0.6);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  if (file.empty())
  {
    AddRoom(renderer);
    renderer->ResetCamera();
    renderer->GetActiveCamera()->Zoom(1.2);
    return true;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    std::cerr << "DeferredLighting: error: " << file << " has no polygons\n";
    return false;
  }
  AddAlbedo(renderer, reader, { 0.85, 0.83, 0.8 });
  renderer->ResetCamera();
  return true;
}

/// LearnOpenGL's light, in a scene as large as a room of 10 units: above, and to the right.
PointLight MakeLight(vtkRenderer* renderer, double unit)
{
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  double place[4] = { 0.5 * (bounds[0] + bounds[1]) + unit, 0.5 * (bounds[2] + bounds[3]) - unit,
    bounds[5], 1.0 };
  renderer->GetActiveCamera()->GetViewTransformMatrix()->MultiplyPoint(place, place);
  PointLight light;
  light.Position = vtkVector3d(place);
  light.Color = vtkVector3d(0.9, 0.86, 0.8);
  light.Linear = 0.09 / unit;
  light.Quadratic = 0.032 / (unit * unit);
  return light;
}

/// Writes a picture whose colours are computed pixel by pixel.
bool WritePicture(const std::string& fileName, const GeometryBuffer& buffer,
  const std::function<vtkVector3d(const Surface&)>& colorOf)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(buffer.Width, buffer.Height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (const Surface& surface : buffer.Pixels)
  {
    const vtkVector3d color = colorOf(surface);
    for (int c = 0; c < 3; ++c)
    {
      *pixel++ = static_cast<unsigned char>(std::lround(255.0 * std::clamp(color[c], 0.0, 1.0)));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

bool WritePictures(const std::string& folder, const GeometryBuffer& buffer, const PointLight& light,
  AmbientLight ambient)
{
  const auto lit = [&](Surface surface, bool occluded)
  {
    surface.Visibility = occluded ? surface.Visibility : 1.0;
    return AmbientTerm(surface, ambient) + DiffuseTerm(surface, light) +
      SpecularTerm(surface, light);
  };
  const std::pair<const char*, std::function<vtkVector3d(const Surface&)>> pictures[] = {
    { "1_albedo", [](const Surface& surface) { return surface.Albedo; } },
    { "2_visibility",
      [](const Surface& surface) { return vtkVector3d(1.0, 1.0, 1.0) * surface.Visibility; } },
    { "3_ambient", [=](const Surface& surface) { return AmbientTerm(surface, ambient); } },
    { "4_without", [=](const Surface& surface) { return lit(surface, false); } },
    { "5_with", [=](const Surface& surface) { return lit(surface, true); } },
  };
  bool written = true;
  for (const auto& picture : pictures)
  {
    const auto colorOrBackground = [&picture](const Surface& surface)
    { return surface.Seen ? picture.second(surface) : surface.Albedo; };
    written = written &&
      WritePicture(folder + "/deferred_" + picture.first + ".png", buffer, colorOrBackground);
  }
  return written;
}
}

int main(int argc, char* argv[])
{
  std::vector<std::string> words(argv + 1, argv + argc);
  AmbientLight ambient = AmbientLight::TimesAlbedo;
  if (!words.empty() && words[0] == "--ambient-without-albedo")
  {
    ambient = AmbientLight::WithoutAlbedo;
    words.erase(words.begin());
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  if (!AddScene(renderer, words.empty() ? std::string() : words[0]))
  {
    return EXIT_FAILURE;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  const double unit =
    0.1 * std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);

  vtkNew<vtkScreenSpaceAmbientOcclusionPass> pass; // as the source sets it, but for a larger radius
  pass->SetEstimatorToHemisphere();
  pass->SetKernelSize(64);
  pass->SetRadius(unit);
  pass->SetDenoiserToBox();
  renderer->SetPass(pass);

  const GeometryBuffer buffer = Capture(window, renderer, pass);
  if (buffer.Pixels.empty())
  {
    std::cerr << "DeferredLighting: error: the pass made no buffers\n";
    return EXIT_FAILURE;
  }
  const std::string folder = words.size() > 1 ? words[1] : ".";
  const PointLight light = MakeLight(renderer, unit);
  return WritePictures(folder, buffer, light, ambient) ? EXIT_SUCCESS : EXIT_FAILURE;
}
