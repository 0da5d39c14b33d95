// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"
#include "Messages.h"

#include <vtkCellArray.h>
#include <vtkCellDataToPointData.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkContourFilter.h>
#include <vtkDataSetReader.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkImageData.h>
#include <vtkImageDataGeometryFilter.h>
#include <vtkMatrix3x3.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNrrdReader.h>
#include <vtkOBJReader.h>
#include <vtkPDBReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkWarpScalar.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace rendermesh
{
namespace
{
namespace fs = std::filesystem;

using Opener = vtkSmartPointer<vtkAlgorithm> (*)(const std::string& file);

template <typename Reader>
vtkSmartPointer<vtkAlgorithm> Open(const std::string& file)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(file.c_str());
  return reader;
}

const std::map<std::string, Opener> Openers = {
  { ".vtp", Open<vtkXMLPolyDataReader> },
  { ".vtu", Open<vtkXMLUnstructuredGridReader> },
  { ".vti", Open<vtkXMLImageDataReader> },
  { ".vts", Open<vtkXMLStructuredGridReader> },
  { ".vtr", Open<vtkXMLRectilinearGridReader> },
  { ".vtm", Open<vtkXMLMultiBlockDataReader> },
  { ".vtk", Open<vtkDataSetReader> },
  { ".ply", Open<vtkPLYReader> },
  { ".stl", Open<vtkSTLReader> },
  { ".obj", Open<vtkOBJReader> },
  { ".pdb", Open<vtkPDBReader> },
  { ".mha", Open<vtkMetaImageReader> },
  { ".mhd", Open<vtkMetaImageReader> },
  { ".nrrd", Open<vtkNrrdReader> },
  { ".nii", Open<vtkNIFTIImageReader> },
  { ".gltf", nullptr }, // Scene.cxx imports these two with their materials
  { ".glb", nullptr },
};

std::string Extension(const std::string& file)
{
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Failure EmptyMesh(const std::string& file)
{
  return Failure("the mesh in " + Quoted(file) + " is empty: it has no points");
}

/// vtkSTLReader reads a binary file to its end and does not notice where the rest is missing. The
/// count of triangles is often wrong in such files, but each takes 50 bytes.
void CheckStlSize(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  unsigned char head[84] = { 0 };
  stream.read(reinterpret_cast<char*>(head), sizeof(head));
  const unsigned long long count =
    head[80] + 256ull * (head[81] + 256ull * (head[82] + 256ull * head[83]));
  const unsigned long long size = fs::file_size(file);
  const bool binary = stream && std::find(head, head + 84, 0) != head + 84;
  if (binary && size < 84 + 50 * count && (size - 84) % 50 != 0)
  {
    throw Failure("cannot read " + Quoted(file) + ": its end is missing");
  }
}

vtkSmartPointer<vtkDataObject> ReadFile(const Settings& settings)
{
  const std::string failed = "cannot read " + Quoted(settings.Input);
  const std::string extension = Extension(settings.Input);
  if (extension == ".stl")
  {
    CheckStlSize(settings.Input);
  }
  const double megabytes = 1e-6 * static_cast<double>(fs::file_size(settings.Input));
  if (megabytes > 20.0 && !settings.Quiet) // some readers take long and report no progress
  {
    std::cout << "reading " << settings.Input << ": " << std::lround(megabytes) << " MB"
              << std::endl;
  }
  vtkSmartPointer<vtkAlgorithm> reader = Openers.at(extension)(settings.Input);
  {
    Progress progress(reader, "reading " + settings.Input, settings.Quiet);
    ReaderGuard guard(failed);
    reader->Update();
  }
  try
  {
    CheckMessages(failed);
  }
  catch (const Failure& failure) // VTK cannot read the empty meshes that it writes
  {
    const bool empty = std::strstr(failure.what(), "No Points element available");
    throw empty ? EmptyMesh(settings.Input) : failure;
  }
  if (reader->GetErrorCode() != 0 || !reader->GetOutputDataObject(0))
  {
    throw Failure(failed + ": it is damaged or of another format");
  }
  return reader->GetOutputDataObject(0);
}

/// The array that contour and height use, made active as point scalars.
vtkDataArray* ActivateScalars(vtkDataSet* data, const std::string& name)
{
  vtkPointData* points = data->GetPointData();
  vtkDataArray* array = name.empty() ? points->GetScalars() : points->GetArray(name.c_str());
  for (int i = 0; name.empty() && !array && i < points->GetNumberOfArrays(); ++i)
  {
    array = points->GetArray(i);
  }
  if (!array)
  {
    throw Failure(name.empty() ? "the file has no scalars to contour"
                               : "option --scalars: no array is called " + Quoted(name));
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw Failure(std::string("the array ") + Quoted(array->GetName() ? array->GetName() : "") +
      " has more than one component; choose another with --scalars");
  }
  points->SetScalars(array);
  return array;
}

vtkSmartPointer<vtkPolyData> ContourOf(vtkDataSet* data, const Settings& settings)
{
  const double* range = ActivateScalars(data, settings.Scalars)->GetRange();
  const double value = settings.Contour.value_or(0.5 * (range[0] + range[1]));
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(data);
  contour->ComputeScalarsOff();
  contour->SetValue(0, value);
  Update(contour, "contouring at " + Text(value), settings.Quiet);
  if (contour->GetOutput()->GetNumberOfCells() == 0)
  {
    throw Failure("the contour of " + Text(value) + " is empty; the scalars are in [" +
      Text(range[0]) + ", " + Text(range[1]) + "]");
  }
  return contour->GetOutput();
}

vtkSmartPointer<vtkPolyData> HeightFieldOf(vtkImageData* image, const Settings& settings)
{
  const double* range = ActivateScalars(image, settings.Scalars)->GetRange();
  const double* bounds = image->GetBounds();
  const int* dimensions = image->GetDimensions();
  const int flat = static_cast<int>(std::find(dimensions, dimensions + 3, 1) - dimensions);
  double scale = settings.WarpScale;
  if (scale == 0.0 && range[1] > range[0])
  {
    const double side =
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    scale = 0.15 * side / (range[1] - range[0]);
  }
  vtkNew<vtkImageDataGeometryFilter> sheet;
  sheet->SetInputData(image);
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(sheet->GetOutputPort());
  warp->UseNormalOn();
  vtkMatrix3x3* axes = image->GetDirectionMatrix();
  warp->SetNormal(axes->GetElement(0, flat), axes->GetElement(1, flat), axes->GetElement(2, flat));
  warp->SetScaleFactor(scale);
  Update(warp, "raising the height field by " + Text(scale), settings.Quiet);
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(warp->GetOutput());
  surface->GetPointData()->SetActiveScalars(nullptr);
  return surface;
}

/// Anything that VTK reads as polygons, lines or points.
vtkSmartPointer<vtkPolyData> SurfaceOf(
  vtkSmartPointer<vtkDataObject> data, const Settings& settings)
{
  vtkSmartPointer<vtkDataSet> set = vtkDataSet::SafeDownCast(data);
  auto image = vtkImageData::SafeDownCast(data);
  const bool usesScalars = set && set->GetNumberOfCells() > 0 && (image || settings.Contour);
  if (usesScalars && set->GetPointData()->GetNumberOfArrays() == 0)
  {
    vtkNew<vtkCellDataToPointData> toPoints;
    toPoints->SetInputData(set);
    Update(toPoints, "averaging cell data", settings.Quiet);
    set = toPoints->GetOutput();
    image = vtkImageData::SafeDownCast(set);
  }
  if (usesScalars && (settings.Contour || image->GetDataDimension() == 3))
  {
    return ContourOf(set, settings);
  }
  if (usesScalars && image->GetDataDimension() == 2)
  {
    return HeightFieldOf(image, settings);
  }
  if (auto polyData = vtkPolyData::SafeDownCast(data))
  {
    return polyData;
  }
  vtkSmartPointer<vtkPolyDataAlgorithm> surface;
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    surface = vtkSmartPointer<vtkCompositeDataGeometryFilter>::New();
  }
  else
  {
    surface = vtkSmartPointer<vtkDataSetSurfaceFilter>::New();
  }
  surface->SetInputDataObject(data);
  Update(surface, "extracting the surface", settings.Quiet);
  return surface->GetOutput();
}
}

