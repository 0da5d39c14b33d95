// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Opaque lit props of every kind for the tests of modulation, in the squares of a grid.
 */

#ifndef vtkSSAOTestProps_h
#define vtkSSAOTestProps_h

#include "vtkSSAOTestScenes.h"

#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLODProp3D.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPolyDataTangents.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkStripper.h"

namespace vtkSSAOTest
{
//------------------------------------------------------------------------------
/// Coefficients and colours that differ in every channel.
inline void SetHues(vtkProperty* property, double ambient, double diffuse, double specular)
{
  property->SetAmbient(ambient);
  property->SetDiffuse(diffuse);
  property->SetSpecular(specular);
  property->SetSpecularPower(20.0);
  property->SetAmbientColor(0.9, 0.3, 0.1);
  property->SetDiffuseColor(0.2, 0.6, 0.9);
  property->SetSpecularColor(1.0, 0.9, 0.5);
}

//------------------------------------------------------------------------------
/// Opaque lit props that are not physically based. Their coefficients become part of parts.
inline void AddLitProps(vtkRenderer* renderer, Grid& grid, LightParts& parts)
{
  const auto add = [&](vtkActor* actor, double ambient = 0.3, double diffuse = 0.5)
  {
    SetHues(actor->GetProperty(), ambient, diffuse, 0.2);
    parts.Add(actor->GetProperty());
    grid.Place(actor);
    renderer->AddActor(actor);
  };

  // One colour for ambient and diffuse light, different ones, and VTK's default material.
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere();
  add(MakeActor(sphere));
  vtkSmartPointer<vtkActor> plain = MakeActor(sphere);
  add(plain, 0.0, 1.0);
  plain->GetProperty()->SetColor(0.8, 0.7, 0.6);
  vtkSmartPointer<vtkActor> overbright = MakeActor(sphere);
  add(overbright, 0.8, 1.0);

  // Textures of three colours and of one.
  for (const int components : { 3, 1 })
  {
    vtkSmartPointer<vtkPolyData> mapped = MakeSphere();
    AddTextureCoordinates(mapped);
    vtkSmartPointer<vtkActor> textured = MakeActor(mapped);
    textured->SetTexture(MakeWavesTexture(components));
    // Bright enough that the colour before the texture exceeds 1.
    add(textured, 0.5, 0.8);
  }

  // Two textures of which one is subtracted: some colours fall below 0.
  vtkSmartPointer<vtkPolyData> twice = MakeSphere();
  AddTextureCoordinates(twice);
  vtkSmartPointer<vtkActor> subtracted = MakeActor(twice);
  subtracted->SetTexture(MakeWavesTexture());
  vtkSmartPointer<vtkTexture> other = MakeTexture(16, 3,
    [](double s, double t) {
      return std::array<double, 4>{ s, t, 0.1, 1.0 };
    });
  other->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_SUBTRACT);
  subtracted->GetProperty()->SetTexture("subtracted", other);
  add(subtracted, 0.5, 0.8);

  // Colours by point, by cell, and through a lookup table before and after interpolation.
  for (int i = 0; i < 4; ++i)
  {
    vtkSmartPointer<vtkPolyData> colored = MakeSphere();
    vtkDataSetAttributes* data =
      i == 1 ? static_cast<vtkDataSetAttributes*>(colored->GetCellData()) : colored->GetPointData();
    vtkSmartPointer<vtkActor> actor = MakeActor(colored);
    actor->GetMapper()->ScalarVisibilityOn();
    if (i < 2)
    {
      data->SetScalars(MakeColors(i ? colored->GetNumberOfCells() : colored->GetNumberOfPoints()));
    }
    else
    {
      vtkNew<vtkFloatArray> heights;
      for (vtkIdType j = 0; j < colored->GetNumberOfPoints(); ++j)
      {
        heights->InsertNextValue(static_cast<float>(colored->GetPoint(j)[1]));
      }
      data->SetScalars(heights);
      actor->GetMapper()->SetScalarRange(-0.45, 0.45);
      actor->GetMapper()->SetInterpolateScalarsBeforeMapping(i == 3);
    }
    add(actor);
  }

