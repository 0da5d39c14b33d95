// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What is gathered from a renderer: props, matrices, mappers, normals, culling, clipping.
 */

#include "UnitTestTruthCommon.h"

#include "vtkAssembly.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkProperty.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <cstdlib>

namespace
{
using namespace TruthTest;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeBox()
{
  vtkNew<vtkCubeSource> box;
  box->Update();
  return box->GetOutput();
}

//------------------------------------------------------------------------------
bool CheckCount(const std::string& what, std::size_t expected, std::size_t actual)
{
  return CheckNear(what, static_cast<double>(expected), static_cast<double>(actual), 0.0);
}

//------------------------------------------------------------------------------
// A look along -z at the square [-1, 1]^2, in parallel; the hit of the middle pixel.
TracedView LookDown(vtkRenderer* renderer, int size = 21)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetClippingRange(0.1, 10.0);
  renderer->SetActiveCamera(camera);
  vtkSSAOTruthTracer tracer;
  tracer.SetRaysPerPixel(16);
  return TracedView(renderer, size, size, tracer);
}

//------------------------------------------------------------------------------
std::size_t CountHits(const TracedView& view)
{
  std::size_t hits = 0;
  for (unsigned char hit : view.Image.Hit)
  {
    hits += hit;
  }
  return hits;
}

//------------------------------------------------------------------------------
bool TestProps()
{
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkPolyData> box = MakeBox();
  AddPolyData(renderer, box);
  AddPolyData(renderer, box)->VisibilityOff();
  AddPolyData(renderer, box)->GetProperty()->SetOpacity(0.5);
  AddPolyData(renderer, box)->GetProperty()->SetRepresentationToWireframe();
  AddPolyData(renderer, box)->GetProperty()->SetRepresentationToPoints();
  vtkNew<vtkActor> withoutMapper;
  renderer->AddActor(withoutMapper);
  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  bool good = CheckCount(
    "triangles of what is visible, opaque and a surface", 12, scene.GetNumberOfTriangles());

  vtkNew<vtkPolyData> bare;
  bare->SetPoints(box->GetPoints());
  vtkNew<vtkOpenGLSphereMapper> bareMapper;
  bareMapper->SetInputData(bare);
  vtkNew<vtkActor> bareActor;
  bareActor->SetMapper(bareMapper);
  renderer->AddActor(bareActor);
  scene.Gather(renderer);
  good &=
    CheckCount("points without cells, which VTK does not draw", 0, scene.GetNumberOfSpheres());

  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputData(box);
  vtkNew<vtkActor> actor;
  actor->SetMapper(splats);
  renderer->AddActor(actor);
  scene.Gather(renderer);
  good &= CheckTrue("a mapper that is not understood is named",
    scene.GetSkipped().size() == 1 &&
      scene.GetSkipped()[0].find("PointGaussianMapper") != std::string::npos);
  return good;
}

//------------------------------------------------------------------------------
// Matrices of assemblies within assemblies, and user matrices.
bool TestMatrices()
{
  vtkNew<vtkRenderer> pool;
  vtkSmartPointer<vtkActor> part =
    AddPolyData(pool, MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }));
  part->AddPosition(0.0, 0.0, 3.0);
  vtkNew<vtkTransform> user;
  user->Scale(2.0, 2.0, 2.0);
  part->SetUserMatrix(user->GetMatrix());
  vtkNew<vtkAssembly> inner;
  inner->AddPart(part);
  inner->RotateZ(90.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  outer->AddPosition(10.0, 0.0, 0.0);
  vtkNew<vtkRenderer> renderer;
  renderer->AddViewProp(outer);
  SetCamera(renderer, false, { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 0.0 }, 1.0, 30.0);

  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  bool good = CheckCount("triangles of an assembly", 1, scene.GetNumberOfTriangles());
  if (!good)
  {
    return false;
  }
  // (1, 0, 0): + (0, 0, 3), x 2, turned by 90 degrees, + (10, 0, 0), seen from the camera.
  const double expected[3] = { 10.0 - 1.0, 2.0 - 2.0, 6.0 - 3.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    good &= CheckNear(
      "coordinate of a part", expected[axis], scene.GetMeshes()[0].Points[3 + axis], 1e-12);
  }
  return good;
}

