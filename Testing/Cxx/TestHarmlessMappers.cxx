// SPDX-License-Identifier: BSD-3-Clause

// Every mapper, property and kind of actor draws what it draws without the pass. Those of
// TestModulationIdentity are not repeated.

#include "vtkLODActor.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropAssembly.h"
#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"
#include "vtkSSAOTestProps.h"
#include "vtkShaderProperty.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// Add an actor above the spheres, in one of three places.
void Add(Stage& stage, vtkProp3D* prop, int place = 0)
{
  prop->AddPosition(0.3 + 0.8 * place, 0.4 + 0.3 * place, 0.8);
  stage.Renderer->AddViewProp(prop);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> Actor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

//------------------------------------------------------------------------------
void AddSticks(Stage& stage)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> orientation;
  orientation->SetName("orientation");
  orientation->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> scale;
  scale->SetName("scale");
  scale->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.4 * i, 0.2 * i, 0.1 * i);
    orientation->InsertNextTuple3(std::cos(1.0 * i), std::sin(1.0 * i), 0.3);
    scale->InsertNextTuple3(0.8, 0.12, 0.12);
    vertices->InsertNextCell(1, &i);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(orientation);
  data->GetPointData()->AddArray(scale);
  data->GetPointData()->SetScalars(MakeColors(5)); // the mapper does not work without colours
  vtkNew<vtkOpenGLStickMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetOrientationArray("orientation");
  mapper->SetScaleArray("scale");
  Add(stage, Actor(mapper));
}

//------------------------------------------------------------------------------
void AddGaussians(Stage& stage, bool emissive, bool opaque)
{
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(MakeSphere(0.6, 10));
  mapper->SetScaleFactor(0.06);
  mapper->SetEmissive(emissive);
  mapper->ScalarVisibilityOff();
  if (opaque)
  {
    mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                               "if (dot(offsetVCVSOutput, offsetVCVSOutput) > 1.0) { discard; }\n");
  }
  vtkSmartPointer<vtkActor> actor = Actor(mapper);
  actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
  Add(stage, actor);
}

//------------------------------------------------------------------------------
// Blocks of which one is hidden, one is glass and one has a colour of its own.
void AddBlocks(Stage& stage)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 4; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.6 * i, 0.3 * i, 0.1 * i);
    sphere->SetRadius(0.35);
    sphere->Update();
    blocks->SetBlock(i, sphere->GetOutput());
  }
  vtkNew<vtkSSAOTestCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  mapper->SetBlockVisibility(2, false);
  mapper->SetBlockOpacity(3, 0.4);
  mapper->SetBlockColor(4, 0.1, 0.9, 0.3);
  Add(stage, Actor(mapper));
}

//------------------------------------------------------------------------------
// Faces, lines and vertices of one poly data with normals, so that VTK lights all of them.
vtkSmartPointer<vtkPolyData> MakeMixture(bool faces)
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere(0.4, 12);
  auto mixture = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(sphere->GetPoint(i));
    normals->InsertNextTuple(sphere->GetPointData()->GetNormals()->GetTuple(i));
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  for (int i = 0; i < 12; ++i)
  {
    const vtkIdType first =
      points->InsertNextPoint(std::cos(0.5 * i), std::sin(0.5 * i), 0.3 * std::sin(3.0 * i));
    normals->InsertNextTuple3(0.0, 0.3, 0.95);
    const vtkIdType line[2] = { i ? first - 1 : first, first };
    lines->InsertNextCell(2, line);
    vertices->InsertNextCell(1, &first);
  }
  mixture->SetPoints(points);
  mixture->GetPointData()->SetNormals(normals);
  mixture->SetLines(lines);
  mixture->SetVerts(vertices);
  if (faces)
  {
    mixture->SetPolys(sphere->GetPolys());
  }
  return mixture;
}

//------------------------------------------------------------------------------
void AddMixture(Stage& stage, bool faces)
{
  vtkSmartPointer<vtkActor> actor = MakeActor(MakeMixture(faces));
  actor->GetProperty()->SetLineWidth(3.0F);
  actor->GetProperty()->SetPointSize(6.0F);
  Add(stage, actor, 1);
}

