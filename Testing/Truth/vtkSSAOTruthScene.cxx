// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthScene.h"

#include "vtkSSAOTruthDigest.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkBitArray.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeDataSetRange.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkQuaternion.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkScalarsToColors.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <functional>

/**
 * One polydata as its mapper draws it, before any matrix.
 */
struct vtkSSAOTruthScene::DrawnSurface
{
  DrawnSurface(vtkPolyData* data, vtkProperty* property);

  vtkPolyData* Data;
  std::vector<unsigned int> Triangles;
  std::vector<vtkIdType> Cells; ///< the VTK cell of each triangle; only with cell normals
  vtkDataArray* Normals = nullptr;
  Mesh::NormalType Normal = Mesh::NoNormals;
};

//------------------------------------------------------------------------------
vtkSSAOTruthScene::DrawnSurface::DrawnSurface(vtkPolyData* data, vtkProperty* property)
  : Data(data)
{
  if (!data || !data->GetPoints() || property->GetRepresentation() != VTK_SURFACE)
  {
    return;
  }
  vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
    this->Triangles, data->GetPolys(), data->GetPoints(), 0, nullptr, nullptr);
  const std::size_t polyTriangles = this->Triangles.size() / 3;
  // AppendStripIndexBuffer reserves for the strips only.
  std::vector<unsigned int> strips;
  if (data->GetStrips()->GetNumberOfCells() > 0)
  {
    vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(strips, data->GetStrips(), 0, false);
    this->Triangles.insert(this->Triangles.end(), strips.begin(), strips.end());
  }

  // As vtkOpenGLPolyDataMapper::BuildBufferObjects and ReplaceShaderNormal choose.
  vtkDataArray* pointNormals = data->GetPointData()->GetNormals();
  vtkDataArray* cellNormals = data->GetCellData()->GetNormals();
  if (pointNormals && property->GetInterpolation() != VTK_FLAT)
  {
    this->Normals = pointNormals;
    this->Normal = Mesh::PointNormals;
  }
  else if (cellNormals)
  {
    this->Normals = cellNormals;
    this->Normal = Mesh::CellNormals;
    vtkCellArray* primitives[4] = { data->GetVerts(), data->GetLines(), data->GetPolys(),
      data->GetStrips() };
    vtkNew<vtkOpenGLCellToVTKCellMap> map;
    map->SetStartOffset(0);
    map->Update(primitives, VTK_SURFACE, data->GetPoints());
    const vtkIdType* offsets = map->GetPrimitiveOffsets();
    this->Cells.resize(this->Triangles.size() / 3);
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      this->Cells[i] =
        map->GetValue(i < polyTriangles ? offsets[2] + i : offsets[3] + (i - polyTriangles));
    }
  }
}

namespace
{
//------------------------------------------------------------------------------
// The arrays that vtkGlyph3DMapper and vtkOpenGLSphereMapper chose, which they show only to
// subclasses.
struct GlyphArrays : public vtkGlyph3DMapper
{
  static vtkDataArray* Mask(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphArrays::GetMaskArray))(data);
  }
  static vtkDataArray* Orientation(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphArrays::GetOrientationArray))(data);
  }
  static vtkDataArray* Scale(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphArrays::GetScaleArray))(data);
  }
  static vtkDataArray* SourceIndex(vtkGlyph3DMapper* mapper, vtkDataSet* data)
  {
    return (mapper->*(&GlyphArrays::GetSourceIndexArray))(data);
  }
};

struct SphereArrays : public vtkOpenGLSphereMapper
{
  static const char* Scale(vtkOpenGLSphereMapper* mapper)
  {
    return mapper->*(&SphereArrays::ScaleArray);
  }
};

//------------------------------------------------------------------------------
// Inverse transpose of the upper left 3 x 3 part, which turns normals.
void GetNormalMatrix(const double matrix[16], double normalMatrix[9])
{
  const double linear[9] = { matrix[0], matrix[1], matrix[2], matrix[4], matrix[5], matrix[6],
    matrix[8], matrix[9], matrix[10] };
  double inverse[9];
  vtkMatrix3x3::Invert(linear, inverse);
  vtkMatrix3x3::Transpose(inverse, normalMatrix);
}

