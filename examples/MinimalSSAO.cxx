// SPDX-License-Identifier: BSD-3-Clause
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkParametricBoy.h>
#include <vtkParametricFunctionSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLPolyDataReader.h>

int main(int argc, char* argv[]) // MinimalSSAO [mesh.vtp [picture.png]]
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkParametricFunctionSource> surface;
  surface->SetParametricFunction(vtkNew<vtkParametricBoy>());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(argc > 1 ? reader->GetOutputPort() : surface->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> ssao;
  renderer->SetPass(ssao); // ssao->SetRadius(r), in world units, if the automatic one does not suit
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 2 ? argv[2] : "minimal.png");
  writer->Write();
}
