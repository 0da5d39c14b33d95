// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the main parameters do: one scene, one parameter per row, one value per picture, all in
 * one window with a viewport and a pass each. ParameterSweep [mesh.vtp [picture.png]]
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
#include <string>
#include <vector>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;
const int Columns = 4;
const int Rows = 4;
const int CellSize[2] = { 400, 320 }; // pixels

struct Cell
{
  std::string Label;
  std::function<void(Pass*)> Set;
};

/// The sheet, row by row. The second and third row show the occlusion alone, where noise is seen.
std::vector<Cell> MakeCells(double diagonal)
{
  const auto radius = [=](double part)
  { return [=](Pass* pass) { pass->SetRadius(part * diagonal); }; };
  const auto kernel = [](int size)
  {
    return [=](Pass* pass)
    {
      pass->SetKernelSize(size);
      pass->SetDenoiserToNone();
      pass->SetOutputModeToOcclusion();
    };
  };
  const auto denoiser = [](int type)
  {
    return [=](Pass* pass)
    {
      pass->SetKernelSize(16);
      pass->SetDenoiser(type);
      pass->SetOutputModeToOcclusion();
    };
  };
  const auto modulation = [](int type) { return [=](Pass* pass) { pass->SetModulation(type); }; };
  return {
    { "radius 0.02 of diagonal", radius(0.02) },
    { "radius 0.05", radius(0.05) },
    { "radius 0.1 (automatic)", radius(0.1) },
    { "radius 0.2", radius(0.2) },
    { "kernel size 4, no denoiser", kernel(4) },
    { "kernel size 16", kernel(16) },
    { "kernel size 64", kernel(64) },
    { "kernel size 256", kernel(256) },
    { "denoiser none, kernel size 16", denoiser(Pass::None) },
    { "denoiser box", denoiser(Pass::Box) },
    { "denoiser edge-aware", denoiser(Pass::EdgeAware) },
    { "the same, noise size 8",
      [=](Pass* pass)
      {
        denoiser(Pass::EdgeAware)(pass);
        pass->SetNoiseSize(8);
      } },
    { "without occlusion", [](Pass* pass) { pass->SetOutputModeToUnoccluded(); } },
    { "modulation ambient", modulation(Pass::Ambient) },
    { "modulation ambient and diffuse", modulation(Pass::AmbientAndDiffuse) },
    { "modulation all", modulation(Pass::All) },
  };
}

/// The mesh of a file, or balls among steps on a floor.
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
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(argc > 1 ? argv[1] : nullptr);
  if (mesh->GetNumberOfPolys() == 0)
  {
    std::cerr << "ParameterSweep: error: " << argv[1] << " has no polygons\n";
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

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(Columns * CellSize[0], Rows * CellSize[1]);
  window->SetNumberOfLayers(2);
  vtkNew<vtkRenderer> labels; // over the pictures, because the output modes show nothing else
  labels->SetLayer(1);
  window->AddRenderer(labels);

  const std::vector<Cell> cells = MakeCells(mesh->GetLength());
  for (int i = 0; i < Columns * Rows; ++i)
  {
    const double left = i % Columns;
    const double bottom = Rows - 1 - i / Columns;
    vtkNew<Pass> pass;
    cells[i].Set(pass);
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(
      left / Columns, bottom / Rows, (left + 1.0) / Columns, (bottom + 1.0) / Rows);
    renderer->SetBackground(1.0, 1.0, 1.0);
    renderer->AddActor(actor);
    renderer->SetActiveCamera(camera);
    renderer->SetPass(pass);
    window->AddRenderer(renderer);
    if (i == 0)
    {
      renderer->ResetCamera();
      camera->Zoom(1.1);
    }
    vtkNew<vtkTextActor> label;
    label->SetInput(cells[i].Label.c_str());
    label->SetPosition(left * CellSize[0] + 10.0, (bottom + 1.0) * CellSize[1] - 30.0);
    label->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
    label->GetTextProperty()->SetFontSize(18);
    labels->AddViewProp(label);
  }

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 2 ? argv[2] : "parameter_sweep.png");
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
