// SPDX-License-Identifier: BSD-3-Clause

// A mesh that its mapper cuts by clipping planes has the visibility of one that was cut before, and
// a surface drawn in the plane of another, a little nearer by VTK's offsets, hides nothing.

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkClipPolyData.h"
#include "vtkCubeSource.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <string>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// A box and a ball of which a slanted plane takes a part away, so that their insides are seen.
void AddCutBodies(vtkSSAOTestView& view, bool byMapper)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-1.6, -0.3, 0.0, 1.0, -0.7, 0.6);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.7, 0.6, 0.1);
  ball->SetRadius(0.7);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(32);
  for (vtkPolyDataAlgorithm* body :
    { static_cast<vtkPolyDataAlgorithm*>(box), static_cast<vtkPolyDataAlgorithm*>(ball) })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.6, 0.1);
    plane->SetNormal(0.1, -1.0, -0.6);
    vtkNew<vtkTriangleFilter> triangles; // as the mapper cuts them
    triangles->SetInputConnection(body->GetOutputPort());
    if (byMapper)
    {
      vtkActor* actor = view.Add(triangles);
      actor->GetMapper()->AddClippingPlane(plane);
      actor->GetProperty()->SetInterpolationToFlat();
      continue;
    }
    vtkNew<vtkClipPolyData> cut;
    cut->SetInputConnection(triangles->GetOutputPort());
    cut->SetClipFunction(plane);
    // Of what the filter cuts VTK shades the back by other normals of points.
    view.Add(cut)->GetProperty()->SetInterpolationToFlat();
  }
}

//------------------------------------------------------------------------------
void CompareCuts(vtkSSAOTestMonitor& test)
{
  // A pixel on the very cut may be of one mesh and not of the other, and one noise tile of its
  // neighbours notices, 10 x 10 pixels: less than the limit in a picture of this size.
  vtkSSAOStability row(test, "Meshes cut by clipping planes of their mappers",
    "% of the pixels whose V differs by more than 2/255 from meshes cut before",
    vtkSSAOStability::AtMost, 0.1);
  for (bool parallel : { false, true })
  {
    vtkSSAOTestView cut(test, 450, 300);
    vtkSSAOAddFloor(cut);
    AddCutBodies(cut, false);
    vtkSSAOTestView byMapper(test, 450, 300);
    vtkSSAOAddFloor(byMapper);
    AddCutBodies(byMapper, true);
    vtkSSAOTestView whole(test, 450, 300);
    vtkSSAOAddFloor(whole);
    AddCutBodies(whole, true);
    vtkActorCollection* actors = whole.Renderer->GetActors();
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkActor* actor = actors->GetNextActor(it))
    {
      actor->GetMapper()->RemoveAllClippingPlanes();
    }
    for (vtkSSAOTestView* view : { &cut, &byMapper, &whole })
    {
      vtkSSAOLookAtStillLife(*view, parallel);
      view->Renderer->GetActiveCamera()->SetClippingRange(1.0, 20.0);
      view->Pass->SetRadius(0.5);
    }
    const std::string what = parallel ? "parallel" : "perspective";
    for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
    {
      for (vtkSSAOTestView* view : { &cut, &byMapper, &whole })
      {
        view->SetPreset(preset);
      }
      const vtkSSAOTestImage expected = cut.Visibility();
      row.Ours(
        preset, 100.0 * vtkSSAOShareBeyond(byMapper.Visibility(), expected, 2.0 / 255.0), what);
      test.ExpectAtLeast(100.0 * vtkSSAOShareBeyond(whole.Visibility(), expected, 2.0 / 255.0),
        10.0, what + ": % of the pixels that the cut changes");
    }
    row.VTK(100.0 *
        vtkSSAOShareBeyond(byMapper.VisibilityOfVTK(0.5), cut.VisibilityOfVTK(0.5), 2.0 / 255.0),
      what);
  }
}

//------------------------------------------------------------------------------
void MeasureDecals(vtkSSAOTestMonitor& test)
{
  vtkSSAOStability row(test, "A square drawn in the plane of an open floor, by VTK's offsets",
    "smallest V", vtkSSAOStability::AtLeast, 0.99);
  for (int resolve : { VTK_RESOLVE_POLYGON_OFFSET, VTK_RESOLVE_SHIFT_ZBUFFER })
  {
    for (bool parallel : { false, true })
    {
      vtkSSAOTestView view(test, 150, 100);
      vtkSSAOAddFloor(view);
      vtkActor* decal = view.Add(vtkSSAOQuad({ -1, 0, 1 }, { 2, 0, 0 }, { 0, 0, -2 }));
      vtkActor* wires = view.Add(vtkSSAOQuad({ -2, 0, 2 }, { 4, 0, 0 }, { 0, 0, -4 }));
      wires->GetProperty()->SetRepresentationToWireframe();
      decal->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-4.0, -4.0);
      vtkMapper::SetResolveCoincidentTopology(resolve);
      vtkSSAOLookAtCorner(view, parallel);
      view.Pass->SetRadius(1.0);
      const std::string what =
        "way " + std::to_string(resolve) + (parallel ? ", parallel" : ", perspective");
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOStatistics v = view.MeasureSurfaces(view.Visibility());
        row.Ours(preset, v.Minimum, what);
        test.ExpectAtLeast(v.Count, 5000, what + ": pixels of surfaces");
      }
      wires->VisibilityOff(); // VTK's pass takes lines for surfaces
      row.VTK(view.MeasureSurfaces(view.VisibilityOfVTK(1.0)).Minimum, what);
      vtkMapper::SetResolveCoincidentTopology(VTK_RESOLVE_OFF);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableCutMeshes(int, char*[])
{
  vtkSSAOTestMonitor test;
  CompareCuts(test);
  MeasureDecals(test);
  return test.GetResult();
}
