// SPDX-License-Identifier: BSD-3-Clause
// Draws the inner corner of a box with and without the pass: with it, the picture must be darker.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkUnsignedCharArray.h>

#include <cstdlib>
#include <iostream>

namespace
{
void AddWall(vtkRenderer* renderer, int axisU, int axisV)
{
  double u[3] = { 0.0, 0.0, 0.0 };
  double v[3] = { 0.0, 0.0, 0.0 };
  u[axisU] = 1.0;
  v[axisV] = 1.0;
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(0.0, 0.0, 0.0);
  wall->SetPoint1(u);
  wall->SetPoint2(v);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(wall->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

double MeanBrightness(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, window->GetSize()[0] - 1, window->GetSize()[1] - 1, 0, pixels);
  double sum = 0.0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    sum += pixels->GetValue(i);
  }
  return sum / static_cast<double>(pixels->GetNumberOfValues());
}
}

int main()
{
  vtkNew<vtkRenderer> renderer;
  AddWall(renderer, 0, 1);
  AddWall(renderer, 1, 2);
  AddWall(renderer, 2, 0);
  renderer->GetActiveCamera()->SetPosition(3.0, 2.5, 2.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.3, 0.3, 0.3);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(200, 150);
  window->AddRenderer(renderer);

  const double without = MeanBrightness(window);
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> ssao;
  ssao->SetRadius(0.5);
  renderer->SetPass(ssao);
  const double with = MeanBrightness(window);
  std::cout << window->GetClassName() << ": mean brightness " << without << " without, " << with
            << " with the pass\n";
  if (!(with < without - 1.0 && with > 1.0))
  {
    std::cerr << "The corner is not darker, or nothing was drawn.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