//------------------------------------------------------------------------------
// The lines and vertices beside faces are not darkened, the faces are.
void CheckMixture(Report& report)
{
  Stage stage(report, 160, 120);
  vtkSmartPointer<vtkActor> actor = MakeActor(MakeMixture(true));
  actor->GetProperty()->SetLineWidth(3.0F);
  actor->GetProperty()->SetPointSize(6.0F);
  stage.Renderer->AddActor(actor);
  stage.Camera()->SetPosition(0.2, -0.3, 5.0);
  stage.Camera()->SetClippingRange(2.0, 8.0);
  vtkSmartPointer<vtkActor> linesOnly = MakeActor(MakeMixture(false));
  linesOnly->GetProperty()->DeepCopy(actor->GetProperty());
  const Picture both = stage.Draw(nullptr);
  stage.Renderer->AddActor(linesOnly);
  actor->VisibilityOff();
  const Picture lines = stage.Draw(nullptr);
  linesOnly->VisibilityOff();
  const Picture empty = stage.Draw(nullptr);
  actor->VisibilityOn();
  vtkNew<AOPass> pass;
  pass->SetModulationToAll();
  ForceVisibility(pass, 0.0);
  const Picture dark = stage.Draw(pass);
  const Mask onLines = [&](int x, int y)
  { return DifferenceAt(lines, empty, x, y) > 0.0 && DifferenceAt(lines, both, x, y) == 0.0; };
  report.Same("lines and vertices beside faces, V 0", both, dark, 0.0, onLines, 300);
  report.Differ(
    "faces beside lines, V 0", both, dark, 0.2, 300, [&](int x, int y) { return !onLines(x, y); });
}

//------------------------------------------------------------------------------
// A square on the floor, in its very plane, and its outline.
void AddCoincident(Stage& stage)
{
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPlaneSource> square;
    square->SetOrigin(-0.8, 1.2 - 2.0 * i, -0.4);
    square->SetPoint1(2.5, 1.2 - 2.0 * i, -0.4);
    square->SetPoint2(-0.8, 2.6 - 2.0 * i, -0.4);
    square->SetResolution(4, 4);
    square->Update();
    vtkSmartPointer<vtkActor> actor = MakeActor(square->GetOutput());
    actor->GetProperty()->SetColor(0.3, 0.7, 0.9);
    if (i == 0)
    {
      actor->GetProperty()->SetRepresentationToWireframe();
    }
    else
    {
      actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -2.0);
    }
    stage.Renderer->AddActor(actor);
  }
}

//------------------------------------------------------------------------------
// Bodies cut open by the mapper, of which the inside is seen.
void AddClipped(Stage& stage)
{
  for (int i = 0; i < 3; ++i)
  {
    vtkSmartPointer<vtkActor> actor = MakeActor(MakeSphere(0.45));
    for (int j = 0; j <= i; ++j)
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(0.35 + 0.8 * i, 0.4 + 0.3 * i, 0.9);
      plane->SetNormal(0.2 + j, -0.4, j - 0.9);
      actor->GetMapper()->AddClippingPlane(plane);
    }
    Add(stage, actor, i);
  }
}

//------------------------------------------------------------------------------
// Shaders changed by the program: after lighting, of the vertices, and instead of lighting.
void AddReplacements(Stage& stage)
{
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkActor> actor = MakeActor(MakeSphere(0.35));
    vtkShaderProperty* shader = actor->GetShaderProperty();
    if (i == 0)
    {
      shader->AddFragmentShaderReplacement("//VTK::Light::Impl", false,
        "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].bgr * 0.7;\n", false);
    }
    else if (i == 1)
    {
      shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
        "//VTK::PositionVC::Impl\n  gl_Position.x += 0.2 * sin(20.0 * vertexMC.y);\n", false);
    }
    else if (i == 2)
    {
      // As a mapper of materials does: the tag of lighting is used up.
      shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
        "  gl_FragData[0] = vec4(normalVCVSOutput * 0.5 + 0.5, 1.0);\n", false);
    }
    else
    {
      shader->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
        "//VTK::Color::Impl\n  diffuseColor = vec3(0.9, 0.2, 0.5) * fract(vertexVC.x * 5.0);\n",
        false);
    }
    Add(stage, actor, i);
  }
}

//------------------------------------------------------------------------------
void AddLevels(Stage& stage)
{
  // Time for the finest level, always: choices by time differ from frame to frame.
  stage.Window->SetDesiredUpdateRate(1.0e-9);
  vtkNew<vtkLODActor> cloud;
  cloud->SetMapper(MakeActor(MakeSphere(0.4))->GetMapper());
  Add(stage, cloud);
  vtkNew<vtkLODProp3D> levels;
  levels->AddLOD(MakeActor(MakeSphere(0.4))->GetMapper(), 0.0);
  const int coarse = levels->AddLOD(MakeActor(MakeSphere(0.4, 6))->GetMapper(), 0.0);
  levels->AutomaticLODSelectionOff();
  levels->SetSelectedLODID(coarse);
  Add(stage, levels, 1);
}

