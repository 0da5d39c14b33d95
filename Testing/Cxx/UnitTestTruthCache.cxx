// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cache of traced images: what is read, what is traced again, what happens to damage.
 */

#include "UnitTestTruthCommon.h"

#include "vtkSSAOTruthCache.h"

#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>

namespace
{
using namespace TruthTest;

//------------------------------------------------------------------------------
std::string ReadBytes(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

//------------------------------------------------------------------------------
void WriteBytes(const std::string& fileName, const std::string& bytes)
{
  std::ofstream file(fileName, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/**
 * A scene whose parts can be changed one by one.
 */
struct Setup
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkPolyData> Data;
  vtkSmartPointer<vtkActor> Actor;
  vtkSSAOTruthTracer Tracer;
  int Width = 30;

  Setup()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->Update();
    this->Data->DeepCopy(sphere->GetOutput());
    this->Actor = AddPolyData(this->Renderer, this->Data);
    AddPolyData(this->Renderer, MakeFloor(3.0, -0.5));
    SetCamera(this->Renderer, false, { 0.0, -4.0, 2.0 }, { 0.0, 0.0, 0.0 }, 1.0, 30.0);
    this->Tracer.SetRaysPerPixel(32);
    this->Tracer.SetThreads(1);
  }

  /// Gets the image; true if it was read.
  bool Get(const std::string& directory, vtkSSAOTruthImage& image, std::string& fileName)
  {
    vtkSSAOTruthScene scene;
    scene.Gather(this->Renderer);
    const vtkSSAOTruthCamera camera(
      this->Renderer->GetActiveCamera(), this->Width, 20, scene.GetOrigin());
    vtkSSAOTruthCache cache(directory);
    fileName = cache.GetFileName(scene, camera, this->Tracer);
    if (!cache.GetImage(scene, camera, this->Tracer, image))
    {
      std::cout << "  FAIL tracing failed\n";
    }
    return cache.GetLastWasRead();
  }
};
}

//------------------------------------------------------------------------------
int UnitTestTruthCache(int argc, char* argv[])
{
  std::string directory = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], "-T") == 0)
    {
      directory = argv[i + 1];
    }
  }
  directory += "/UnitTestTruthCache/made/when/missing";
  vtksys::SystemTools::RemoveADirectory(directory);

  Setup setup;
  vtkSSAOTruthImage first, image;
  std::string fileName, otherName;
  bool good = CheckTrue("the first image is traced", !setup.Get(directory, first, fileName));
  good &= CheckTrue("the second is read", setup.Get(directory, image, fileName));
  const auto same = [&]()
  {
    return image.Visibility == first.Visibility && image.StandardError == first.StandardError &&
      image.Hit == first.Hit && image.Depth == first.Depth && image.Normal == first.Normal &&
      image.GeometricNormal == first.GeometricNormal && image.Width == first.Width &&
      image.Height == first.Height;
  };
  good &= CheckTrue("and equal", same());
  setup.Tracer.SetThreads(2);
  good &= CheckTrue("another number of threads reads it", setup.Get(directory, image, fileName));

  // Damage of every kind is noticed, the image is traced again and the file replaced.
  const std::string bytes = ReadBytes(fileName);
  const std::size_t places[] = { 0, 20, 50, bytes.size() / 2, bytes.size() - 1 };
  std::vector<std::string> damaged;
  for (std::size_t place : places)
  {
    damaged.push_back(bytes);
    damaged.back()[place] = static_cast<char>(damaged.back()[place] ^ 1);
  }
  damaged.push_back(bytes.substr(0, bytes.size() - 5));
  damaged.push_back(bytes + "x");
  damaged.push_back("");
  for (std::size_t i = 0; i < damaged.size(); ++i)
  {
    WriteBytes(fileName, damaged[i]);
    const bool read = setup.Get(directory, image, fileName);
    good &= CheckTrue("damage " + std::to_string(i) + " is noticed and repaired",
      !read && same() && ReadBytes(fileName) == bytes);
  }

  // Whatever the image depends on makes another file.
  struct Change
  {
    const char* Name;
    std::function<void(Setup&)> Apply;
  };
  const Change changes[] = {
    { "radius", [](Setup& s) { s.Tracer.SetRadius(0.9); } },
    { "ray count", [](Setup& s) { s.Tracer.SetRaysPerPixel(36); } },
    { "replicates", [](Setup& s) { s.Tracer.SetReplicates(8); } },
    { "cosine weight", [](Setup& s) { s.Tracer.SetCosineWeight(false); } },
    { "cutoff", [](Setup& s) { s.Tracer.SetCutoff(false); } },
    { "camera", [](Setup& s) { s.Renderer->GetActiveCamera()->Azimuth(1e-6); } },
    { "clipping range",
      [](Setup& s) { s.Renderer->GetActiveCamera()->SetClippingRange(0.02, 1000.0); } },
    { "size", [](Setup& s) { s.Width = 31; } },
    { "matrix", [](Setup& s) { s.Actor->AddPosition(0.0, 0.0, 1e-6); } },
    { "a point", [](Setup& s) { s.Data->GetPoints()->SetPoint(5, 0.1, 0.2, 0.3); } },
    { "a normal",
      [](Setup& s) { s.Data->GetPointData()->GetNormals()->SetTuple3(5, 0.0, 0.0, 1.0); } },
  };
  for (const Change& change : changes)
  {
    Setup changed;
    change.Apply(changed);
    vtkSSAOTruthImage other;
    good &= CheckTrue(std::string("another ") + change.Name + " is another file",
      !changed.Get(directory, other, otherName) && otherName != fileName);
  }

  // A directory that cannot be: the image is there all the same, with a warning.
  vtkObject::GlobalWarningDisplayOff();
  WriteBytes(directory + "/file", "x");
  good &= CheckTrue("a directory that cannot be made is no failure",
    !setup.Get(directory + "/file/below", image, otherName) && same());
  vtkObject::GlobalWarningDisplayOn();

  vtksys::SystemTools::RemoveADirectory(directory);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
