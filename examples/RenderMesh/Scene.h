// SPDX-License-Identifier: BSD-3-Clause
// From a mesh to actors in a renderer: how polygons, lines, points and atoms are shown.
#ifndef RenderMesh_Scene_h
#define RenderMesh_Scene_h

#include "Settings.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <string>

namespace rendermesh
{
struct Scene
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer; // of the window
  double Margin = 0.0;          // how far an actor reaches beyond its points, world units
  std::string Summary;          // how much there is
};

/// Reads the settings' file and adds its actors to the renderer.
void LoadScene(const Settings& settings, Scene& scene);
}

#endif
