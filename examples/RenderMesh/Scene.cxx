// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"
#include "MeshFile.h"
#include "Messages.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkGLTFImporter.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPeriodicTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace rendermesh
{
namespace
{
vtkDataArray* AtomicNumbers(vtkPolyData* mesh)
{
  for (const char* name : { "atomic_number", "atom_type", "Atomic Numbers" })
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(name);
    if (array && array->GetNumberOfComponents() == 1)
    {
      return array;
    }
  }
  return nullptr;
}

/// A copy of the points with a radius each and, for atoms, the colour of their element.
vtkSmartPointer<vtkPolyData> MakeSpheres(
  vtkPolyData* mesh, const Settings& settings, double& largestRadius)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* atoms = AtomicNumbers(mesh);
  vtkNew<vtkPeriodicTable> table;
  vtkNew<vtkFloatArray> radii;
  radii->SetName("sphere_radius");
  radii->SetNumberOfTuples(count);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("element_color");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  const double automatic = 0.4 * mesh->GetLength() / std::cbrt(static_cast<double>(count));
  largestRadius = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double radius = automatic;
    if (atoms)
    {
      const double number = atoms->GetComponent(i, 0);
      const bool known = number >= 1 && number <= table->GetNumberOfElements();
      const auto element = static_cast<unsigned short>(known ? number : 0);
      radius = table->GetVDWRadius(element);
      float rgb[3];
      table->GetDefaultRGBTuple(element, rgb);
      for (int c = 0; c < 3; ++c) // softened, so that the shading stays the stronger signal
      {
        colors->SetTypedComponent(i, c, static_cast<unsigned char>(255.0 * (0.55 + 0.45 * rgb[c])));
      }
    }
    radius = settings.PointRadius > 0.0 ? settings.PointRadius : radius;
    radii->SetValue(i, static_cast<float>(radius));
    largestRadius = std::max(largestRadius, radius);
  }
  auto spheres = vtkSmartPointer<vtkPolyData>::New();
  spheres->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> vertices; // without cells the mapper would have no bounds
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  spheres->SetVerts(vertices);
  spheres->GetPointData()->ShallowCopy(mesh->GetPointData());
  spheres->GetPointData()->SetActiveScalars(nullptr);
  spheres->GetPointData()->AddArray(radii);
  if (atoms)
  {
    spheres->GetPointData()->SetScalars(colors);
  }
  return spheres;
}

/// Whole numbers of a small range get colours that are easy to tell apart, others a ramp.
vtkSmartPointer<vtkScalarsToColors> MakeColors(vtkDataArray* array)
{
  double range[2];
  array->GetRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
  const int type = array->GetDataType();
  if (type != VTK_FLOAT && type != VTK_DOUBLE && range[1] - range[0] < 32.0)
  {
    const int classes = static_cast<int>(range[1] - range[0]) + 1;
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(classes);
    table->SetRange(range[0] - 0.5, range[1] + 0.5);
    for (int i = 0; i < classes; ++i)
    {
      double rgb[3]; // hues by the golden ratio, so that neighbours differ
      vtkMath::HSVToRGB(
        std::fmod(0.1 + 0.618034 * i, 1.0), 0.3, i % 2 == 0 ? 0.95 : 0.85, rgb, rgb + 1, rgb + 2);
      table->SetTableValue(i, rgb[0], rgb[1], rgb[2]);
    }
    return table;
  }
  const double ramp[5][3] = { { 0.27, 0.20, 0.49 }, { 0.23, 0.42, 0.60 }, { 0.20, 0.62, 0.59 },
    { 0.53, 0.80, 0.43 }, { 0.98, 0.91, 0.35 } };
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->SetVectorModeToMagnitude();
  for (int i = 0; i < 5; ++i)
  {
    function->AddRGBPoint(
      range[0] + 0.25 * i * (range[1] - range[0]), ramp[i][0], ramp[i][1], ramp[i][2]);
  }
  return function;
}