//------------------------------------------------------------------------------
// If a matrix turns spheres into spheres: true, and the factor on radii.
bool GetUniformScale(const double matrix[16], double& scale)
{
  double products[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      products[i][j] =
        matrix[i] * matrix[j] + matrix[4 + i] * matrix[4 + j] + matrix[8 + i] * matrix[8 + j];
    }
  }
  const double square = products[0][0];
  const double tolerance = 1e-6 * square;
  scale = std::sqrt(square);
  return square > 0.0 && std::abs(products[1][1] - square) < tolerance &&
    std::abs(products[2][2] - square) < tolerance && std::abs(products[0][1]) < tolerance &&
    std::abs(products[0][2]) < tolerance && std::abs(products[1][2]) < tolerance;
}

//------------------------------------------------------------------------------
void TransformPoint(
  const double matrix[16], const double point[3], const double origin[3], double result[3])
{
  for (int row = 0; row < 3; ++row)
  {
    // The origin goes first, so that a large translation cancels before anything small is added.
    const double* m = matrix + 4 * row;
    result[row] = (m[3] - origin[row]) + m[0] * point[0] + m[1] * point[1] + m[2] * point[2];
  }
}

//------------------------------------------------------------------------------
// The rotation and scale of one glyph, as vtkOpenGLGlyph3DMapper::RebuildStructures makes them.
class GlyphMatrices
{
public:
  GlyphMatrices(vtkGlyph3DMapper* mapper, vtkDataSet* data)
    : Mapper(mapper)
    , Data(data)
    , Orientation(GlyphArrays::Orientation(mapper, data))
    , Scale(GlyphArrays::Scale(mapper, data))
  {
  }

  void Get(vtkIdType pointId, double matrix[16]) const
  {
    vtkMatrix4x4::Identity(matrix);
    double position[3];
    this->Data->GetPoint(pointId, position);
    double rotation[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    if (this->Orientation)
    {
      this->GetRotation(pointId, rotation);
    }
    double scale[3];
    this->GetScale(pointId, scale);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix[4 * row + column] = rotation[row][column] * scale[column];
      }
      matrix[4 * row + 3] = position[row];
    }
  }

