// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ray-traced truth of a view, for tests that need no cache.
 */

#ifndef vtkSSAOTestTruth_h
#define vtkSSAOTestTruth_h

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageError.h"
#include "vtkSSAOTestView.h"
#include "vtkSSAOTruthCamera.h"
#include "vtkSSAOTruthImage.h"
#include "vtkSSAOTruthScene.h"
#include "vtkSSAOTruthTracer.h"

namespace vtkSSAOTest
{
//------------------------------------------------------------------------------
/// The truth at the pixel centres of a view.
inline vtkSSAOTruthImage TraceTruth(vtkSSAOTestView& view, double radius, int raysPerPixel)
{
  vtkSSAOTruthScene scene;
  scene.Gather(view.Renderer);
  const int* size = view.Window->GetSize();
  const vtkSSAOTruthCamera camera(
    view.Renderer->GetActiveCamera(), size[0], size[1], scene.GetOrigin());
  vtkSSAOTruthTracer tracer;
  tracer.SetRadius(radius);
  tracer.SetRaysPerPixel(raysPerPixel);
  vtkSSAOTruthImage truth;
  tracer.Trace(scene, camera, truth);
  return truth;
}

//------------------------------------------------------------------------------
/// Root mean square of V - truth where the truth shows a surface.
inline double ErrorAgainst(const vtkSSAOTruthImage& truth, const vtkSSAOTestImage& v)
{
  vtkSSAOImageError error;
  error.Compare(v.Values, truth);
  return error.GetRootMeanSquare();
}
}

#endif
