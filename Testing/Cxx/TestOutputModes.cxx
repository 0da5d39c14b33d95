// SPDX-License-Identifier: BSD-3-Clause

// What the output modes show, and that strength and modulation do not change it.

#include "vtkSSAOTestEverything.h"

#include "vtkMatrix4x4.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// A floor with a sphere on it and, in front of it, everything that is no lit surface.
void BuildScene(Stage& stage)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.5);
  floor->SetPoint1(6.0, -1.0, -0.5);
  floor->SetPoint2(-1.0, 4.0, -0.5);
  floor->Update();
  stage.Renderer->AddActor(MakeActor(floor->GetOutput()));
  for (int i = 0; i < 6; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5));
    sphere->SetPosition(i, 3.0, -0.2);
    stage.Renderer->AddActor(sphere);
  }
}

//------------------------------------------------------------------------------
// Occlusion: grey, open where no lit surface is, whatever is drawn there.
void CheckOcclusion(Report& report)
{
  Stage stage(report, 200, 150);
  BuildScene(stage);
  Grid grid(6);
  grid.Look(stage.Renderer);
  stage.Camera()->SetFocalPoint(2.5, 1.2, 0.0);
  stage.Camera()->SetPosition(2.7, -0.3, 14.0);
  stage.Camera()->SetViewAngle(28.0);
  stage.Camera()->SetClippingRange(8.0, 20.0);

  vtkNew<AOPass> pass;
  pass->SetRadius(0.8);
  pass->SetOutputModeToOcclusion();
  const Picture alone = stage.Draw(pass);
  const Picture grey = [&]
  {
    Picture result = alone;
    for (std::size_t i = 0; i < result.Values.size(); ++i)
    {
      result.Values[i] = alone.Values[i - i % 3];
    }
    return result;
  }();
  const Picture white = Picture::Of([](float) { return 1.0; }, alone);
  report.Same("occlusion is grey", grey, alone, 0.0);
  report.Differ("there is occlusion", white, alone, 0.2, 200);

  // Drawn over the floor, away from the spheres' contacts; glass, fog and text write no depth.
  AddTranslucentProps(stage.Renderer, grid);
  AddVolume(stage.Renderer, grid);
  AddAnnotations(stage.Renderer, grid);
  report.Same("occlusion, translucent props, volumes and text", alone, stage.Draw(pass), 0.0);

  // Opaque props without light hide surfaces, but are themselves open; what they hide of the floor
  // may open its neighbourhood.
  vtkSmartPointer<vtkActor> unlit = MakeActor(MakeSphere(0.3));
  unlit->SetPosition(3.0, 1.5, 0.5);
  unlit->GetProperty()->LightingOff();
  stage.Renderer->AddActor(unlit);
  Grid rest(6);
  AddUnlitProps(stage.Renderer, rest);
  stage.Renderer->SetPass(nullptr);
  vtkNew<AOPass> unoccluded;
  unoccluded->SetOutputModeToUnoccluded();
  const Picture plain = stage.Draw(nullptr);
  pass->SetOutputModeToDepth();
  const Picture depth = stage.Draw(pass);
  pass->SetOutputModeToOcclusion();
  const Picture occlusion = stage.Draw(pass);
  report.Same(
    "occlusion where there is no lit surface", white, occlusion, 0.0,
    [&](int x, int y) { return depth.At(x, y)[0] >= 1.0F; }, 3000);
  report.Same("unoccluded is the plain picture", plain, stage.Draw(unoccluded), 0.0);

  // The middle of the unlit sphere has no depth and no normal.
  const double middle[3] = { 3.0, 1.5, 0.5 };
  stage.Renderer->SetWorldPoint(middle[0], middle[1], middle[2], 1.0);
  stage.Renderer->WorldToDisplay();
  const double* display = stage.Renderer->GetDisplayPoint();
  const int x = static_cast<int>(display[0]);
  const int y = static_cast<int>(display[1]);
  report.ExpectEqual(depth.At(x, y)[0], 1.0, "depth of an unlit sphere");
  pass->SetOutputModeToNormal();
  report.ExpectEqual(stage.Draw(pass).At(x, y)[2], 0.0, "normal of an unlit sphere");
}

