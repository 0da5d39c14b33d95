// SPDX-License-Identifier: BSD-3-Clause
/**
 * What happens inside the pass: one picture per stage, numbered in the order of the pipeline.
 * StageViewer [mesh.vtp [folder]]
 */
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkParametricBoy.h>
#include <vtkParametricFunctionSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Pass = vtkScreenSpaceAmbientOcclusionPass;

/// A stage is seen through an output mode; the raw occlusion is the one that is not denoised.
struct Stage
{
  const char* Name;
  Pass::OutputModeType OutputMode;
  bool Denoised;
};

const Stage Stages[] = {
  { "1_unoccluded", Pass::Unoccluded, true },
  { "2_depth", Pass::Depth, true },
  { "3_normal", Pass::Normal, true },
  { "4_occlusion_raw", Pass::Occlusion, false },
  { "5_occlusion_denoised", Pass::Occlusion, true },
  { "6_composite", Pass::Composite, true },
};

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkParametricFunctionSource> surface;
  surface->SetParametricFunction(vtkNew<vtkParametricBoy>());
  surface->SetScalarModeToNone();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(argc > 1 ? reader->GetOutputPort() : surface->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->Update();
  if (mapper->GetInput()->GetNumberOfCells() == 0)
  {
    std::cerr << "StageViewer: error: " << argv[1] << " has nothing to draw\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);

  vtkNew<Pass> pass;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  renderer->SetPass(pass);
  renderer->GetActiveCamera()->SetPosition(-0.5, -1.0, 0.8);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);

  const int denoiser = pass->GetDenoiser();
  for (const Stage& stage : Stages)
  {
    pass->SetOutputMode(stage.OutputMode);
    pass->SetDenoiser(stage.Denoised ? denoiser : Pass::None);
    window->Render();
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(window);
    picture->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    const std::string folder = argc > 2 ? argv[2] : ".";
    writer->SetFileName((folder + "/stage_" + stage.Name + ".png").c_str());
    writer->Write();
    if (writer->GetErrorCode() != 0)
    {
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
