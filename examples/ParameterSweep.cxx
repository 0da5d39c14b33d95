// SPDX-License-Identifier: BSD-3-Clause
/**
 * What each parameter does: one scene, one parameter per row, one value per picture, all in one
 * window with a viewport and a pass each. There are three sheets: picture (what is shown and how
 * dark), samples (how visibility is estimated, by the estimators of the presets), sources (what the
 * other estimators have). ParameterSweep [sheet [picture.png [mesh.vtp]]]
 */
#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;
const int Columns = 5;
const int CellSize[2] = { 200, 150 }; // pixels

struct Cell
{
  std::string Label;
  std::function<void(Pass*)> Set;
};
using Row = std::vector<Cell>;

/// A cell for each value. What all of them have is set first.
Row Sweep(const std::string& name, const std::function<void(Pass*)>& prepare,
  const std::vector<double>& values, const std::function<void(Pass*, double)>& set)
{
  Row row;
  for (double value : values)
  {
    std::ostringstream label;
    label << (row.empty() ? name + " " : "") << value;
    row.push_back({ label.str(),
      [=](Pass* pass)
      {
        prepare(pass);
        set(pass, value);
      } });
  }
  return row;
}

/// What is shown, and how dark it is.
std::vector<Row> PictureRows(double diagonal)
{
  const auto asItIs = [](Pass*) {};
  const auto modulation = [](int type) { return [=](Pass* pass) { pass->SetModulation(type); }; };
  const auto mode = [](int type) { return [=](Pass* pass) { pass->SetOutputMode(type); }; };
  const auto quality = [](void (Pass::*set)())
  {
    return [=](Pass* pass)
    {
      pass->SetOutputModeToOcclusion();
      (pass->*set)();
    };
  };
  return {
    { { "output mode composite", mode(Pass::Composite) }, { "unoccluded", mode(Pass::Unoccluded) },
      { "occlusion", mode(Pass::Occlusion) }, { "normal", mode(Pass::Normal) },
      { "depth", mode(Pass::Depth) } },
    Sweep("radius / diagonal", asItIs, { 0.02, 0.05, 0.1, 0.2, 0.4 },
      [=](Pass* pass, double share) { pass->SetRadius(share * diagonal); }),
    { { "quality fast", quality(&Pass::SetQualityToFast) },
      { "balanced", quality(&Pass::SetQualityToBalanced) },
      { "accurate", quality(&Pass::SetQualityToAccurate) } },
    { { "modulation ambient", modulation(Pass::Ambient) },
      { "ambient and diffuse", modulation(Pass::AmbientAndDiffuse) },
      { "all", modulation(Pass::All) } },
    Sweep("intensity", asItIs, { 0.0, 0.5, 1.0, 2.0, 4.0 },
      [](Pass* pass, double value) { pass->SetIntensity(value); }),
    Sweep("power", asItIs, { 0.5, 1.0, 2.0, 4.0, 8.0 },
      [](Pass* pass, double value) { pass->SetPower(value); }),
    Sweep("intensity scale", asItIs, { 0.0, 0.5, 1.0, 2.0, 4.0 },
      [](Pass* pass, double value) { pass->SetIntensityScale(value); }),
    Sweep("intensity shift", asItIs, { -0.4, -0.2, 0.0, 0.2, 0.4 },
      [](Pass* pass, double value) { pass->SetIntensityShift(value); }),
  };
}

void ShowOcclusion(Pass* pass)
{
  pass->SetOutputModeToOcclusion();
}

void ShowNoise(Pass* pass)
{
  pass->SetOutputModeToOcclusion();
  pass->SetDenoiserToNone();
}

