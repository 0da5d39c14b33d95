// SPDX-License-Identifier: BSD-3-Clause
// Links the pass and nothing else of the project, and opens no window.
#include <vtkScreenSpaceAmbientOcclusionPass.h>

#if defined(GL_VERSION_1_1) || defined(__gl_h_) || defined(__glew_h__) || defined(GLAD_GL_H_)
#error "The public header brings OpenGL with it."
#endif

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere; // from the program's own part of VTK
  sphere->Update();

  vtkNew<vtkScreenSpaceAmbientOcclusionPass> ssao;
  ssao->SetRadius(2.0);
  vtkNew<vtkRenderer> renderer;
  renderer->SetPass(ssao);
  if (ssao->GetEffectiveRadius() != 2.0 || renderer->GetPass() != ssao)
  {
    std::cerr << "The pass does not keep what it is told.\n";
    return EXIT_FAILURE;
  }
  std::cout << ssao->GetClassName() << "\n";
  return EXIT_SUCCESS;
}
