// SPDX-License-Identifier: BSD-3-Clause
// Spheres that are computed in the fragment shader.

#ifndef vtkSSAOTestImpostors_h
#define vtkSSAOTestImpostors_h

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestView.h"

namespace vtkSSAOTest
{
/// Five in front of the bodies of the still life.
inline void AddImpostors(vtkSSAOTestView& view, double scale = 1.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(scale * (-1.4 + 0.5 * i), scale * 0.3, scale * 0.75);
    vertices->InsertNextCell(1, &i);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadius(static_cast<float>(0.2 * scale));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  view.Renderer->AddActor(actor);
}
}

#endif