//------------------------------------------------------------------------------
std::string KnownExtensions()
{
  std::string list;
  for (const auto& opener : Openers)
  {
    list += (list.empty() ? "" : " ") + opener.first;
  }
  return list;
}

//------------------------------------------------------------------------------
bool IsGltf(const std::string& file)
{
  return Extension(file) == ".gltf" || Extension(file) == ".glb";
}

//------------------------------------------------------------------------------
void CheckInput(const std::string& file)
{
  std::error_code error;
  const std::string name = Quoted(file);
  if (!fs::exists(file, error))
  {
    throw Failure("no such file: " + name);
  }
  if (fs::is_directory(file, error))
  {
    throw Failure(name + " is a folder, not a file");
  }
  if (Openers.count(Extension(file)) == 0)
  {
    throw Failure("cannot tell the format of " + name + "; known are " + KnownExtensions());
  }
  if (!std::ifstream(file))
  {
    throw Failure("cannot open " + name + ": " + std::strerror(errno));
  }
  if (fs::is_regular_file(file, error) && fs::file_size(file, error) == 0)
  {
    throw Failure(name + " is an empty file");
  }
}

//------------------------------------------------------------------------------
void CheckMesh(vtkPolyData* mesh, const std::string& file)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  if (points == 0)
  {
    throw EmptyMesh(file);
  }
  vtkIdType bad = 0;
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    bad += std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) ? 0 : 1;
  }
  for (vtkCellArray* cells :
    { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    double range[2];
    cells->GetConnectivityArray()->GetRange(range, 0);
    if (cells->GetNumberOfConnectivityIds() > 0 && (range[0] < 0.0 || range[1] >= points))
    {
      throw Failure("cannot read " + Quoted(file) + ": a cell has a point that is not there");
    }
  }
  if (bad > 0)
  {
    throw Failure(Quoted(file) + ": " + std::to_string(bad) + " of " + std::to_string(points) +
      " points have a NaN or infinite coordinate");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> LoadMesh(const Settings& settings)
{
  vtkSmartPointer<vtkPolyData> mesh = SurfaceOf(ReadFile(settings), settings);
  CheckMesh(mesh, settings.Input);
  return mesh;
}
}
