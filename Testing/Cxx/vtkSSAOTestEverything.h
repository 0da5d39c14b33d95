// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Props that occlusion must leave alone: unlit, line-like, translucent, volumes, text, overlays.
 */

#ifndef vtkSSAOTestEverything_h
#define vtkSSAOTestEverything_h

#include "vtkSSAOTestScenes.h"

#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageActor.h"
#include "vtkImageMapper3D.h"
#include "vtkLookupTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextActor3D.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace vtkSSAOTest
{
//------------------------------------------------------------------------------
/// A star of line cells, with or without normals.
inline vtkSmartPointer<vtkPolyData> MakeStar(bool normals)
{
  auto star = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.4 * std::cos(1.2566 * i), 0.4 * std::sin(1.2566 * i), 0.0);
    directions->InsertNextTuple3(0.0, 0.6, 0.8);
    const vtkIdType line[2] = { i, (i + 2) % 5 };
    lines->InsertNextCell(2, line);
  }
  star->SetPoints(points);
  star->SetLines(lines);
  if (normals)
  {
    star->GetPointData()->SetNormals(directions);
  }
  return star;
}

//------------------------------------------------------------------------------
/// Opaque actors without light: unlit surface, wireframe, points, lines, and an image.
inline void AddUnlitProps(vtkRenderer* renderer, Grid& grid)
{
  const auto add = [&](vtkActor* actor)
  {
    vtkProperty* property = actor->GetProperty();
    property->SetColor(0.9, 0.6, 0.3);
    property->SetAmbient(0.3);
    property->SetDiffuse(0.6);
    grid.Place(actor);
    renderer->AddActor(actor);
    return property;
  };
  add(MakeActor(MakeSphere()))->LightingOff();
  add(MakeActor(MakeSphere(0.45, 10)))->SetRepresentationToWireframe();
  vtkProperty* points = add(MakeActor(MakeSphere()));
  points->SetRepresentationToPoints();
  points->SetPointSize(4.0F);
  add(MakeActor(MakeStar(false)))->SetLineWidth(3.0F);
  // VTK does light these lines, but they are no surface.
  add(MakeActor(MakeStar(true)))->SetLineWidth(3.0F);

  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->SetSpacing(0.1, 0.1, 1.0);
  image->SetOrigin(-0.35, -0.35, 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 64; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = static_cast<unsigned char>(4 * i);
  }
  vtkNew<vtkImageActor> slice;
  slice->GetMapper()->SetInputData(image);
  grid.Place(slice);
  renderer->AddActor(slice);
}

//------------------------------------------------------------------------------
/// Glass: by opacity, by texture, by colours.
inline void AddTranslucentProps(vtkRenderer* renderer, Grid& grid)
{
  vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere());
  glass->GetProperty()->SetOpacity(0.4);
  glass->GetProperty()->SetColor(0.3, 0.8, 0.5);
  grid.Place(glass);
  renderer->AddActor(glass);

  vtkSmartPointer<vtkPolyData> mapped = MakeSphere();
  AddTextureCoordinates(mapped);
  vtkSmartPointer<vtkActor> textured = MakeActor(mapped);
  textured->SetTexture(MakeTexture(16, 4,
    [](double s, double t) {
      return std::array<double, 4>{ 1.0, s, t, 0.2 + 0.6 * s };
    }));
  grid.Place(textured);
  renderer->AddActor(textured);

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.45, -0.45, 0.0);
  plane->SetPoint1(0.45, -0.45, 0.1);
  plane->SetPoint2(-0.45, 0.45, 0.2);
  plane->SetResolution(3, 3);
  plane->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (int i = 0; i < 9; ++i)
  {
    colors->InsertNextTuple4(28 * i, 255 - 28 * i, 120, 60 + 15 * i);
  }
  vtkSmartPointer<vtkPolyData> colored = plane->GetOutput();
  colored->GetCellData()->SetScalars(colors);
  vtkSmartPointer<vtkActor> painted = MakeActor(colored);
  painted->GetMapper()->ScalarVisibilityOn();
  grid.Place(painted);
  renderer->AddActor(painted);
}

//------------------------------------------------------------------------------
/// A ball of fog.
inline void AddVolume(vtkRenderer* renderer, Grid& grid)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->SetSpacing(0.05, 0.05, 0.05);
  image->SetOrigin(-0.375, -0.375, -0.375);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(255.0 * std::max(0.0, 1.0 - 2.5 * std::hypot(p[0], p[1], p[2])));
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->UseJitteringOff();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.2, 0.4, 1.0);
  color->AddRGBPoint(255.0, 1.0, 0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.5);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.1);
  volume->GetProperty()->ShadeOn();
  grid.Place(volume);
  renderer->AddVolume(volume);
}

//------------------------------------------------------------------------------
/// Text in two and three dimensions, axes, and a scalar bar.
inline void AddAnnotations(vtkRenderer* renderer, Grid& grid)
{
  vtkNew<vtkTextActor> title;
  title->SetInput("Title");
  title->SetPosition(5.0, 5.0);
  title->GetTextProperty()->SetFontSize(18);
  renderer->AddViewProp(title);

  vtkNew<vtkTextActor3D> caption;
  caption->SetInput("3D");
  caption->GetTextProperty()->SetFontSize(12);
  caption->SetScale(0.05);
  grid.Place(caption);
  renderer->AddActor(caption);

  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput("label");
  label->GetTextProperty()->SetFontSize(14);
  grid.Place(label);
  renderer->AddActor(label);

  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(0.5, 0.5, 0.5);
  axes->AxisLabelsOff();
  // Its position is not that of its parts.
  renderer->AddActor(axes);

  vtkNew<vtkLookupTable> table;
  table->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetNumberOfLabels(3);
  renderer->AddViewProp(bar);
}
}

#endif