/// How visibility is estimated, alone and with its noise where that matters.
std::vector<Row> SampleRows(double diagonal)
{
  const auto denoiser = [](int type)
  {
    return [=](Pass* pass)
    {
      ShowOcclusion(pass);
      pass->SetDenoiser(type);
    };
  };
  return {
    Sweep("directions", ShowNoise, { 1, 2, 4, 8, 16 },
      [](Pass* pass, double value) { pass->SetDirections(static_cast<int>(value)); }),
    Sweep("steps", ShowNoise, { 1, 2, 4, 8, 16 },
      [](Pass* pass, double value) { pass->SetSteps(static_cast<int>(value)); }),
    Sweep("layers", ShowOcclusion, { 1, 2, 3, 5, 9 },
      [](Pass* pass, double value) { pass->SetLayers(static_cast<int>(value)); }),
    Sweep("thickness / radius", ShowOcclusion, { 0, 0.05, 0.2, 1, 4 },
      [=](Pass* pass, double share) { pass->SetThickness(0.1 * share * diagonal); }),
    Sweep("noise size", ShowNoise, { 1, 2, 4, 8, 16 },
      [](Pass* pass, double value) { pass->SetNoiseSize(static_cast<int>(value)); }),
    { { "denoiser none", denoiser(Pass::None) }, { "box", denoiser(Pass::Box) },
      { "box centred", denoiser(Pass::BoxCentered) },
      { "separable Gaussian", denoiser(Pass::SeparableGaussian) },
      { "edge-aware", denoiser(Pass::EdgeAware) } },
    Sweep("downsampling", ShowOcclusion, { 1, 2, 3, 4 },
      [](Pass* pass, double value) { pass->SetDownsampling(static_cast<int>(value)); }),
    Sweep("layer downsampling", ShowOcclusion, { 1, 2, 3, 4 },
      [](Pass* pass, double value)
      {
        pass->SetDownsampling(1);
        pass->SetLayerDownsampling(static_cast<int>(value));
      }),
  };
}

/// What the estimators of the sources have.
std::vector<Row> SourceRows(double diagonal)
{
  const auto with = [](int estimator)
  {
    return [=](Pass* pass)
    {
      ShowOcclusion(pass);
      pass->SetEstimator(estimator);
    };
  };
  const auto noise = [](int estimator)
  {
    return [=](Pass* pass)
    {
      ShowNoise(pass);
      pass->SetEstimator(estimator);
    };
  };
  const auto range = [=](int estimator, bool check)
  {
    return [=](Pass* pass)
    {
      with(estimator)(pass);
      pass->SetRangeCheck(check);
    };
  };
  const auto half = [=](bool on)
  {
    return [=](Pass* pass)
    {
      with(Pass::CrytekSphere)(pass);
      pass->SetHalfRule(on);
    };
  };
  const auto falloff = [=](int type)
  {
    return [=](Pass* pass)
    {
      with(Pass::ReflectedHemisphere)(pass);
      pass->SetFalloff(type);
    };
  };
  return {
    Sweep("kernel size", noise(Pass::Hemisphere), { 4, 16, 64, 256, 1024 },
      [](Pass* pass, double value) { pass->SetKernelSize(static_cast<int>(value)); }),
    Sweep("bias / radius", with(Pass::Hemisphere), { 0, 0.01, 0.05, 0.2, 0.5 },
      [=](Pass* pass, double share) { pass->SetBias(0.1 * share * diagonal); }),
    { { "range check off, CrytekSphere", range(Pass::CrytekSphere, false) },
      { "on", range(Pass::CrytekSphere, true) },
      { "off, PositionSphere", range(Pass::PositionSphere, false) },
      { "on", range(Pass::PositionSphere, true) } },
    { { "half rule off, CrytekSphere", half(false) }, { "on", half(true) } },
    Sweep("angle bias, HorizonAngle", with(Pass::HorizonAngle), { 0, 10, 20, 30, 60 },
      [](Pass* pass, double degrees) { pass->SetAngleBias(degrees); }),
    Sweep("min. difference, Reflected...", with(Pass::ReflectedHemisphere),
      { 0, 0.01, 0.1, 0.3, 1 },
      [](Pass* pass, double share) { pass->SetMinimumDifference(share); }),
    { { "falloff power, Reflected...", falloff(Pass::PowerFalloff) },
      { "null square", falloff(Pass::NullSquareFalloff) },
      { "inverse square", falloff(Pass::InverseSquareFalloff) } },
    Sweep("attenuation, Reflected...", with(Pass::ReflectedHemisphere), { 0.1, 0.2, 1, 2, 10 },
      [](Pass* pass, double value) { pass->SetAttenuation(value); }),
  };
}