  // Shading: flat, Gouraud, normals by cell, no normals at all, triangle strips.
  vtkSmartPointer<vtkActor> flat = MakeActor(MakeSphere(0.45, 10));
  flat->GetProperty()->SetInterpolationToFlat();
  add(flat);
  vtkSmartPointer<vtkActor> gouraud = MakeActor(sphere);
  gouraud->GetProperty()->SetInterpolationToGouraud();
  add(gouraud);
  vtkSmartPointer<vtkPolyData> facets = WithoutNormals(MakeSphere(0.45, 8));
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < facets->GetNumberOfCells(); ++i)
  {
    const double* bounds = facets->GetCell(i)->GetBounds();
    double middle[3] = { bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5] };
    vtkMath::Normalize(middle);
    normals->InsertNextTuple(middle);
  }
  facets->GetCellData()->SetNormals(normals);
  add(MakeActor(facets));
  add(MakeActor(WithoutNormals(sphere)));
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  add(MakeActor(stripper->GetOutput()));

  // An open bowl that shows its back, of another material.
  vtkNew<vtkSphereSource> bowl;
  bowl->SetRadius(0.45);
  bowl->SetEndTheta(180.0);
  bowl->SetThetaResolution(16);
  bowl->SetPhiResolution(16);
  bowl->Update();
  vtkSmartPointer<vtkActor> open = MakeActor(bowl->GetOutput());
  vtkNew<vtkProperty> back;
  SetHues(back, 0.5, 0.3, 0.1);
  back->SetDiffuseColor(0.9, 0.8, 0.1);
  parts.Add(back);
  open->SetBackfaceProperty(back);
  open->RotateX(40.0);
  add(open);

  // Cut by a plane.
  vtkSmartPointer<vtkActor> cut = MakeActor(sphere);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.4, -0.3);
  plane->SetOrigin(grid.X() - 0.1, grid.Y(), 0.0);
  cut->GetMapper()->AddClippingPlane(plane);
  add(cut);

  // Impostors: sphere mapper, points as spheres, lines as tubes.
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    places->InsertNextPoint(0.3 * std::cos(1.3 * i), 0.3 * std::sin(1.3 * i), 0.05 * i);
    vertices->InsertNextCell(1, &i);
    const vtkIdType line[2] = { i, (i + 2) % 5 };
    lines->InsertNextCell(2, line);
  }
  points->SetPoints(places);
  points->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> spheres;
  spheres->SetInputData(points);
  spheres->SetRadius(0.15F);
  vtkNew<vtkActor> balls;
  balls->SetMapper(spheres);
  add(balls);
  // This mapper bakes the mixture of the three colours into its points.
  balls->GetProperty()->SetColor(0.7, 0.5, 0.4);
  vtkSmartPointer<vtkActor> sprites = MakeActor(points);
  sprites->GetProperty()->SetPointSize(12.0F);
  sprites->GetProperty()->RenderPointsAsSpheresOn();
  add(sprites);
  vtkNew<vtkPolyData> wires;
  wires->SetPoints(places);
  wires->SetLines(lines);
  vtkSmartPointer<vtkActor> tubes = MakeActor(wires);
  tubes->GetProperty()->SetLineWidth(9.0F);
  tubes->GetProperty()->RenderLinesAsTubesOn();
  add(tubes);

  // Glyphs.
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(points);
  glyphs->SetSourceConnection(cube->GetOutputPort());
  glyphs->SetScaleFactor(0.25);
  glyphs->ScalarVisibilityOff();
  vtkNew<vtkActor> cubes;
  cubes->SetMapper(glyphs);
  cubes->RotateX(30.0);
  add(cubes);

  // Blocks, one with a colour of its own.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeSphere(0.3, 12));
  vtkNew<vtkSphereSource> second;
  second->SetCenter(0.15, 0.15, 0.1);
  second->SetRadius(0.25);
  second->Update();
  blocks->SetBlock(1, second->GetOutput());
  vtkNew<vtkSSAOTestCompositeMapper> composite;
  composite->SetInputDataObject(blocks);
  composite->ScalarVisibilityOff();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  composite->SetCompositeDataDisplayAttributes(attributes);
  composite->SetBlockColor(2, 0.9, 0.5, 0.2);
  vtkNew<vtkActor> both;
  both->SetMapper(composite);
  add(both);

  // Assemblies, followers and levels of detail draw through actors of their own.
  vtkNew<vtkAssembly> assembly;
  for (int i = 0; i < 2; ++i)
  {
    vtkSmartPointer<vtkActor> part = MakeActor(MakeSphere(0.25, 12));
    part->SetPosition(i ? 0.2 : -0.2, 0.0, 0.0);
    SetHues(part->GetProperty(), 0.3, i ? 0.3 : 0.6, 0.2);
    parts.Add(part->GetProperty());
    assembly->AddPart(part);
  }
  grid.Place(assembly);
  renderer->AddActor(assembly);
  vtkNew<vtkFollower> follower;
  follower->SetMapper(MakeActor(MakeSphere(0.4, 6))->GetMapper());
  follower->SetCamera(renderer->GetActiveCamera());
  add(follower);
  vtkNew<vtkLODProp3D> levels;
  vtkNew<vtkProperty> leveled;
  SetHues(leveled, 0.4, 0.4, 0.2);
  parts.Add(leveled);
  levels->AddLOD(MakeActor(sphere)->GetMapper(), leveled, 0.0);
  grid.Place(levels);
  renderer->AddViewProp(levels);
}

