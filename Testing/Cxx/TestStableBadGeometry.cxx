// SPDX-License-Identifier: BSD-3-Clause

// Bad meshes: V stays a number from 0 to 1 in every pixel, and where nothing occludes nothing is
// darkened.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkCullerCollection.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"
#include "vtkSphereSource.h"

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
// A floor of 20 x 20 squares, y = 0, facing up, 20 wide.
vtkSmartPointer<vtkPolyData> NewGrid()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-10, 0, 10);
  plane->SetPoint1(10, 0, 10);
  plane->SetPoint2(-10, 0, -10);
  plane->SetResolution(20, 20);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  vtkSmartPointer<vtkPolyData> grid = plane->GetOutput();
  grid->GetPointData()->Initialize();
  return grid;
}

//------------------------------------------------------------------------------
// The floor with one of the points that are seen moved to (x, 0, x), which opens a hole or tears
// its faces away to where nothing is seen.
void AddWithPoint(vtkSSAOTestView& view, double x)
{
  vtkSmartPointer<vtkPolyData> grid = NewGrid();
  grid->GetPoints()->SetPoint(10 * 21 + 10, x, 0.0, x);
  grid->GetPoints()->Modified();
  view.Add(grid);
}

//------------------------------------------------------------------------------
void AddWithNormals(vtkSSAOTestView& view, double x, double y, double z)
{
  vtkSmartPointer<vtkPolyData> grid = NewGrid();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    normals->InsertNextTuple3(x, y, z);
  }
  grid->GetPointData()->SetNormals(normals);
  view.Add(grid);
}

//------------------------------------------------------------------------------
// Triangles without area: all corners in one point, two in one point, all on one line.
void AddDegenerate(vtkSSAOTestView& view)
{
  vtkSmartPointer<vtkPolyData> grid = NewGrid();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i + 2 < grid->GetNumberOfPoints(); i += 3) // 21 points in a row
  {
    triangles->InsertNextCell({ i, i, i });
    triangles->InsertNextCell({ i, i + 1, i });
    triangles->InsertNextCell({ i, i + 1, i + 2 });
  }
  vtkNew<vtkPolyData> degenerate;
  degenerate->SetPoints(grid->GetPoints());
  degenerate->SetPolys(triangles);
  view.Add(grid);
  view.Add(degenerate);
}

//------------------------------------------------------------------------------
void AddBlocks(vtkSSAOTestView& view)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(4);
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  blocks->SetBlock(1, inner);
  blocks->SetBlock(3, NewGrid());
  vtkNew<vtkSSAOTestCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  view.Renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
// A flipped box: its point normals look inwards, and so do its faces if they are wound so.
void AddFlippedBox(vtkSSAOTestView& view, bool wound)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(-2, 2, -2, 2, -2, 2);
  source->Update();
  vtkPolyData* box = source->GetOutput();
  if (wound)
  {
    box->BuildCells();
    for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
    {
      box->ReverseCell(i);
    }
  }
  vtkDataArray* normals = box->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    const double* n = normals->GetTuple3(i);
    normals->SetTuple3(i, -n[0], -n[1], -n[2]);
  }
  view.Add(box);
}

using Fill = std::function<void(vtkSSAOTestView&)>;