private:
  void GetRotation(vtkIdType pointId, double rotation[3][3]) const
  {
    double value[4] = { 0.0, 0.0, 0.0, 0.0 };
    this->Orientation->GetTuple(pointId, value);
    vtkQuaterniond quaternion;
    switch (this->Mapper->GetOrientationMode())
    {
      case vtkGlyph3DMapper::ROTATION:
      {
        const double half[3] = { 0.5 * vtkMath::RadiansFromDegrees(value[0]),
          0.5 * vtkMath::RadiansFromDegrees(value[1]),
          0.5 * vtkMath::RadiansFromDegrees(value[2]) };
        const vtkQuaterniond x(std::cos(half[0]), std::sin(half[0]), 0.0, 0.0);
        const vtkQuaterniond y(std::cos(half[1]), 0.0, std::sin(half[1]), 0.0);
        const vtkQuaterniond z(std::cos(half[2]), 0.0, 0.0, std::sin(half[2]));
        quaternion = z * x * y;
        break;
      }
      case vtkGlyph3DMapper::DIRECTION:
        if (value[1] == 0.0 && value[2] == 0.0)
        {
          if (value[0] < 0.0)
          {
            quaternion.Set(0.0, 0.0, 1.0, 0.0);
          }
        }
        else
        {
          double axis[3] = { 0.5 * (value[0] + vtkMath::Norm(value)), 0.5 * value[1],
            0.5 * value[2] };
          vtkMath::Normalize(axis);
          quaternion.Set(0.0, axis[0], axis[1], axis[2]);
        }
        break;
      default:
        quaternion.Set(value);
        break;
    }
    quaternion.ToMatrix3x3(rotation);
  }

  void GetScale(vtkIdType pointId, double scale[3]) const
  {
    scale[0] = scale[1] = scale[2] = 1.0;
    const int mode = this->Mapper->GetScaleMode();
    if (this->Scale)
    {
      const double* value = this->Scale->GetTuple(pointId);
      if (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
      {
        scale[0] = scale[1] = scale[2] = vtkMath::Norm(value, this->Scale->GetNumberOfComponents());
      }
      else if (mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS &&
        this->Scale->GetNumberOfComponents() == 3)
      {
        std::copy(value, value + 3, scale);
      }
      if (this->Mapper->GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
      {
        const double* range = this->Mapper->GetRange();
        const double width = range[1] == range[0] ? 1.0 : range[1] - range[0];
        for (int i = 0; i < 3; ++i)
        {
          scale[i] = (vtkMath::ClampValue(scale[i], range[0], range[1]) - range[0]) / width;
        }
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      scale[i] *= this->Mapper->GetScaleFactor();
      if (!this->Mapper->GetScaling())
      {
        scale[i] = 1.0;
      }
      else if (scale[i] == 0.0)
      {
        scale[i] = 1.0e-10;
      }
    }
  }

  vtkGlyph3DMapper* Mapper;
  vtkDataSet* Data;
  vtkDataArray* Orientation;
  vtkDataArray* Scale;
};

//------------------------------------------------------------------------------
// The whole sphere that is glyph source number `index`, or null.
vtkSphereSource* GetWholeSphere(vtkGlyph3DMapper* mapper, int index)
{
  if (mapper->GetUseSourceTableTree() || index >= mapper->GetNumberOfInputConnections(1))
  {
    return nullptr;
  }
  vtkSphereSource* sphere = vtkSphereSource::SafeDownCast(mapper->GetInputAlgorithm(1, index));
  const bool whole = sphere && sphere->GetStartTheta() == 0.0 && sphere->GetEndTheta() == 360.0 &&
    sphere->GetStartPhi() == 0.0 && sphere->GetEndPhi() == 180.0;
  return whole ? sphere : nullptr;
}

//------------------------------------------------------------------------------
// The polydata of one glyph source: itself, or the leaves of a composite one.
std::vector<vtkPolyData*> GetLeaves(vtkDataObject* object)
{
  std::vector<vtkPolyData*> leaves;
  if (vtkPolyData* data = vtkPolyData::SafeDownCast(object))
  {
    leaves.push_back(data);
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    for (vtkDataObject* leaf : vtk::Range(composite, vtk::CompositeDataSetOptions::SkipEmptyNodes))
    {
      if (vtkPolyData* leafData = vtkPolyData::SafeDownCast(leaf))
      {
        leaves.push_back(leafData);
      }
    }
  }
  return leaves;
}

//------------------------------------------------------------------------------
void UpdateInputs(vtkMapper* mapper)
{
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      mapper->GetInputAlgorithm(port, i)->Update();
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::Gather(vtkRenderer* renderer)
{
  this->Meshes.clear();
  this->SphereSets.clear();
  this->Skipped.clear();

  vtkCamera* camera = renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    camera->GetFocalPoint(this->Origin);
  }
  else
  {
    camera->GetPosition(this->Origin);
  }

  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    // vtkFrustumCoverageCuller, which every renderer has, drops props whose bounds are not valid:
    // points without cells, for example.
    const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkActor* actor = vtkActor::SafeDownCast(node->GetViewProp());
      // As vtkAssembly draws: only the visibility of the last prop of a path counts.
      if (actor && actor->GetVisibility())
      {
        this->AddActor(actor, node->GetMatrix());
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddActor(vtkActor* actor, vtkMatrix4x4* matrix)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  UpdateInputs(mapper);
  if (!actor->HasOpaqueGeometry() || actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return;
  }
  double elements[16];
  vtkMatrix4x4::Identity(elements);
  if (matrix)
  {
    std::copy(matrix->GetData(), matrix->GetData() + 16, elements);
  }
  this->AddMapper(actor, mapper, elements);
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddMapper(vtkActor* actor, vtkMapper* mapper, const double matrix[16])
{
  if (vtkOpenGLSphereMapper* impostors = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    this->AddSphereImpostors(actor, impostors, matrix);
  }
  else if (vtkGlyph3DMapper* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    this->AddGlyphs(actor, glyphs, matrix);
  }
  else if (vtkOpenGLStickMapper::SafeDownCast(mapper) ||
    vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    this->Skipped.push_back(mapper->GetClassName());
  }
  else if (this->AddComposite(actor, mapper, matrix))
  {
    return;
  }
  else if (vtkPolyDataMapper* surface = vtkPolyDataMapper::SafeDownCast(mapper))
  {
    this->AddPolyData(actor, surface, surface->GetInput(), matrix);
  }
  else if (vtkDataSetMapper* dataSet = vtkDataSetMapper::SafeDownCast(mapper))
  {
    // It draws the boundary of its input, which it extracts itself.
    vtkNew<vtkDataSetSurfaceFilter> boundary;
    boundary->SetInputData(dataSet->GetInput());
    boundary->Update();
    this->AddPolyData(actor, dataSet, boundary->GetOutput(), matrix);
  }
  else
  {
    this->Skipped.push_back(mapper->GetClassName());
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::SetDrawing(vtkActor* actor, vtkMapper* mapper, Mesh& mesh) const
{
  vtkProperty* property = actor->GetProperty();
  mesh.Lit = property->GetLighting();
  // As vtkOpenGLProperty: back face culling wins where both are asked for.
  mesh.CullsBack = property->GetBackfaceCulling() != 0;
  mesh.CullsFront = !mesh.CullsBack && property->GetFrontfaceCulling() != 0;
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    for (int i = 0; i < planes->GetNumberOfItems(); ++i)
    {
      const double* normal = planes->GetItem(i)->GetNormal();
      const double* point = planes->GetItem(i)->GetOrigin();
      double offset = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        offset += normal[axis] * (this->Origin[axis] - point[axis]);
      }
      mesh.ClippingPlanes.push_back({ { normal[0], normal[1], normal[2], offset } });
    }
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddPolyData(
  vtkActor* actor, vtkMapper* mapper, vtkPolyData* data, const double matrix[16])
{
  const DrawnSurface surface(data, actor->GetProperty());
  if (surface.Triangles.empty())
  {
    return;
  }
  Mesh mesh;
  this->SetDrawing(actor, mapper, mesh);
  double normalMatrix[9];
  GetNormalMatrix(matrix, normalMatrix);
  this->AppendInstance(surface, matrix, normalMatrix, mesh);
  this->Meshes.push_back(std::move(mesh));
}

//------------------------------------------------------------------------------
bool vtkSSAOTruthScene::AddComposite(vtkActor* actor, vtkMapper* mapper, const double matrix[16])
{
  vtkSSAOTestCompositeMapper* composite = vtkSSAOTestCompositeMapper::SafeDownCast(mapper);
  if (!composite)
  {
    return false;
  }
  vtkCompositeDataDisplayAttributes* attributes = composite->GetCompositeDataDisplayAttributes();
  vtkTexture* texture = actor->GetTexture();
  const bool textureIsOpaque = !texture || !texture->IsTranslucent();

  // As vtkCompositePolyDataMapper2::BuildRenderValues: a block's setting holds for its children.
  const std::function<void(vtkDataObject*, bool, double)> visit =
    [&](vtkDataObject* object, bool visible, double opacity)
  {
    if (attributes && attributes->HasBlockVisibility(object))
    {
      visible = attributes->GetBlockVisibility(object);
    }
    if (attributes && attributes->HasBlockOpacity(object))
    {
      opacity = attributes->GetBlockOpacity(object);
    }
    if (vtkDataObjectTree* tree = vtkDataObjectTree::SafeDownCast(object))
    {
      for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
      {
        if (child)
        {
          visit(child, visible, opacity);
        }
      }
      return;
    }
    vtkPolyData* data = vtkPolyData::SafeDownCast(object);
    bool opaque = opacity >= 1.0 && textureIsOpaque;
    if (data && opaque && composite->GetScalarVisibility())
    {
      int cellFlag = 0;
      vtkDataArray* scalars = vtkAbstractMapper::GetScalars(data, composite->GetScalarMode(),
        composite->GetArrayAccessMode(), composite->GetArrayId(), composite->GetArrayName(),
        cellFlag);
      composite->GetLookupTable()->Build();
      opaque = composite->GetLookupTable()->IsOpaque(
                 scalars, composite->GetColorMode(), composite->GetArrayComponent()) != 0;
    }
    if (data && visible && (opaque || actor->GetForceOpaque()))
    {
      this->AddPolyData(actor, composite, data, matrix);
    }
  };
  if (vtkDataObject* input = composite->GetInputDataObject(0, 0))
  {
    visit(input, true, actor->GetProperty()->GetOpacity());
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddSphereImpostors(
  vtkActor* actor, vtkOpenGLSphereMapper* mapper, const double matrix[16])
{
  vtkPolyData* data = mapper->GetInput();
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  const char* scaleName = SphereArrays::Scale(mapper);
  vtkDataArray* scales = scaleName ? data->GetPointData()->GetArray(scaleName) : nullptr;

  Spheres spheres;
  spheres.Lit = actor->GetProperty()->GetLighting();
  spheres.Centers.resize(3 * static_cast<std::size_t>(data->GetNumberOfPoints()));
  spheres.Radii.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    TransformPoint(matrix, point, this->Origin, spheres.Centers.data() + 3 * i);
    // The actor's matrix moves the centres; the shader takes the radius as it is.
    spheres.Radii[i] = scales ? scales->GetComponent(i, 0) : mapper->GetRadius();
  }
  this->SphereSets.push_back(std::move(spheres));
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddGlyphs(
  vtkActor* actor, vtkGlyph3DMapper* mapper, const double matrix[16])
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (vtkDataSet* points = vtkDataSet::SafeDownCast(input))
  {
    this->AddGlyphsOf(actor, mapper, points, matrix);
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
    for (vtkDataObject* leaf : vtk::Range(composite, vtk::CompositeDataSetOptions::SkipEmptyNodes))
    {
      const bool visible = !attributes || !attributes->HasBlockVisibility(leaf) ||
        attributes->GetBlockVisibility(leaf);
      vtkDataSet* leafPoints = vtkDataSet::SafeDownCast(leaf);
      if (visible && leafPoints)
      {
        this->AddGlyphsOf(actor, mapper, leafPoints, matrix);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AddGlyphsOf(
  vtkActor* actor, vtkGlyph3DMapper* mapper, vtkDataSet* points, const double matrix[16])
{
  vtkProperty* property = actor->GetProperty();
  const bool flat = property->GetInterpolation() == VTK_FLAT;

  // The sources, each with what is drawn of it.
  struct Source
  {
    std::vector<DrawnSurface> Surfaces;
    std::vector<Mesh> Meshes;
    vtkSphereSource* Sphere = nullptr;
    Spheres Glyphs;
  };
  std::vector<vtkDataObject*> objects;
  if (mapper->GetUseSourceTableTree())
  {
    if (vtkDataObjectTree* tree = mapper->GetSourceTableTree())
    {
      for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
      {
        objects.push_back(child);
      }
    }
  }
  else
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      objects.push_back(mapper->GetSource(i));
    }
  }
  if (objects.empty())
  {
    return; // the mapper's default source is a line
  }
  std::vector<Source> sources(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i)
  {
    Source& source = sources[i];
    for (vtkPolyData* leaf : GetLeaves(objects[i]))
    {
      source.Surfaces.emplace_back(leaf, property);
    }
    source.Meshes.resize(source.Surfaces.size());
    for (Mesh& mesh : source.Meshes)
    {
      this->SetDrawing(actor, mapper, mesh);
    }
    source.Sphere =
      this->TrueSphereGlyphs && !flat ? GetWholeSphere(mapper, static_cast<int>(i)) : nullptr;
    source.Glyphs.Lit = property->GetLighting();
  }

  double actorNormalMatrix[9];
  GetNormalMatrix(matrix, actorNormalMatrix);
  vtkBitArray* mask =
    mapper->GetMasking() ? vtkBitArray::SafeDownCast(GlyphArrays::Mask(mapper, points)) : nullptr;
  vtkDataArray* indices = GlyphArrays::SourceIndex(mapper, points);
  const GlyphMatrices glyphs(mapper, points);
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    if (mask && mask->GetValue(id) == 0)
    {
      continue;
    }
    std::size_t index = 0;
    if (indices)
    {
      const double value = vtkMath::Norm(indices->GetTuple(id), indices->GetNumberOfComponents());
      index = static_cast<std::size_t>(
        vtkMath::ClampValue(static_cast<int>(value), 0, static_cast<int>(sources.size()) - 1));
    }
    Source& source = sources[index];

    double glyph[16];
    glyphs.Get(id, glyph);
    double whole[16];
    vtkMatrix4x4::Multiply4x4(matrix, glyph, whole);
    double scale;
    if (source.Sphere && GetUniformScale(whole, scale))
    {
      double center[3];
      TransformPoint(whole, source.Sphere->GetCenter(), this->Origin, center);
      source.Glyphs.Centers.insert(source.Glyphs.Centers.end(), center, center + 3);
      source.Glyphs.Radii.push_back(scale * source.Sphere->GetRadius());
      continue;
    }
    double normalMatrix[9];
    GetNormalMatrix(whole, normalMatrix);
    for (std::size_t i = 0; i < source.Surfaces.size(); ++i)
    {
      // vtkOpenGLGlyph3DHelper turns point normals with the glyph, but not cell normals.
      const DrawnSurface& surface = source.Surfaces[i];
      const bool turns = surface.Normal == Mesh::PointNormals;
      this->AppendInstance(
        surface, whole, turns ? normalMatrix : actorNormalMatrix, source.Meshes[i]);
    }
  }

  for (Source& source : sources)
  {
    for (Mesh& mesh : source.Meshes)
    {
      if (!mesh.Triangles.empty())
      {
        this->Meshes.push_back(std::move(mesh));
      }
    }
    if (!source.Glyphs.Radii.empty())
    {
      this->SphereSets.push_back(std::move(source.Glyphs));
    }
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthScene::AppendInstance(const DrawnSurface& surface, const double matrix[16],
  const double normalMatrix[9], Mesh& mesh) const
{
  if (surface.Triangles.empty())
  {
    return;
  }
  const unsigned int firstPoint = static_cast<unsigned int>(mesh.Points.size() / 3);
  const vtkIdType numberOfPoints = surface.Data->GetNumberOfPoints();
  mesh.Points.resize(mesh.Points.size() + 3 * static_cast<std::size_t>(numberOfPoints));
  double* position = mesh.Points.data() + 3 * static_cast<std::size_t>(firstPoint);
  for (vtkIdType i = 0; i < numberOfPoints; ++i, position += 3)
  {
    double point[3];
    surface.Data->GetPoint(i, point);
    TransformPoint(matrix, point, this->Origin, position);
  }
  mesh.Triangles.reserve(mesh.Triangles.size() + surface.Triangles.size());
  for (unsigned int point : surface.Triangles)
  {
    mesh.Triangles.push_back(firstPoint + point);
  }

  mesh.Normal = surface.Normal;
  if (mesh.Normal == Mesh::NoNormals)
  {
    return;
  }
  const bool perCell = mesh.Normal == Mesh::CellNormals;
  const std::size_t count =
    perCell ? surface.Cells.size() : static_cast<std::size_t>(numberOfPoints);
  std::size_t next = mesh.Normals.size();
  mesh.Normals.resize(next + 3 * count);
  for (std::size_t i = 0; i < count; ++i, next += 3)
  {
    double normal[3];
    surface.Normals->GetTuple(perCell ? surface.Cells[i] : static_cast<vtkIdType>(i), normal);
    vtkMatrix3x3::MultiplyPoint(normalMatrix, normal, mesh.Normals.data() + next);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkSSAOTruthScene::GetNumberOfTriangles() const
{
  std::size_t count = 0;
  for (const Mesh& mesh : this->Meshes)
  {
    count += mesh.Triangles.size() / 3;
  }
  return count;
}

//------------------------------------------------------------------------------
std::size_t vtkSSAOTruthScene::GetNumberOfSpheres() const
{
  std::size_t count = 0;
  for (const Spheres& spheres : this->SphereSets)
  {
    count += spheres.Radii.size();
  }
  return count;
}

//------------------------------------------------------------------------------
std::string vtkSSAOTruthScene::GetDigest() const
{
  vtkSSAOTruthDigest digest;
  digest.Add(static_cast<unsigned long long>(this->Meshes.size()));
  for (const Mesh& mesh : this->Meshes)
  {
    digest.Add(mesh.Points);
    digest.Add(mesh.Triangles);
    digest.Add(mesh.Normals);
    digest.Add(mesh.Normal);
    digest.Add(mesh.Lit);
    digest.Add(mesh.CullsBack);
    digest.Add(mesh.CullsFront);
    digest.Add(mesh.ClippingPlanes);
  }
  digest.Add(static_cast<unsigned long long>(this->SphereSets.size()));
  for (const Spheres& spheres : this->SphereSets)
  {
    digest.Add(spheres.Centers);
    digest.Add(spheres.Radii);
    digest.Add(spheres.Lit);
  }
  return digest.GetHex();
}