//------------------------------------------------------------------------------
// A polygon that VTK cuts as a fan, and a strip, with cell normals that must find their triangles.
bool TestCells()
{
  vtkSmartPointer<vtkPolyData> data =
    MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, 1, 0 }, { 0.5, 2, 0 }, { -0.5, 1, 0 },
                   { 3, 0, 0 }, { 3, 1, 0 }, { 4, 0, 0 }, { 4, 1, 0 } },
      { { 0, 1, 2, 3, 4 } });
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[] = { 5, 7, 6, 8 };
  strips->InsertNextCell(4, strip);
  data->SetStrips(strips);
  vtkNew<vtkCellArray> lines;
  const vtkIdType line[] = { 0, 1 };
  lines->InsertNextCell(2, line);
  data->SetLines(lines);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0.0, 0.0, 0.0); // the line
  normals->InsertNextTuple3(0.0, 0.6, 0.8); // the polygon
  normals->InsertNextTuple3(0.6, 0.0, 0.8); // the strip
  data->GetCellData()->SetNormals(normals);

  vtkNew<vtkRenderer> renderer;
  AddPolyData(renderer, data);
  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  bool good = CheckCount("triangles of a pentagon and a strip", 5, scene.GetNumberOfTriangles());
  if (!good)
  {
    return false;
  }
  const vtkSSAOTruthScene::Mesh& mesh = scene.GetMeshes()[0];
  const std::vector<unsigned int> expected = { 0, 1, 2, 0, 2, 3, 0, 3, 4, 5, 7, 6, 7, 8, 6 };
  // The second triangle of the strip may begin at any of its points.
  const std::vector<unsigned int> first(mesh.Triangles.begin(), mesh.Triangles.begin() + 12);
  good &= CheckTrue("fan and first triangle of the strip",
    first == std::vector<unsigned int>(expected.begin(), expected.begin() + 12));
  good &= CheckTrue("cell normals are used", mesh.Normal == vtkSSAOTruthScene::Mesh::CellNormals);
  for (int triangle = 0; triangle < 5; ++triangle)
  {
    good &= CheckNear(
      "x of the normal of a triangle", triangle < 3 ? 0.0 : 0.6, mesh.Normals[3 * triangle], 1e-6);
  }
  return good;
}

//------------------------------------------------------------------------------
// Blocks that are hidden or translucent, themselves or through their parent.
bool TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, MakeBox());
  group->SetBlock(1, MakeBox());
  vtkNew<vtkMultiBlockDataSet> all;
  all->SetBlock(0, MakeBox());
  all->SetBlock(1, group);
  all->SetBlock(2, MakeBox());
  vtkNew<vtkSSAOTestCompositeMapper> mapper;
  mapper->SetInputDataObject(all);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  bool good = CheckCount("triangles of four blocks", 48, scene.GetNumberOfTriangles());
  attributes->SetBlockVisibility(group, false);
  scene.Gather(renderer);
  good &= CheckCount("without a group of two", 24, scene.GetNumberOfTriangles());
  attributes->SetBlockOpacity(all->GetBlock(2), 0.5);
  scene.Gather(renderer);
  good &= CheckCount("without a translucent block", 12, scene.GetNumberOfTriangles());
  return good;
}

