// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ray-traced depth and mask against VTK's own z buffer, pixel by pixel.
 *
 * Meshes, strips, an assembly, a composite data set, glyphs and impostors, in perspective and in
 * parallel, straight and off centre, clipped by the near plane. This test renders.
 */

#include "UnitTestTruthCommon.h"

#include "vtkAssembly.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cstdlib>

namespace
{
using namespace TruthTest;

const int Width = 257;
const int Height = 190;

//------------------------------------------------------------------------------
// Returns the actor with the impostors.
vtkSmartPointer<vtkActor> Fill(vtkRenderer* renderer)
{
  AddPolyData(renderer, MakeFloor(3.0, -1.0));

  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(16);
  sphere->SetPhiResolution(12);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(sphere->GetOutputPort());
  stripper->Update();
  AddPolyData(renderer, stripper->GetOutput())->AddPosition(-1.5, 0.5, 0.0);

  vtkNew<vtkConeSource> cone;
  cone->SetResolution(9);
  cone->Update();
  vtkNew<vtkRenderer> pool;
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(AddPolyData(pool, cone->GetOutput()));
  assembly->RotateY(-50.0);
  assembly->SetScale(1.0, 1.5, -1.2);
  assembly->AddPosition(1.4, -0.2, 0.3);
  renderer->AddViewProp(assembly);

  vtkNew<vtkCubeSource> box;
  box->Update();
  vtkSmartPointer<vtkActor> culled = AddPolyData(renderer, box->GetOutput());
  culled->GetProperty()->FrontfaceCullingOn();
  culled->RotateWXYZ(40.0, 1.0, 1.0, 0.0);
  culled->AddPosition(0.1, 1.7, 0.2);

  std::vector<Point> points;
  for (int i = 0; i < 7; ++i)
  {
    points.push_back({ 0.5 * i - 1.5, -0.8 - 0.05 * i * i, 0.2 * (i % 3) - 0.6 });
  }
  vtkSmartPointer<vtkPolyData> data = MakePoints(points);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(data);
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->SetScaleFactor(0.4);
  vtkNew<vtkActor> glyphActor;
  glyphActor->SetMapper(glyphs);
  renderer->AddActor(glyphActor);

  vtkNew<vtkOpenGLSphereMapper> impostors;
  impostors->SetInputData(data);
  impostors->SetRadius(0.2f);
  vtkNew<vtkActor> impostorActor;
  impostorActor->SetMapper(impostors);
  impostorActor->AddPosition(0.2, 0.6, 0.7);
  renderer->AddActor(impostorActor);
  return impostorActor;
}

//------------------------------------------------------------------------------
// Renders and traces one view; compares where both show a surface, and where only one does.
bool CheckView(const std::string& name, vtkRenderer* renderer)
{
  vtkNew<vtkFloatArray> buffer;
  renderer->GetRenderWindow()->Render();
  renderer->GetRenderWindow()->GetZbufferData(0, 0, Width - 1, Height - 1, buffer);

  vtkSSAOTruthScene scene;
  scene.SetTrueSphereGlyphs(false); // the z buffer has their triangles
  scene.Gather(renderer);
  vtkCamera* vtkcamera = renderer->GetActiveCamera();
  const vtkSSAOTruthCamera camera(vtkcamera, Width, Height, scene.GetOrigin());
  vtkSSAOTruthTracer tracer;
  tracer.SetRaysPerPixel(4);
  vtkSSAOTruthImage image;
  if (!tracer.Trace(scene, camera, image) || buffer->GetNumberOfValues() != Width * Height)
  {
    return CheckTrue(name + ": traced and read", false);
  }

  double inverse[16];
  vtkMatrix4x4::Invert(
    vtkcamera->GetProjectionTransformMatrix(static_cast<double>(Width) / Height, -1.0, 1.0)
      ->GetData(),
    inverse);
  int both = 0;
  int onlyOne = 0;
  int different = 0;
  std::vector<double> errors;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const int pixel = y * Width + x;
      const double z = buffer->GetValue(pixel);
      const bool drawn = z < 1.0;
      if (drawn != (image.Hit[pixel] != 0))
      {
        ++onlyOne;
        continue;
      }
      if (!drawn)
      {
        continue;
      }
      ++both;
      const double device[4] = { 2.0 * (x + 0.5) / Width - 1.0, 2.0 * (y + 0.5) / Height - 1.0,
        2.0 * z - 1.0, 1.0 };
      double view[4];
      vtkMatrix4x4::MultiplyPoint(inverse, device, view);
      const double depth = -view[2] / view[3];
      const double error = std::abs(image.Depth[pixel] - depth) / depth;
      different += error > 1e-3 ? 1 : 0; // another surface, or the edge of one
      errors.push_back(error);
    }
  }
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  bool good = CheckTrue(name + ": enough pixels show a surface", both > Width * Height / 4);
  good &= CheckNear(name + ": pixels where one shows a surface and the other none", 0.0, onlyOne,
    1e-3 * Width * Height);
  good &= CheckNear(name + ": pixels of different depth", 0.0, different, 1e-3 * Width * Height);
  good &= CheckNear(name + ": median relative difference of depth", 0.0,
    errors.empty() ? 1.0 : errors[errors.size() / 2], 1e-5);
  return good;
}
}

//------------------------------------------------------------------------------
int UnitTestTruthDepth(int, char*[])
{
  vtkNew<vtkRenderWindow> window;
  if (window->IsA("vtkXOpenGLRenderWindow") && !std::getenv("DISPLAY"))
  {
    std::cout << "skipped: there is neither a headless window nor a display\n";
    return 125; // VTK's tests' return code for "skipped"
  }
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkSmartPointer<vtkActor> impostors = Fill(renderer);

  bool good = true;
  for (int i = 0; i < 6; ++i)
  {
    const bool parallel = i % 2 == 1;
    SetCamera(renderer, parallel, { -1.0, -6.0, 4.0 }, { 0.0, 0.0, 0.0 }, 2.0, 35.0);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetClippingRange(2.0, 15.0);
    std::string name = parallel ? "parallel" : "perspective";
    if (i / 2 == 1)
    {
      name += ", off centre, sheared and through the near plane";
      camera->SetWindowCenter(0.2, -0.1);
      camera->SetViewShear(0.1, 0.05, 1.0);
      camera->SetClippingRange(6.8, 15.0);
      // VTK does not cut impostors at the near plane: it draws them with a depth of 0 there.
      impostors->VisibilityOff();
    }
    else if (i / 2 == 2)
    {
      name += ", mirrored";
      vtkNew<vtkTransform> mirror;
      mirror->Scale(-1.0, 1.0, 1.0);
      camera->SetUserTransform(mirror);
    }
    good &= CheckView(name, renderer);
    impostors->VisibilityOn();
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
