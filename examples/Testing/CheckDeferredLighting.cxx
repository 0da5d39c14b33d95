// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers of the example DeferredLighting. CheckDeferredLighting terms
 *   compares the terms of the light with hand values, and with VTK's own light on a ball.
 * CheckDeferredLighting pictures FOLDER times-albedo|without-albedo
 *   compares the pictures that the example wrote with each other.
 */
#include "../DeferredLighting/GeometryBuffer.h"
#include "../DeferredLighting/Lighting.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
using namespace deferred;
int Failures = 0;

void Expect(bool good, const std::string& what)
{
  std::cout << (good ? "ok: " : "FAILED: ") << what << "\n";
  Failures += good ? 0 : 1;
}

void ExpectNear(double value, double wanted, double tolerance, const std::string& what)
{
  Expect(std::abs(value - wanted) <= tolerance,
    what + ": " + std::to_string(value) + ", wanted " + std::to_string(wanted));
}

/// Light, viewer and normal in one line, then the light to the side.
void CheckHandValues()
{
  Surface surface;
  surface.Position = vtkVector3d(0.0, 0.0, -2.0);
  surface.Normal = vtkVector3d(0.0, 0.0, 1.0);
  surface.Albedo = vtkVector3d(0.5, 0.2, 1.0);
  surface.Visibility = 0.4;
  PointLight light;
  light.Position = vtkVector3d(0.0, 0.0, 0.0);
  light.Color = vtkVector3d(1.0, 0.5, 0.25);
  light.Linear = 0.25;
  light.Quadratic = 0.125;
  const double exact = 1e-12;
  const vtkVector3d ambient = AmbientTerm(surface, AmbientLight::TimesAlbedo);
  ExpectNear(ambient[0], 0.06, exact, "ambient, red: 0.3 x 0.5 x 0.4");
  ExpectNear(ambient[2], 0.12, exact, "ambient, blue: 0.3 x 1 x 0.4");
  ExpectNear(AmbientTerm(surface, AmbientLight::WithoutAlbedo)[0], 0.12, exact,
    "ambient without albedo: 0.3 x 0.4");
  // 1 + 0.25 x 2 + 0.125 x 4 = 2
  ExpectNear(DiffuseTerm(surface, light)[0], 0.25, exact, "diffuse, red: 0.5 x 1 / 2");
  ExpectNear(DiffuseTerm(surface, light)[1], 0.05, exact, "diffuse, green: 0.2 x 0.5 / 2");
  ExpectNear(SpecularTerm(surface, light)[2], 0.125, exact, "specular, blue: 0.25 / 2");

  light.Position = vtkVector3d(2.0, 0.0, -2.0); // in the plane of the surface
  ExpectNear(DiffuseTerm(surface, light)[0], 0.0, exact, "diffuse of a light at the horizon");
  // Halfway at 45 degrees: cos^8 = 1/16, at the same distance as before.
  ExpectNear(SpecularTerm(surface, light)[0], 0.03125, exact, "specular at 45 degrees: 1/16/2");
  surface.Visibility = 0.0;
  ExpectNear(SpecularTerm(surface, light)[0], 0.03125, exact, "specular where V is 0");
}

