// SPDX-License-Identifier: BSD-3-Clause
/**
 * What happens inside the pass: one picture per stage, numbered in the order of the pipeline.
 * StageViewer [mesh.vtp [folder [width in pixels]]]
 */
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
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
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Pass = vtkScreenSpaceAmbientOcclusionPass;

/// A stage is seen through an output mode, with those after it switched off.
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
  { "5_occlusion_raw", Pass::Occlusion, false },
  { "6_occlusion_denoised", Pass::Occlusion, true },
  { "7_composite", Pass::Composite, true },
};
const char* const SolidsName = "4_solids";

bool Write(vtkImageData* picture, const std::string& folder, const std::string& name)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName((folder + "/stage_" + name + ".png").c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  return writer->GetErrorCode() == 0;
}

/// How much of the ray of each estimated pixel lies inside solids: white is nothing, black is two
/// radii or more.
vtkSmartPointer<vtkImageData> DrawSolids(Pass* pass)
{
  vtkNew<vtkImageData> solids; // depths of front and back of up to four stretches, else 0
  auto picture = vtkSmartPointer<vtkImageData>::New();
  if (pass->GetSolids(solids))
  {
    picture->SetDimensions(solids->GetDimensions());
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    const auto* value = static_cast<const float*>(solids->GetScalarPointer());
    auto* grey = static_cast<unsigned char*>(picture->GetScalarPointer());
    for (vtkIdType i = 0; i < solids->GetNumberOfPoints(); ++i, value += 8)
    {
      double inside = 0.0;
      for (int stretch = 0; stretch < 4; ++stretch)
      {
        inside += value[2 * stretch + 1] - std::abs(value[2 * stretch]);
      }
      const double share = inside / (2.0 * pass->GetEffectiveRadius());
      grey[i] = static_cast<unsigned char>(255.0 * (1.0 - std::clamp(share, 0.0, 1.0)));
    }
  }
  return picture;
}

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
  pass->SetQualityToAccurate();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  renderer->SetPass(pass);
  renderer->GetActiveCamera()->SetPosition(-0.5, -1.0, 0.8);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.3);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  const std::string folder = argc > 2 ? argv[2] : ".";
  const int width = argc > 3 ? std::atoi(argv[3]) : 640;
  window->SetSize(width, width * 3 / 4);
  window->AddRenderer(renderer);

  bool written = true;
  for (const Stage& stage : Stages)
  {
    pass->SetOutputMode(stage.OutputMode);
    pass->SetDenoiser(stage.Denoised ? Pass::EdgeAware : Pass::None);
    window->Render();
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(window);
    picture->ReadFrontBufferOff();
    picture->Update();
    written = Write(picture->GetOutput(), folder, stage.Name) && written;
  }
  written = Write(DrawSolids(pass), folder, SolidsName) && written;
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