//------------------------------------------------------------------------------
// Glyphs of spheres: true spheres if they stay spheres, else triangles; and impostors.
bool TestSpheres()
{
  vtkSmartPointer<vtkPolyData> data = MakePoints({ { 0.0, 0.0, 0.0 }, { 1.0, 2.0, 3.0 } });
  vtkNew<vtkDoubleArray> scales;
  scales->SetName("scale");
  scales->InsertNextValue(1.0);
  scales->InsertNextValue(4.0);
  data->GetPointData()->AddArray(scales);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(8);
  sphere->SetPhiResolution(8);
  sphere->SetCenter(0.0, 0.0, 0.25);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(data);
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->SetScaleModeToScaleByMagnitude();
  glyphs->SetScaleArray("scale");
  glyphs->SetScaleFactor(0.5);
  vtkNew<vtkActor> actor;
  actor->SetMapper(glyphs);
  actor->SetScale(3.0);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  SetCamera(renderer, false, { 0.0, 0.0, 100.0 }, { 0.0, 0.0, 0.0 }, 1.0, 30.0);

  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  bool good = CheckCount("glyphs as spheres", 2, scene.GetNumberOfSpheres());
  good &= CheckCount("and no triangles", 0, scene.GetNumberOfTriangles());
  if (!good)
  {
    return false;
  }
  const vtkSSAOTruthScene::Spheres& set = scene.GetSpheres()[0];
  // radius 0.5, scaled by 4, 0.5 and 3; centre (1, 2, 3 + 4 x 0.5 x 0.25) x 3
  good &= CheckNear("radius of a glyph", 3.0, set.Radii[1], 1e-12);
  good &= CheckNear("x of a glyph", 3.0, set.Centers[3], 1e-12);
  good &= CheckNear("z of a glyph", 10.5 - 100.0, set.Centers[5], 1e-12);

  const std::size_t triangles =
    static_cast<std::size_t>(2 * sphere->GetOutput()->GetNumberOfPolys());
  actor->GetProperty()->SetInterpolationToFlat();
  scene.Gather(renderer);
  good &= CheckCount("flat glyphs as triangles", triangles, scene.GetNumberOfTriangles());
  actor->GetProperty()->SetInterpolationToGouraud();
  actor->SetScale(3.0, 3.0, 2.0);
  scene.Gather(renderer);
  good &= CheckCount("ellipsoids as triangles", triangles, scene.GetNumberOfTriangles());
  actor->SetScale(3.0);
  scene.SetTrueSphereGlyphs(false);
  scene.Gather(renderer);
  good &= CheckCount("all as triangles if so asked", triangles, scene.GetNumberOfTriangles());
  good &= CheckCount("and no spheres", 0, scene.GetNumberOfSpheres());

  vtkNew<vtkOpenGLSphereMapper> impostors;
  impostors->SetInputData(data);
  impostors->SetRadius(0.3f);
  actor->SetMapper(impostors);
  scene.Gather(renderer);
  good &= CheckNear("radius of an impostor, which the actor does not scale", 0.3,
    scene.GetSpheres()[0].Radii[1], 1e-6);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  radii->InsertNextValue(0.1f);
  radii->InsertNextValue(0.2f);
  data->GetPointData()->AddArray(radii);
  impostors->SetScaleArray("radius");
  scene.Gather(renderer);
  good &= CheckNear("radius of an impostor by array", 0.2, scene.GetSpheres()[0].Radii[1], 1e-6);
  good &= CheckNear("x of an impostor", 3.0, scene.GetSpheres()[0].Centers[3], 1e-6);
  return good;
}

//------------------------------------------------------------------------------
// Culled faces and what clipping planes cut away are not seen; unlit surfaces hide, no more.
bool TestDrawing()
{
  bool good = true;
  const std::size_t all = 21 * 21;
  {
    vtkNew<vtkRenderer> renderer;
    vtkSmartPointer<vtkActor> upper = AddPolyData(renderer, MakeFloor(2.0, 0.5));
    AddPolyData(renderer, MakeFloor(2.0, 0.0));
    upper->GetProperty()->BackfaceCullingOn();
    good &= CheckNear(
      "depth of a front face, back faces culled", 4.5, LookDown(renderer).Image.Depth[220], 1e-5);
    upper->GetProperty()->BackfaceCullingOff();
    upper->GetProperty()->FrontfaceCullingOn();
    const TracedView view = LookDown(renderer);
    good &= CheckNear("depth behind a culled front face", 5.0, view.Image.Depth[220], 1e-5);
    good &= CheckTrue("which still occludes", view.Image.Visibility[220] < 0.5f);
  }
  {
    vtkNew<vtkRenderer> renderer;
    vtkSmartPointer<vtkActor> upper = AddPolyData(renderer, MakeFloor(2.0, 0.5));
    AddPolyData(renderer, MakeFloor(2.0, 0.0));
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.05, 0.0, 0.0);
    plane->SetNormal(1.0, 0.0, 0.0);
    upper->GetMapper()->AddClippingPlane(plane);
    const TracedView view = LookDown(renderer);
    good &= CheckNear("depth where clipped", 5.0, view.Image.Depth[215], 1e-5);
    good &= CheckNear("depth where not clipped", 4.5, view.Image.Depth[225], 1e-5);
    good &= CheckTrue("what is left occludes", view.Image.Visibility[219] < 0.9f);
    good &= CheckTrue("what is cut away does not", view.Image.Visibility[211] > 0.9f);
  }
  {
    vtkNew<vtkRenderer> renderer;
    vtkSmartPointer<vtkActor> unlit = AddPolyData(renderer, MakeFloor(0.5, 0.5));
    AddPolyData(renderer, MakeFloor(2.0, 0.0));
    unlit->GetProperty()->LightingOff();
    const TracedView view = LookDown(renderer);
    good &= CheckCount("an unlit surface hides what is behind", all - 11 * 11, CountHits(view));
    good &= CheckNear("but does not occlude", 1.0, view.Image.Visibility[210 + 4], 0.0);
  }
  {
    // Between the clipping planes at depth 0.1 and 10 only.
    vtkNew<vtkRenderer> renderer;
    AddPolyData(renderer, MakeFloor(2.0, 4.95));
    AddPolyData(renderer, MakeFloor(2.0, -5.1));
    good &= CheckCount("surfaces outside the clipping range", 0, CountHits(LookDown(renderer)));
  }
  return good;
}