//------------------------------------------------------------------------------
/// A sphere with tangents and texture coordinates, as normal maps and anisotropy need.
inline vtkSmartPointer<vtkPolyData> MakeTangentSphere()
{
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere();
  AddTextureCoordinates(sphere);
  vtkNew<vtkPolyDataTangents> tangents;
  tangents->SetInputData(sphere);
  tangents->Update();
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(tangents->GetOutput());
  return result;
}

//------------------------------------------------------------------------------
/// Physically based actors, in the order of the squares. Metallic is 0 or 1 everywhere.
inline std::vector<vtkSmartPointer<vtkActor>> AddPhysicalActors(vtkRenderer* renderer, Grid& grid)
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  const auto add = [&](vtkActor* actor)
  {
    vtkProperty* property = actor->GetProperty();
    property->SetInterpolationToPBR();
    property->SetColor(0.8, 0.5, 0.3);
    property->SetRoughness(0.4);
    actors.emplace_back(actor);
    grid.Place(actor);
    renderer->AddActor(actor);
    return property;
  };
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere();
  vtkSmartPointer<vtkPolyData> tangents = MakeTangentSphere();

  // Dielectric, metal, clear coat, anisotropy, and without normals.
  add(MakeActor(sphere));
  add(MakeActor(sphere))->SetMetallic(1.0);
  vtkProperty* coated = add(MakeActor(sphere));
  coated->SetCoatStrength(0.8);
  coated->SetCoatRoughness(0.2);
  coated->SetCoatColor(0.9, 1.0, 0.7);
  vtkProperty* brushed = add(MakeActor(tangents));
  brushed->SetAnisotropy(0.7);
  brushed->SetAnisotropyRotation(0.2);
  add(MakeActor(WithoutNormals(sphere)));

  // Textures of colour, of occlusion, roughness and metal, of emission, of normals.
  vtkProperty* textured = add(MakeActor(tangents));
  vtkSmartPointer<vtkTexture> base = MakeWavesTexture();
  base->UseSRGBColorSpaceOn();
  textured->SetBaseColorTexture(base);
  textured->SetORMTexture(MakeTexture(8, 3,
    [](double s, double t) {
      return std::array<double, 4>{ 0.4 + 0.5 * s, 0.3 + 0.5 * t, 0.0, 1.0 };
    }));
  textured->SetOcclusionStrength(0.7);
  textured->SetRoughness(1.0);
  vtkProperty* emissive = add(MakeActor(tangents));
  vtkSmartPointer<vtkTexture> glow = MakeWavesTexture();
  glow->UseSRGBColorSpaceOn();
  emissive->SetEmissiveTexture(glow);
  emissive->SetEmissiveFactor(0.2, 0.1, 0.3);
  vtkProperty* bumpy = add(MakeActor(tangents));
  bumpy->SetNormalTexture(MakeTexture(16, 3,
    [](double s, double t)
    {
      return std::array<double, 4>{ 0.5 + 0.2 * std::sin(30.0 * s), 0.5 + 0.2 * std::cos(30.0 * t),
        0.95, 1.0 };
    }));

  // Colours by point, and glyphs.
  vtkSmartPointer<vtkPolyData> colored = MakeSphere();
  colored->GetPointData()->SetScalars(MakeColors(colored->GetNumberOfPoints()));
  vtkSmartPointer<vtkActor> painted = MakeActor(colored);
  painted->GetMapper()->ScalarVisibilityOn();
  add(painted);
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(-0.2, 0.0, 0.0);
  places->InsertNextPoint(0.2, 0.1, 0.0);
  points->SetPoints(places);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(points);
  glyphs->SetSourceData(MakeSphere(0.25, 12));
  glyphs->ScalingOff();
  glyphs->ScalarVisibilityOff();
  vtkNew<vtkActor> pair;
  pair->SetMapper(glyphs);
  add(pair);
  return actors;
}
}

#endif