//------------------------------------------------------------------------------
// Nothing without light, and no line, counts as a surface.
void CheckNoSurfaces(Report& report)
{
  Stage stage(report, 150, 100);
  Grid grid(4);
  AddUnlitProps(stage.Renderer, grid);
  AddTranslucentProps(stage.Renderer, grid);
  AddAnnotations(stage.Renderer, grid);
  AddVolume(stage.Renderer, grid);
  grid.Look(stage.Renderer);
  vtkNew<AOPass> pass;
  for (const int mode : { AOPass::Occlusion, AOPass::Depth, AOPass::Normal })
  {
    pass->SetOutputMode(mode);
    const Picture actual = stage.Draw(pass);
    const Picture expected =
      Picture::Of([=](float) { return mode == AOPass::Normal ? 0.0 : 1.0; }, actual);
    report.Same("no surfaces, mode " + std::to_string(mode), expected, actual, 0.0);
  }
  pass->SetOutputModeToComposite();
  pass->SetModulationToAll();
  ForceVisibility(pass, 0.0);
  const Picture plain = stage.Draw(nullptr);
  report.Same("no surfaces, V 0", plain, stage.Draw(pass), 0.0);
}

//------------------------------------------------------------------------------
// No control of strength changes visibility, normals and depth.
void CheckIndependence(Report& report)
{
  Stage stage(report, 120, 90);
  BuildScene(stage);
  Grid(6).Look(stage.Renderer);
  stage.Camera()->SetFocalPoint(2.5, 2.5, 0.0);
  stage.Camera()->SetPosition(2.5, 1.0, 12.0);
  stage.Camera()->SetClippingRange(8.0, 16.0);
  for (const int mode : { AOPass::Occlusion, AOPass::Unoccluded, AOPass::Normal, AOPass::Depth })
  {
    vtkNew<AOPass> pass;
    pass->SetRadius(0.8);
    pass->SetOutputMode(mode);
    const Picture expected = stage.Draw(pass);
    pass->SetModulationToAll();
    pass->SetIntensity(0.0);
    report.Same("mode " + std::to_string(mode) + ", Intensity 0", expected, stage.Draw(pass), 0.0);
    pass->SetModulationToAmbient();
    pass->SetIntensity(3.0);
    pass->SetPower(4.0);
    ForceVisibility(pass, 0.3);
    report.Same("mode " + std::to_string(mode) + ", strong", expected, stage.Draw(pass), 0.0);
  }
}

//------------------------------------------------------------------------------
// A plane of a known slope: its normal and its depth at every pixel.
void CheckPlane(Report& report, bool parallel)
{
  Stage stage(report, 90, 70);
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-20.0, -20.0, 0.0);
  source->SetPoint1(20.0, -20.0, 0.0);
  source->SetPoint2(-20.0, 20.0, 0.0);
  source->Update();
  vtkSmartPointer<vtkActor> plane = MakeActor(source->GetOutput());
  plane->RotateX(-40.0);
  plane->RotateY(25.0);
  stage.Renderer->AddActor(plane);
  const double distance = 4.0;
  const double low = 1.0;
  const double high = 20.0;
  const double angle = 40.0;
  const double scale = 1.5;
  stage.Camera()->SetPosition(0.0, 0.0, distance);
  stage.Camera()->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Camera()->SetViewAngle(angle);
  stage.Camera()->SetParallelProjection(parallel);
  stage.Camera()->SetParallelScale(scale);
  stage.Camera()->SetClippingRange(low, high);

  double normal[4] = { 0.0, 0.0, 1.0, 0.0 };
  plane->GetMatrix()->MultiplyPoint(normal, normal);
  vtkNew<AOPass> pass;
  pass->SetOutputModeToNormal();
  const Picture normals = stage.Draw(pass);
  pass->SetOutputModeToDepth();
  const Picture depths = stage.Draw(pass);
  Picture expectedNormals = normals;
  Picture expectedDepths = depths;
  for (int y = 0; y < normals.Height; ++y)
  {
    for (int x = 0; x < normals.Width; ++x)
    {
      // The ray eye + t direction meets normal . p = 0; the eye looks along -z.
      const double half = parallel ? scale : std::tan(0.5 * angle * std::atan(1.0) / 45.0);
      const double u = half * (2.0 * (x + 0.5) - normals.Width) / normals.Height;
      const double v = half * (2.0 * (y + 0.5) - normals.Height) / normals.Height;
      const double eye = normal[2] * distance;
      const double depth = parallel ? (u * normal[0] + v * normal[1] + eye) / normal[2]
                                    : -eye / (u * normal[0] + v * normal[1] - normal[2]);
      for (int i = 0; i < 3; ++i)
      {
        expectedNormals.At(x, y)[i] = static_cast<float>(0.5 * normal[i] + 0.5);
        expectedDepths.At(x, y)[i] =
          static_cast<float>(std::min((depth - low) / (high - low), 1.0));
      }
    }
  }
  const std::string name = parallel ? "plane, parallel, " : "plane, perspective, ";
  // Half a step of the picture, and the 12 bits of a packed normal.
  report.Same(name + "normal", expectedNormals, normals, 0.6 * Step);
  report.Same(name + "depth", expectedDepths, depths, 0.6 * Step);
}

