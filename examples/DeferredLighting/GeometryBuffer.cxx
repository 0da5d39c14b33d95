// SPDX-License-Identifier: BSD-3-Clause
#include "GeometryBuffer.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkUnsignedCharArray.h>

namespace deferred
{
namespace
{
/// The point that is `depth` in front of the camera at the centre of a pixel.
vtkVector3d PositionOf(double depth, double x, double y, vtkMatrix4x4* projection)
{
  // The projection P of a point p is (P p).x / (P p).w, here solved for p.x with p.z known.
  const double z = -depth;
  const double w = projection->GetElement(3, 2) * z + projection->GetElement(3, 3);
  const double place[2] = { x, y };
  double p[2];
  for (int i = 0; i < 2; ++i)
  {
    const double shift = projection->GetElement(i, 2) * z + projection->GetElement(i, 3);
    p[i] = (place[i] * w - shift) / projection->GetElement(i, i);
  }
  return vtkVector3d(p[0], p[1], z);
}
}

//------------------------------------------------------------------------------
GeometryBuffer Capture(
  vtkRenderWindow* window, vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass)
{
  GeometryBuffer buffer;
  const int* size = window->GetSize();

  pass->SetOutputModeToUnoccluded();
  window->Render();
  vtkNew<vtkUnsignedCharArray> albedo;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, /*front=*/0, albedo);

  pass->SetOutputModeToOcclusion();
  window->Render();
  vtkNew<vtkImageData> visibility;
  vtkNew<vtkImageData> geometry; // depth, shading normal, facet normal
  if (!pass->GetVisibility(visibility) || !pass->GetGeometry(geometry) ||
    albedo->GetNumberOfTuples() != geometry->GetNumberOfPoints())
  {
    return buffer;
  }

  buffer.Width = size[0];
  buffer.Height = size[1];
  buffer.Pixels.resize(static_cast<size_t>(buffer.Width) * buffer.Height);
  vtkMatrix4x4* projection = renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0);
  const auto* values = static_cast<const float*>(geometry->GetScalarPointer());
  const auto* open = static_cast<const float*>(visibility->GetScalarPointer());
  for (vtkIdType i = 0; i < geometry->GetNumberOfPoints(); ++i, values += 8, ++open)
  {
    Surface& surface = buffer.Pixels[i];
    const double x = 2.0 * (i % buffer.Width + 0.5) / buffer.Width - 1.0;
    const double y = 2.0 * (i / buffer.Width + 0.5) / buffer.Height - 1.0;
    surface.Seen = values[0] > 0.0F;
    surface.Position = PositionOf(values[0], x, y, projection);
    surface.Normal = vtkVector3d(values[1], values[2], values[3]);
    surface.Visibility = *open;
    for (int c = 0; c < 3; ++c)
    {
      surface.Albedo[c] = albedo->GetTypedComponent(i, c) / 255.0;
    }
  }
  return buffer;
}
}
