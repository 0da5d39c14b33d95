// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Scenes read from the data directory, one function each. Sources and licences: the README there.
 */

#include "vtkSSAOSceneHelpers.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPDBReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"

#include <fstream>
#include <type_traits>
#include <utility>

namespace vtkSSAOScenes
{
namespace
{
//------------------------------------------------------------------------------
/// Read a file of the data directory; nullptr, with Context::Error filled, where that fails.
template <typename Reader>
auto Read(Context& context, const std::string& file)
{
  using Output = std::remove_pointer_t<decltype(std::declval<Reader>().GetOutput())>;
  vtkSmartPointer<Output> output;
  const std::string path = context.DataDirectory + "/" + file;
  if (!std::ifstream(path))
  {
    context.Error = "the file " + path + " is missing or cannot be opened.";
    return output;
  }
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  output = reader->GetOutput();
  if (!output || output->GetNumberOfPoints() == 0)
  {
    context.Error = "the file " + path + " holds no geometry that could be read.";
    output = nullptr;
  }
  return output;
}

//------------------------------------------------------------------------------
/// A surface in one colour.
bool AddSurface(
  Context& context, const std::string& file, double featureAngle, const glm::dvec3& color)
{
  const auto surface = Read<vtkXMLPolyDataReader>(context, file);
  if (!surface)
  {
    return false;
  }
  AddActor(context.Renderer, WithNormals(surface, featureAngle), color);
  return true;
}

//------------------------------------------------------------------------------
/// A furnished room, open to the front and above; one colour for each of its parts.
bool AddLivingRoom(Context& context)
{
  const auto room = Read<vtkXMLPolyDataReader>(context, "living_room_cc0.vtp");
  if (!room)
  {
    return false;
  }
  vtkDataArray* part = room->GetCellData()->GetArray("part");
  if (!part)
  {
    context.Error = "living_room_cc0.vtp has no cell array named part.";
    return false;
  }
  // The last parts are the floor and the walls.
  constexpr int firstWall = 13;
  room->GetCellData()->SetScalars(MakeColors(room->GetNumberOfCells(),
    [part](vtkIdType cell)
    {
      const int number = static_cast<int>(part->GetTuple1(cell));
      return number < firstWall ? PaletteColor(number) : Colors::Ivory;
    }));
  AddColoredActor(context.Renderer, WithNormals(room, 30.0));
  ShareWithAmbient(context.Renderer, 0.3);
  return true;
}

//------------------------------------------------------------------------------
bool AddBrain(Context& context)
{
  return AddSurface(context, "brain_colin27_90k.vtp", 180.0, Colors::Clay);
}

//------------------------------------------------------------------------------
bool AddRadiator(Context& context)
{
  return AddSurface(context, "radiator3_cc0.vtp", 30.0, Colors::Ivory);
}

//------------------------------------------------------------------------------
bool AddTableFootball(Context& context)
{
  return AddSurface(context, "table_football_cc0.vtp", 30.0, Colors::Sage);
}

//------------------------------------------------------------------------------
// Van der Waals radius in angstroms (A. Bondi, J. Phys. Chem. 68, 1964, 441) and colour.
struct Element
{
  int AtomicNumber;
  float Radius;
  glm::dvec3 Color;
};

//------------------------------------------------------------------------------
const Element& GetElement(int atomicNumber)
{
  static const std::array<Element, 8> elements = { {
    { 6, 1.70f, Colors::Stone },
    { 1, 1.20f, Colors::Ivory },
    { 7, 1.55f, Colors::Slate },
    { 8, 1.52f, Colors::Rose },
    { 12, 1.73f, Colors::Sage },
    { 15, 1.80f, Colors::Ochre },
    { 16, 1.80f, Colors::Sand },
    { 30, 1.39f, Colors::Plum },
  } };
  for (const Element& element : elements)
  {
    if (element.AtomicNumber == atomicNumber)
    {
      return element;
    }
  }
  return elements.front();
}

//------------------------------------------------------------------------------
/// Space-filling spheres at the points of a molecule for which keep is true.
void AddAtoms(Context& context, vtkPoints* positions, vtkDataArray* atomicNumbers,
  const std::function<bool(vtkIdType)>& keep)
{
  vtkNew<vtkPoints> points;
  // Without cells the bounds of the atoms would be empty.
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkFloatArray> radii;
  radii->SetName(SphereRadiusArray());
  std::vector<glm::dvec3> colors;
  for (vtkIdType i = 0; i < positions->GetNumberOfPoints(); ++i)
  {
    if (keep(i))
    {
      const Element& element = GetElement(static_cast<int>(atomicNumbers->GetTuple1(i)));
      vertices->InsertNextCell({ points->InsertNextPoint(positions->GetPoint(i)) });
      radii->InsertNextValue(element.Radius);
      colors.push_back(element.Color);
    }
  }
  vtkNew<vtkPolyData> atoms;
  atoms->SetPoints(points);
  atoms->SetVerts(vertices);
  atoms->GetPointData()->AddArray(radii);
  atoms->GetPointData()->SetScalars(
    MakeColors(points->GetNumberOfPoints(), [&colors](vtkIdType i) { return colors[i]; }));
  AddSpheres(context.Renderer, atoms, context.Spheres);
}

//------------------------------------------------------------------------------
bool AddRibosome(Context& context)
{
  const auto atoms = Read<vtkXMLPolyDataReader>(context, "ribosome_6zu5_atoms.vtp");
  if (!atoms)
  {
    return false;
  }
  vtkDataArray* atomicNumbers = atoms->GetPointData()->GetArray("atomic_number");
  if (!atomicNumbers)
  {
    context.Error = "ribosome_6zu5_atoms.vtp has no point array named atomic_number.";
    return false;
  }
  AddAtoms(context, atoms->GetPoints(), atomicNumbers, [](vtkIdType) { return true; });
  return true;
}

//------------------------------------------------------------------------------
/// The protein without the water around it.
bool AddUbiquitin(Context& context)
{
  const auto atoms = Read<vtkPDBReader>(context, "1ubi.pdb");
  if (!atoms)
  {
    return false;
  }
  vtkDataArray* atomicNumbers = atoms->GetPointData()->GetArray("atom_type");
  vtkDataArray* isOther = atoms->GetPointData()->GetArray("ishetatm");
  if (!atomicNumbers)
  {
    context.Error = "vtkPDBReader gave no atom types for 1ubi.pdb.";
    return false;
  }
  AddAtoms(context, atoms->GetPoints(), atomicNumbers,
    [isOther](vtkIdType i) { return !isOther || isOther->GetTuple1(i) == 0.0; });
  return true;
}

//------------------------------------------------------------------------------
/// Elevations in metres, heights doubled.
bool AddJacksboro(Context& context)
{
  const auto image = Read<vtkXMLImageDataReader>(context, "jacksboro_dem.vti");
  if (!image)
  {
    return false;
  }
  constexpr double exaggeration = 2.0;
  int size[3];
  image->GetDimensions(size);
  double spacing[3];
  image->GetSpacing(spacing);
  vtkImageData* elevation = image;
  Mesh terrain;
  terrain.AddHeightField(size[0], size[1], spacing[0], spacing[1],
    [elevation](int i, int j)
    { return exaggeration * elevation->GetScalarComponentAsDouble(i, j, 0, 0); });
  AddActor(context.Renderer, terrain.GetSmooth(180.0), Colors::Sand);
  return true;
}

//------------------------------------------------------------------------------
/// Stream lines of a flow between discs as tubes.
bool AddFlowTubes(Context& context)
{
  const auto lines = Read<vtkXMLPolyDataReader>(context, "disk_out_streamlines.vtp");
  if (!lines)
  {
    return false;
  }
  AddTubes(context.Renderer, lines, 0.12, Colors::Slate);
  return true;
}
}

//------------------------------------------------------------------------------
std::vector<Scene> RealScenes()
{
  return {
    { { "living_room", Kind::Real, "Furnished room, metres", 0.5, "living_room_cc0.vtp" },
      { { { 3.8, -10.8, 5.0 }, { 2.7, -2.4, 1.0 } }, { { 5.2, -5.0, 2.3 }, { 1.4, -1.2, 0.6 } } },
      AddLivingRoom },
    { { "brain", Kind::Real, "Brain surface with its sulci, millimetres", 15.0,
        "brain_colin27_90k.vtp" },
      { { { 364.0, 220.0, 160.0 }, { 88.6, 110.4, 79.9 } },
        { { 91.0, 102.0, 429.0 }, { 91.0, 109.0, 79.8 }, { 0.0, 1.0, 0.0 } } },
      AddBrain },
    { { "ribosome", Kind::Real, "Ribosome, 165,175 atoms as spheres, angstroms", 20.0,
        "ribosome_6zu5_atoms.vtp" },
      { { { 328.0, -339.0, 167.0 }, { 1.3, -8.1, 3.1 } },
        { { -120.0, -260.0, 60.0 }, { -1.6, -13.4, -1.7 } } },
      AddRibosome },
    { { "ubiquitin", Kind::Real, "Ubiquitin, 602 atoms as spheres, angstroms", 5.0, "1ubi.pdb" },
      { { { 30.4, -44.0, 46.0 }, { 30.4, 29.6, 18.3 } },
        { { 80.0, 42.0, 34.0 }, { 29.0, 30.5, 17.0 } } },
      AddUbiquitin },
    { { "radiator", Kind::Real, "Ribbed radiator, centimetres", 8.0, "radiator3_cc0.vtp" },
      { { { 63.0, -116.0, 69.0 }, { 0.6, 0.0, 31.0 } },
        { { -45.0, -78.0, 58.0 }, { -3.0, 0.0, 36.0 } } },
      AddRadiator },
    { { "table_football", Kind::Real, "Table football, rods over a box, centimetres", 15.0,
        "table_football_cc0.vtp" },
      { { { 142.0, -216.0, 194.0 }, { 1.4, -5.8, 44.0 } },
        { { -120.0, -60.0, 160.0 }, { 10.0, 5.0, 70.0 } } },
      AddTableFootball },
    { { "jacksboro", Kind::Real, "Jacksboro fault, heights doubled, metres", 2000.0,
        "jacksboro_dem.vti" },
      { { { 20000.0, -26000.0, 32000.0 }, { 15000.0, 14500.0, -600.0 } },
        { { 3000.0, -8000.0, 7000.0 }, { 15000.0, 14000.0, 900.0 } } },
      AddJacksboro },
    { { "cfd_tubes", Kind::Real, "Stream lines of a simulated flow as tubes", 1.5,
        "disk_out_streamlines.vtp" },
      { { { 10.5, -27.5, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.4, 0.0 } },
        { { 5.0, -14.0, 16.0 }, { 0.0, 0.0, 4.0 } } },
      AddFlowTubes },
  };
}
}