//------------------------------------------------------------------------------
// A fine sphere in parallel projection, whose normal is its position; and the same wound inside
// out, which must face the viewer all the same.
void CheckSphere(Report& report)
{
  Stage stage(report, 80, 80);
  vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(1.0, 200));
  stage.Renderer->AddActor(sphere);
  stage.Camera()->SetPosition(0.0, 0.0, 5.0);
  stage.Camera()->SetParallelProjection(1);
  stage.Camera()->SetParallelScale(1.1);
  stage.Camera()->SetClippingRange(3.0, 7.0);
  vtkNew<AOPass> pass;
  pass->SetOutputModeToNormal();
  const Picture normals = stage.Draw(pass);
  Picture expected = normals;
  std::vector<bool> inside(normals.Values.size() / 3, false);
  for (int y = 0; y < normals.Height; ++y)
  {
    for (int x = 0; x < normals.Width; ++x)
    {
      const double u = 1.1 * (2.0 * (x + 0.5) / normals.Width - 1.0);
      const double v = 1.1 * (2.0 * (y + 0.5) / normals.Height - 1.0);
      const double z = 1.0 - u * u - v * v;
      // Within the triangles' deviation from the sphere's rim the normal is not known.
      inside[y * normals.Width + x] = z > 0.1;
      expected.At(x, y)[0] = static_cast<float>(z > 0.0 ? 0.5 * u + 0.5 : 0.0);
      expected.At(x, y)[1] = static_cast<float>(z > 0.0 ? 0.5 * v + 0.5 : 0.0);
      expected.At(x, y)[2] = static_cast<float>(z > 0.0 ? 0.5 * std::sqrt(z) + 0.5 : 0.0);
    }
  }
  const Mask within = [&](int x, int y) { return bool(inside[y * normals.Width + x]); };
  // Half a step of the picture, the 12 bits of a packed normal, and interpolation over 1.8 degrees.
  report.Same("sphere, normal", expected, normals, 0.8 * Step, within, 2000);
  report.Same(
    "sphere, no normal in the background", Picture::Of([](float) { return 0.0; }, normals), normals,
    0.0, [](int x, int y) { return std::hypot(x - 39.5, y - 39.5) > 38.0; }, 1000);

  // Mirrored, so that every triangle is wound the other way.
  sphere->SetScale(-1.0, 1.0, 1.0);
  report.Same("sphere inside out, normal", expected, stage.Draw(pass), 0.8 * Step, within, 2000);
}
}

//------------------------------------------------------------------------------
int TestOutputModes(int, char*[])
{
  Report report;
  CheckOcclusion(report);
  CheckNoSurfaces(report);
  CheckIndependence(report);
  CheckPlane(report, false);
  CheckPlane(report, true);
  CheckSphere(report);
  return report.GetResult();
}