//------------------------------------------------------------------------------
// An assembly in an assembly, one of props, and axes made of parts.
void AddAssemblies(Stage& stage)
{
  vtkNew<vtkAssembly> inner;
  inner->AddPart(MakeActor(MakeSphere(0.3)));
  vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.35));
  glass->SetPosition(0.3, 0.0, 0.2);
  glass->GetProperty()->SetOpacity(0.5);
  inner->AddPart(glass);
  inner->RotateY(30.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  vtkSmartPointer<vtkActor> wires = MakeActor(MakeSphere(0.4, 8));
  wires->GetProperty()->SetRepresentationToWireframe();
  outer->AddPart(wires);
  outer->SetScale(1.0, -1.2, 0.9);
  Add(stage, outer);
  vtkNew<vtkPropAssembly> props;
  vtkSmartPointer<vtkActor> part = MakeActor(MakeSphere(0.3));
  part->SetPosition(2.0, 0.3, 0.8);
  props->AddPart(part);
  stage.Renderer->AddViewProp(props);
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(0.8, 0.8, 0.8);
  stage.Renderer->AddActor(axes);
}
}

//------------------------------------------------------------------------------
int TestHarmlessMappers(int, char*[])
{
  Report report;
  HarmlessOptions surfaces; // the props of the case are lit surfaces too
  surfaces.OnlySurfaces = false;
  CheckHarmless(report, "stick mapper", AddSticks, surfaces);
  CheckHarmless(report, "point Gaussians", [](Stage& stage) { AddGaussians(stage, false, false); });
  CheckHarmless(
    report, "point Gaussians, emissive", [](Stage& stage) { AddGaussians(stage, true, false); },
    surfaces); // they add light to the surfaces
  CheckHarmless(
    report, "point Gaussians, opaque", [](Stage& stage) { AddGaussians(stage, false, true); });
  CheckHarmless(report, "composite data, hidden, glass and coloured blocks", AddBlocks, surfaces);
  CheckHarmless(
    report, "faces, lines and vertices in one", [](Stage& stage) { AddMixture(stage, true); },
    surfaces);
  CheckHarmless(report, "lit lines and vertices", [](Stage& stage) { AddMixture(stage, false); });
  CheckMixture(report);
  const char* const ways[] = { "off", "polygon offset", "shifted depths" };
  for (const int way : { VTK_RESOLVE_OFF, VTK_RESOLVE_POLYGON_OFFSET, VTK_RESOLVE_SHIFT_ZBUFFER })
  {
    vtkMapper::SetResolveCoincidentTopology(way);
    CheckHarmless(
      report, std::string("coincident topology, ") + ways[way], AddCoincident, surfaces);
  }
  // It is the setting of all mappers. With polygon offset, VTK 9.6 draws lines as tubes at depths
  // of chance: their shader reads gl_FragDepth before it writes it.
  vtkMapper::SetResolveCoincidentTopologyToDefault();
  CheckHarmless(report, "clipping planes", AddClipped, surfaces);
  CheckHarmless(report, "shader replacements", AddReplacements, surfaces);
  HarmlessOptions levels = surfaces;
  levels.Quiet = true; // vtkLODActor copies its mapper by methods that VTK calls deprecated
  CheckHarmless(report, "levels of detail", AddLevels, levels);
  CheckHarmless(report, "assemblies", AddAssemblies, surfaces);
  CheckHarmless(report, "unlit, wireframe, points, lines, image",
    [](Stage& stage)
    {
      Grid grid(3);
      AddUnlitProps(stage.Renderer, grid);
    });
  CheckHarmless(
    report, "opaque lit props of every kind",
    [](Stage& stage)
    {
      Grid grid(6);
      LightParts parts;
      AddLitProps(stage.Renderer, grid, parts);
      grid.Look(stage.Renderer);
    },
    surfaces);
  CheckHarmless(
    report, "PBR, image-based light, normal maps",
    [](Stage& stage)
    {
      Grid grid(4);
      AddPhysicalActors(stage.Renderer, grid);
      SetEnvironment(stage.Renderer);
      stage.Renderer->UseImageBasedLightingOn();
      grid.Look(stage.Renderer);
    },
    surfaces);
  return report.GetResult();
}