void ChooseColors(vtkMapper* mapper, vtkPolyData* mesh, const Settings& settings)
{
  vtkDataSetAttributes* owner = mesh->GetPointData();
  vtkDataArray* array = nullptr;
  if (!settings.ColorBy.empty())
  {
    array = owner->GetArray(settings.ColorBy.c_str());
    if (!array)
    {
      owner = mesh->GetCellData();
      array = owner->GetArray(settings.ColorBy.c_str());
    }
    if (!array)
    {
      throw Failure("option --color-by: the mesh has no array " + Quoted(settings.ColorBy));
    }
  }
  else if (!settings.Color) // colours of the file, if it has any
  {
    array = owner->GetScalars();
    array =
      array && array->GetDataType() == VTK_UNSIGNED_CHAR && array->GetNumberOfComponents() >= 3
      ? array
      : nullptr;
  }
  mapper->SetScalarVisibility(array != nullptr);
  if (array)
  {
    owner->SetActiveScalars(array->GetName());
    const bool cells = owner != mesh->GetPointData();
    mapper->SetScalarMode(cells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
    if (array->GetDataType() != VTK_UNSIGNED_CHAR || array->GetNumberOfComponents() < 3)
    {
      mapper->SetColorModeToMapScalars();
      mapper->SetLookupTable(MakeColors(array));
      mapper->UseLookupTableScalarRangeOn();
    }
  }
}

/// A mesh as one actor: polygons as they are, lines as tubes, points and atoms as spheres.
void AddMesh(vtkSmartPointer<vtkPolyData> mesh, const Settings& settings, Scene& scene)
{
  scene.Summary = std::to_string(mesh->GetNumberOfPoints()) + " points";
  vtkSmartPointer<vtkPolyDataMapper> mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  const bool polygons = mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
  if (polygons)
  {
    scene.Summary +=
      ", " + std::to_string(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips()) + " polygons";
    if (settings.FeatureAngle > 0.0 && !mesh->GetPointData()->GetNormals())
    {
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputData(mesh);
      normals->ConsistencyOff();
      normals->SetFeatureAngle(settings.FeatureAngle);
      Update(normals, "computing normals", settings.Quiet);
      mesh = normals->GetOutput();
    }
  }
  else if (mesh->GetNumberOfLines() > 0 && !AtomicNumbers(mesh))
  {
    scene.Summary += ", " + std::to_string(mesh->GetNumberOfLines()) + " lines as tubes";
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(mesh);
    tubes->SetNumberOfSides(16);
    tubes->CappingOn();
    tubes->SetRadius(settings.TubeRadius > 0.0 ? settings.TubeRadius : 0.004 * mesh->GetLength());
    Update(tubes, "making tubes", settings.Quiet);
    mesh = tubes->GetOutput();
  }
  else
  {
    scene.Summary += AtomicNumbers(mesh) ? " as atoms" : " as spheres";
    mesh = MakeSpheres(mesh, settings, scene.Margin);
    auto spheres = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
    spheres->SetScaleArray("sphere_radius");
    mapper = spheres;
  }
  mapper->SetInputData(mesh);
  ChooseColors(mapper, mesh, settings);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* material = actor->GetProperty();
  const vtkVector3d color = settings.Color.value_or(vtkVector3d(0.85, 0.83, 0.8));
  material->SetColor(color[0], color[1], color[2]);
  material->SetAmbient(settings.Ambient);
  material->SetDiffuse(settings.Diffuse);
  material->SetSpecular(settings.Specular);
  material->SetSpecularPower(30.0);
  scene.Renderer->AddActor(actor);
}

/// A sky that is bright above and dim below: image-based light for PBR materials.
void AddSky(vtkRenderer* renderer)
{
  vtkNew<vtkImageData> sky;
  sky->SetDimensions(64, 32, 1);
  sky->AllocateScalars(VTK_FLOAT, 3);
  for (int row = 0; row < 32; ++row)
  {
    const double t = row / 31.0; // 0 below, 1 above
    for (int column = 0; column < 64; ++column)
    {
      sky->SetScalarComponentFromDouble(column, row, 0, 0, 0.2 + 0.5 * t);
      sky->SetScalarComponentFromDouble(column, row, 0, 1, 0.19 + 0.56 * t);
      sky->SetScalarComponentFromDouble(column, row, 0, 2, 0.18 + 0.62 * t);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(sky);
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  renderer->SetEnvironmentTexture(texture);
  renderer->SetEnvironmentUp(0.0, 1.0, 0.0);
  renderer->UseImageBasedLightingOn();
}

/// A glTF scene with its own materials.
void ImportGltf(const Settings& settings, Scene& scene)
{
  const std::string failed = "cannot read " + Quoted(settings.Input);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(settings.Input.c_str());
  importer->SetRenderWindow(scene.Window);
  {
    Progress progress(importer, "reading " + settings.Input, settings.Quiet);
    ReaderGuard guard(failed);
    importer->Update();
  }
  CheckMessages(failed);
  bool physicallyBased = false;
  vtkIdType points = 0;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    actor->GetMapper()->Update();
    auto mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
    CheckMesh(mesh, settings.Input);
    points += mesh->GetNumberOfPoints();
    physicallyBased = physicallyBased || actor->GetProperty()->GetInterpolation() == VTK_PBR;
  }
  if (actors->GetNumberOfItems() == 0)
  {
    throw Failure("the mesh in " + Quoted(settings.Input) + " is empty: it has no surfaces");
  }
  if (physicallyBased)
  {
    AddSky(scene.Renderer);
  }
  scene.Summary =
    std::to_string(actors->GetNumberOfItems()) + " surfaces, " + std::to_string(points) + " points";
}
}

//------------------------------------------------------------------------------
void LoadScene(const Settings& settings, Scene& scene)
{
  if (IsGltf(settings.Input))
  {
    ImportGltf(settings, scene);
  }
  else
  {
    AddMesh(LoadMesh(settings), settings, scene);
  }
}
}