/// The diffuse term of a VTK light with the same attenuation is the same, pixel by pixel: so the
/// positions and normals are right.
void CheckAgainstVTK()
{
  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(128);
  ball->SetPhiResolution(128);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.6, 0.3);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(2.0, -1.5, 1.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.1, 0.2, 0.0); // not in the middle of the picture
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(320, 200);
  window->AddRenderer(renderer);
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> pass;
  renderer->SetPass(pass);
  const GeometryBuffer buffer = Capture(window, renderer, pass);

  double place[4] = { 0.3, -1.2, 0.9, 1.0 };
  vtkNew<vtkLight> theirs;
  theirs->SetLightTypeToSceneLight();
  theirs->PositionalOn();
  theirs->SetConeAngle(180.0); // to all sides
  theirs->SetPosition(place);
  theirs->SetAttenuationValues(1.0, 0.3, 0.2);
  theirs->SetColor(1.0, 0.9, 0.8);
  renderer->RemoveAllLights();
  renderer->AddLight(theirs);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  renderer->SetPass(nullptr);
  window->Render();
  vtkNew<vtkUnsignedCharArray> picture;
  window->GetPixelData(0, 0, buffer.Width - 1, buffer.Height - 1, /*front=*/0, picture);

  PointLight ours;
  renderer->GetActiveCamera()->GetViewTransformMatrix()->MultiplyPoint(place, place);
  ours.Position = vtkVector3d(place);
  ours.Color = vtkVector3d(1.0, 0.9, 0.8);
  ours.Linear = 0.3;
  ours.Quadratic = 0.2;
  double largest = 0.0;
  int lit = 0;
  for (size_t i = 0; i < buffer.Pixels.size(); ++i)
  {
    const vtkVector3d color = DiffuseTerm(buffer.Pixels[i], ours);
    for (int c = 0; buffer.Pixels[i].Seen && c < 3; ++c)
    {
      const double wanted = picture->GetTypedComponent(static_cast<vtkIdType>(i), c);
      largest = std::max(largest, std::abs(255.0 * color[c] - wanted));
      lit += wanted > 20.0 ? 1 : 0;
    }
  }
  Expect(lit > 10000, "the ball is in the light: " + std::to_string(lit) + " values");
  // One level for rounding, and a little for normals kept in 16 bits.
  ExpectNear(largest, 0.0, 1.5, "largest difference from VTK's light, in 1/255");
}

vtkSmartPointer<vtkImageData> Read(const std::string& fileName)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}

void CheckPictures(const std::string& folder, bool timesAlbedo)
{
  const auto read = [&](const char* name) { return Read(folder + "/deferred_" + name + ".png"); };
  const vtkSmartPointer<vtkImageData> albedo = read("1_albedo");
  const vtkSmartPointer<vtkImageData> visibility = read("2_visibility");
  const vtkSmartPointer<vtkImageData> ambient = read("3_ambient");
  const vtkSmartPointer<vtkImageData> without = read("4_without");
  const vtkSmartPointer<vtkImageData> with = read("5_with");
  const vtkIdType values = 3 * albedo->GetNumberOfPoints();
  const auto at = [](vtkImageData* image, vtkIdType i)
  { return static_cast<int>(static_cast<unsigned char*>(image->GetScalarPointer())[i]); };

  double ambientError = 0.0;
  double openError = 0.0;
  double differenceError = 0.0;
  int open = 0;
  int darkened = 0;
  for (vtkIdType i = 0; i < values; ++i)
  {
    if (at(ambient, i) == 255) // the background; 0.3 is the most that a surface has
    {
      continue;
    }
    const double v = at(visibility, i) / 255.0;
    const double light = 0.3 * (timesAlbedo ? at(albedo, i) : 255.0);
    ambientError = std::max(ambientError, std::abs(at(ambient, i) - light * v));
    const double taken = at(without, i) - at(with, i);
    if (v == 1.0)
    {
      openError = std::max(openError, std::abs(taken));
      ++open;
    }
    if (at(without, i) < 255)
    {
      differenceError = std::max(differenceError, std::abs(taken - light * (1.0 - v)));
      darkened += taken > 10.0 ? 1 : 0;
    }
  }
  Expect(open > 10000 && darkened > 10000,
    std::to_string(open) + " values where V is 1, " + std::to_string(darkened) + " darkened");
  ExpectNear(ambientError, 0.0, 1.0, "ambient term against 0.3 x albedo x V, in 1/255");
  // V is rounded to 1 from 254.5 / 255 on, which may be one level of the picture.
  ExpectNear(openError, 0.0, 1.0, "with against without where V is 1, in 1/255");
  // Both pictures are rounded, and V.
  ExpectNear(differenceError, 0.0, 1.2, "what is taken against 0.3 x albedo x (1 - V), in 1/255");
}
}

int main(int argc, char* argv[])
{
  if (argc == 2 && argv[1] == std::string("terms"))
  {
    CheckHandValues();
    CheckAgainstVTK();
  }
  else if (argc == 4 && argv[1] == std::string("pictures"))
  {
    CheckPictures(argv[2], argv[3] == std::string("times-albedo"));
  }
  else
  {
    Expect(false, "arguments");
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