std::vector<Row> RowsOf(const std::string& sheet, double diagonal)
{
  return sheet == "picture" ? PictureRows(diagonal)
    : sheet == "samples"    ? SampleRows(diagonal)
    : sheet == "sources"    ? SourceRows(diagonal)
                            : std::vector<Row>();
}

/// The mesh of a file, or balls among steps on a floor, beside a fence.
vtkSmartPointer<vtkPolyData> MakeMesh(const char* file)
{
  if (file)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file);
    reader->Update();
    return reader->GetOutput();
  }
  vtkNew<vtkAppendPolyData> scene;
  for (int i = 0; i < 10; ++i)
  {
    vtkNew<vtkCubeSource> step; // ever higher ones, around a corner
    const double x = i < 5 ? 0.0 : i - 4.0;
    const double y = i < 5 ? i : 5.0;
    step->SetBounds(x, x + 1.0, y, y + 1.0, 0.0, 0.3 * (i + 1));
    scene->AddInputConnection(step->GetOutputPort());
    vtkNew<vtkSphereSource> ball; // in rows on the floor
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(48);
    ball->SetRadius(0.25 + 0.05 * i);
    ball->SetCenter(1.8 + 1.5 * (i % 3), 4.3 - 1.4 * (i / 3), 0.25 + 0.05 * i);
    scene->AddInputConnection(ball->GetOutputPort());
    vtkNew<vtkCubeSource> post; // thin, so that light passes behind it
    post->SetBounds(5.6, 5.68, 0.5 * i, 0.5 * i + 0.08, 0.0, 1.5);
    scene->AddInputConnection(post->GetOutputPort());
  }
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(0.0, 6.0, -0.5, 6.0, -0.2, 0.0);
  scene->AddInputConnection(floor->GetOutputPort());
  scene->Update();
  return scene->GetOutput();
}
}

int main(int argc, char* argv[])
{
  const std::string sheet = argc > 1 ? argv[1] : "picture";
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(argc > 3 ? argv[3] : nullptr);
  const std::vector<Row> rows = RowsOf(sheet, mesh->GetLength());
  if (rows.empty() || mesh->GetNumberOfPolys() == 0)
  {
    std::cerr << "ParameterSweep: error: "
              << (rows.empty() ? sheet + " is none of picture, samples, sources"
                               : std::string(argv[3]) + " has no polygons")
              << "\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.8, 0.7);
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->GetProperty()->SetSpecular(0.4);
  actor->GetProperty()->SetSpecularPower(30.0);

  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.4, -1.0, 0.8); // from here the automatic focus is looked at
  camera->SetViewUp(0.0, 0.0, 1.0);

  const auto count = static_cast<int>(rows.size());
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(Columns * CellSize[0], count * CellSize[1]);
  window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> ground; // where a row has no picture
  ground->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(ground);
  vtkNew<vtkRenderer> labels; // over the pictures, because the output modes show nothing else
  labels->SetLayer(1);
  window->AddRenderer(labels);

  for (int i = 0; i < count; ++i)
  {
    for (int column = 0; column < static_cast<int>(rows[i].size()); ++column)
    {
      const Cell& cell = rows[i][column];
      const double left = column;
      const double bottom = count - 1 - i;
      vtkNew<Pass> pass;
      cell.Set(pass);
      vtkNew<vtkRenderer> renderer;
      renderer->SetViewport(
        left / Columns, bottom / count, (left + 1.0) / Columns, (bottom + 1.0) / count);
      renderer->SetBackground(1.0, 1.0, 1.0);
      renderer->AddActor(actor);
      renderer->SetActiveCamera(camera);
      renderer->SetPass(pass);
      window->AddRenderer(renderer);
      if (i == 0 && column == 0)
      {
        renderer->ResetCamera();
        camera->Zoom(1.5);
      }
      vtkNew<vtkTextActor> label;
      label->SetInput(cell.Label.c_str());
      label->SetPosition(left * CellSize[0] + 5.0, (bottom + 1.0) * CellSize[1] - 17.0);
      label->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
      label->GetTextProperty()->SetFontSize(13);
      label->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
      label->GetTextProperty()->SetBackgroundOpacity(0.75);
      labels->AddViewProp(label);
    }
  }

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 2 ? argv[2] : "parameter_sweep.png");
  writer->SetCompressionLevel(9);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
