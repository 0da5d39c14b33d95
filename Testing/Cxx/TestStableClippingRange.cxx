// SPDX-License-Identifier: BSD-3-Clause

// Where the clipping planes are does not matter, as long as they cut nothing: near and far at
// ratios of 1e1 to 1e6 about one scene.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSSAOStability.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

#include <sstream>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// Points drawn as spheres and lines drawn as tubes: their depth is that of the depth buffer.
void AddSprites(vtkSSAOTestView& view)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(-1.4 + 0.4 * i, 0.1, 0.7);
    vertices->InsertNextCell(1, &i);
    const vtkIdType ends[2] = { i, (i + 1) % 8 };
    lines->InsertNextCell(2, ends);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(lines);
  vtkProperty* property = view.Add(data)->GetProperty();
  property->SetPointSize(9.0F);
  property->SetLineWidth(4.0F);
  property->RenderPointsAsSpheresOn();
  property->RenderLinesAsTubesOn();
}

//------------------------------------------------------------------------------
void Compare(vtkSSAOTestMonitor& test, vtkSSAOStability& row, bool sprites)
{
  for (bool parallel : { false, true })
  {
    vtkSSAOTestView view(test, 150, 100);
    vtkSSAOAddStillLife(view);
    if (sprites)
    {
      AddSprites(view);
    }
    vtkSSAOLookAtStillLife(view, parallel);
    view.Pass->SetRadius(0.5);
    std::vector<vtkSSAOTestImage> tight;
    vtkSSAOTestImage ofVTK;
    // All that is seen lies 3 to 10 in front of the camera.
    const double ranges[][2] = { { 2.5, 12.0 }, { 1.2, 12.0 }, { 1.0, 100.0 }, { 0.1, 100.0 },
      { 0.1, 1000.0 }, { 0.1, 10000.0 }, { 0.01, 10000.0 } };
    for (const auto& range : ranges)
    {
      view.Renderer->GetActiveCamera()->SetClippingRange(range[0], range[1]);
      std::ostringstream what;
      what << (parallel ? "parallel" : "perspective") << ", " << range[0] << " to " << range[1];
      for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
      {
        view.SetPreset(preset);
        const vtkSSAOTestImage v = view.Visibility();
        if (static_cast<int>(tight.size()) == preset)
        {
          test.ExpectAtMost(view.MeasureSurfaces(v).Minimum, 0.8, what.str() + ": smallest V");
          tight.push_back(v);
        }
        row.Ours(preset, 100.0 * vtkSSAOShareBeyond(v, tight[preset], 2.0 / 255.0), what.str());
      }
      const vtkSSAOTestImage v = view.VisibilityOfVTK(0.5);
      ofVTK = ofVTK.Width ? ofVTK : v;
      row.VTK(100.0 * vtkSSAOShareBeyond(v, ofVTK, 2.0 / 255.0), what.str());
    }
  }
}
}

//------------------------------------------------------------------------------
int TestStableClippingRange(int, char*[])
{
  vtkSSAOTestMonitor test;
  const char* measure = "% of the pixels whose V differs by more than 2/255 from a tight range";
  vtkSSAOStability meshes(
    test, "Near and far at a ratio of 1e1 to 1e6", measure, vtkSSAOStability::AtMost, 0.1);
  Compare(test, meshes, false);
  // The depth of sprites is what the depth buffer holds of it, so that where two of them meet
  // another one may be in front.
  vtkSSAOStability sprites(test, "The same ratios, points as spheres, lines as tubes", measure,
    vtkSSAOStability::AtMost, 2.0);
  Compare(test, sprites, true);
  return test.GetResult();
}
