// SPDX-License-Identifier: BSD-3-Clause
// What a deferred renderer lights: position, normal, albedo and visibility of each pixel.
#ifndef DeferredLighting_GeometryBuffer_h
#define DeferredLighting_GeometryBuffer_h

#include "Lighting.h"

#include <vector>

class vtkRenderWindow;
class vtkRenderer;
class vtkScreenSpaceAmbientOcclusionPass;

namespace deferred
{
struct GeometryBuffer
{
  int Width = 0;
  int Height = 0;
  std::vector<Surface> Pixels; // bottom row first
};

/// Draws the scene twice, for the albedo and for what the pass captures. The pass must be the
/// renderer's, the renderer fill the window, and every material have ambient 1, diffuse 0 and
/// specular 0, so that its colour is drawn as it is. Empty if something could not be drawn.
GeometryBuffer Capture(
  vtkRenderWindow* window, vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass);
}

#endif