//------------------------------------------------------------------------------
// Scenes in which nothing occludes; all are looked at from (0, 8, 12).
std::vector<std::pair<std::string, Fill>> Scenes()
{
  return {
    { "a NaN point", [](vtkSSAOTestView& view) { AddWithPoint(view, NotANumber); } },
    { "an infinite point",
      [](vtkSSAOTestView& view)
      {
        // Besides a good mesh: VTK draws nothing of one without finite bounds.
        view.Add(NewGrid());
        AddWithPoint(view, Infinity);
      } },
    { "a point at 1e30",
      [](vtkSSAOTestView& view)
      {
        view.Add(NewGrid());
        view.Add(vtkSSAOQuad({ 1.0e30, 0, 0 }, { 1, 0, 0 }, { 0, 1.0e30, 0 }));
      } },
    { "degenerate triangles", AddDegenerate },
    { "zero normals", [](vtkSSAOTestView& view) { AddWithNormals(view, 0, 0, 0); } },
    { "NaN normals",
      [](vtkSSAOTestView& view) { AddWithNormals(view, NotANumber, NotANumber, NotANumber); } },
    { "missing normals", [](vtkSSAOTestView& view) { view.Add(NewGrid()); } },
    { "flipped normals", [](vtkSSAOTestView& view) { AddWithNormals(view, 0, -1, 0); } },
    { "a box with flipped normals", [](vtkSSAOTestView& view) { AddFlippedBox(view, false); } },
    { "a box wound inside out", [](vtkSSAOTestView& view) { AddFlippedBox(view, true); } },
    { "coincident faces",
      [](vtkSSAOTestView& view)
      {
        view.Add(NewGrid());
        view.Add(vtkSSAOQuad({ -10, 0, 10 }, { 20, 0, 0 }, { 0, 0, -20 }));
      } },
    { "coincident faces, wound both ways",
      [](vtkSSAOTestView& view)
      {
        view.Add(NewGrid());
        view.Add(vtkSSAOQuad({ -10, 0, 10 }, { 0, 0, -20 }, { 20, 0, 0 }));
      } },
    { "faces edge-on",
      [](vtkSSAOTestView& view)
      {
        // In planes through the camera: they cover no pixel.
        view.Add(NewGrid());
        view.Add(vtkSSAOQuad({ 0, 0, 5 }, { 0, 0, -10 }, { 0, 1, 0 }));
      } },
    { "empty blocks", AddBlocks },
    { "the camera inside a box",
      [](vtkSSAOTestView& view)
      {
        vtkNew<vtkCubeSource> box;
        box->SetBounds(-60, 60, -10, 60, -60, 60); // its floor alone is seen
        view.Add(box);
      } },
    { "the near plane through the floor",
      [](vtkSSAOTestView& view)
      {
        view.Add(NewGrid());
        view.Renderer->GetActiveCamera()->SetClippingRange(14.0, 40.0);
      } },
    { "the near plane through a box",
      [](vtkSSAOTestView& view)
      {
        // Its top is cut away, and its bottom seen from inside.
        vtkNew<vtkCubeSource> box;
        box->SetBounds(-60, 60, -10, 4, -60, 60);
        view.Add(box);
        view.Renderer->GetActiveCamera()->SetClippingRange(18.0, 100.0);
      } },
  };
}
}

//------------------------------------------------------------------------------
int TestStableBadGeometry(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOStability bad(
    test, "Bad geometry", "pixels with V not from 0 to 1", vtkSSAOStability::AtMost, 0.0);
  vtkSSAOStability open(
    test, "Bad geometry where nothing occludes", "mean V", vtkSSAOStability::AtLeast, 0.998);
  // A hundredth, as for an open plane: rounding of depths and facets.
  vtkSSAOStability smallest(
    test, "The same, every pixel", "smallest V", vtkSSAOStability::AtLeast, 0.99);
  // Rounding decides from pixel to pixel which of the two is seen, and with which of them solids
  // begin.
  vtkSSAOStability fighting(test, "Faces in one place wound both ways, every pixel", "smallest V",
    vtkSSAOStability::AtLeast, 0.95);
  for (const auto& scene : Scenes())
  {
    const bool isFighting = scene.first == "coincident faces, wound both ways";
    for (bool parallel : { false, true })
    {
      vtkSSAOTestView view(test, 150, 100);
      if (parallel)
      {
        view.LookParallel({ 0, 8, 12 }, { 0, 0, 0 }, { 0, 1, 0 }, 3.5);
      }
      else
      {
        view.Look({ 0, 8, 12 }, { 0, 0, 0 }, { 0, 1, 0 });
      }
      view.Renderer->GetActiveCamera()->SetClippingRange(0.1, 100.0);
      view.Renderer->GetCullers()->RemoveAllItems(); // they drop what has no finite bounds
      scene.second(view);
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        for (double radius : { 1.0, 0.0 })
        {
          view.Pass->SetRadius(radius);
          const std::string what = scene.first + (parallel ? ", parallel" : ", perspective") +
            (radius > 0.0 ? "" : ", automatic radius");
          const vtkSSAOTestImage v = view.Visibility();
          bad.Ours(preset,
            vtkSSAOMeasure(
              v, [&](int x, int y) { return !(v.At(x, y) >= 0.0F && v.At(x, y) <= 1.0F); })
              .Count,
            what);
          if (radius > 0.0)
          {
            const vtkSSAOStatistics surfaces = view.MeasureSurfaces(v);
            open.Ours(preset, surfaces.Mean, what);
            (isFighting ? fighting : smallest).Ours(preset, surfaces.Minimum, what);
            test.ExpectAtLeast(surfaces.Count, 2000, what + ": pixels of a surface");
          }
        }
      }
      const vtkSSAOStatistics ofVTK = view.MeasureSurfaces(view.VisibilityOfVTK(1.0));
      open.VTK(ofVTK.Mean, scene.first);
      (isFighting ? fighting : smallest).VTK(ofVTK.Minimum, scene.first);
    }
  }
  return test.GetResult();
}