//------------------------------------------------------------------------------
// Normals: interpolated, turned for back faces, turned to the facet's side.
bool TestNormals()
{
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(i == 0 || i == 3 ? -1.0 : 1.0, 0.0, 1.0);
  }
  vtkSmartPointer<vtkPolyData> data = MakeFloor(1.0, 0.0);
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkActor> actor = AddPolyData(renderer, data);

  // Pixel centres of 20 are at -0.95, -0.85 ...: the normal is (x, 0, 1), of length 1.
  const auto check = [](const std::string& what, const TracedView& view, double sign)
  {
    bool fine = true;
    for (int x : { 0, 7, 19 })
    {
      const double position = (x + 0.5) / 10.0 - 1.0;
      const double length = std::hypot(position, 1.0);
      const float* normal = view.Image.Normal.data() + 3 * (20 * 10 + x);
      fine &= CheckNear(what + ", x", sign * position / length, normal[0], 1e-6);
      fine &= CheckNear(what + ", z", 1.0 / length, normal[2], 1e-6);
      fine &=
        CheckNear(what + ", facet z", 1.0, view.Image.GeometricNormal[3 * (20 * 10 + x) + 2], 1e-6);
    }
    return fine;
  };
  bool good = check("point normals", LookDown(renderer, 20), 1.0);
  actor->RotateX(180.0); // (x, 0, -1) on a back face: turned by the shader to (-x, 0, 1)
  good &= check("normals of a back face", LookDown(renderer, 20), -1.0);
  actor->RotateX(180.0);
  actor->SetScale(-1.0, 1.0, 1.0);
  // Mirrored: at x the normal (x, 0, 1), on what the rasteriser takes for a back face: turned to
  // (-x, 0, -1), away from the facet's side, and so turned again.
  good &= check("normals of a mirrored face", LookDown(renderer, 20), 1.0);
  actor->SetScale(1.0, 1.0, 1.0);
  actor->GetProperty()->SetInterpolationToFlat();
  const TracedView flat = LookDown(renderer, 20);
  good &= CheckNear("flat shading, x", 0.0, flat.Image.Normal[3 * 207], 1e-6);
  return good;
}

//------------------------------------------------------------------------------
bool TestDataSetMapper()
{
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(MakeBox());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkSSAOTruthScene scene;
  scene.Gather(renderer);
  return CheckCount("triangles of a vtkDataSetMapper", 12, scene.GetNumberOfTriangles());
}
}

//------------------------------------------------------------------------------
int UnitTestTruthScene(int, char*[])
{
  bool good = TestProps();
  good &= TestMatrices();
  good &= TestCells();
  good &= TestComposite();
  good &= TestSpheres();
  good &= TestDrawing();
  good &= TestNormals();
  good &= TestDataSetMapper();
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
