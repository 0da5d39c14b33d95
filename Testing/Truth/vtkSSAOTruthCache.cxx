// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthCache.h"

#include "vtkSSAOTruthCamera.h"
#include "vtkSSAOTruthDigest.h"
#include "vtkSSAOTruthImage.h"
#include "vtkSSAOTruthScene.h"
#include "vtkSSAOTruthTracer.h"

#include "vtkObject.h"

#include <vtksys/SystemInformation.hxx>
#include <vtksys/SystemTools.hxx>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

namespace
{
const char Magic[] = "vtkSSAOTruth 1\n";
const std::size_t MagicSize = sizeof(Magic) - 1;
const std::size_t DigestSize = 32;

//------------------------------------------------------------------------------
template <typename T>
void Put(const std::vector<T>& values, std::string& bytes)
{
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

//------------------------------------------------------------------------------
template <typename T>
void Take(const char*& bytes, std::vector<T>& values)
{
  std::memcpy(values.data(), bytes, values.size() * sizeof(T));
  bytes += values.size() * sizeof(T);
}

//------------------------------------------------------------------------------
std::string GetDigestOf(const char* bytes, std::size_t size)
{
  vtkSSAOTruthDigest digest;
  digest.AddBytes(bytes, size);
  return digest.GetHex();
}
}

//------------------------------------------------------------------------------
vtkSSAOTruthCache::vtkSSAOTruthCache(const std::string& directory)
  : Directory(directory)
{
}

//------------------------------------------------------------------------------
std::string vtkSSAOTruthCache::GetFileName(const vtkSSAOTruthScene& scene,
  const vtkSSAOTruthCamera& camera, const vtkSSAOTruthTracer& tracer) const
{
  const std::string parts = scene.GetDigest() + camera.GetDigest() + tracer.GetDigest();
  return this->Directory + "/" + GetDigestOf(parts.data(), parts.size()) + ".truth";
}

//------------------------------------------------------------------------------
bool vtkSSAOTruthCache::GetImage(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera,
  const vtkSSAOTruthTracer& tracer, vtkSSAOTruthImage& image)
{
  const std::string fileName = this->GetFileName(scene, camera, tracer);
  this->LastWasRead =
    vtkSSAOTruthCache::Read(fileName, camera.GetWidth(), camera.GetHeight(), image);
  if (this->LastWasRead)
  {
    return true;
  }
  if (!tracer.Trace(scene, camera, image))
  {
    return false;
  }
  vtksys::SystemTools::MakeDirectory(this->Directory);
  if (!vtkSSAOTruthCache::Write(fileName, image))
  {
    vtkGenericWarningMacro("vtkSSAOTruthCache: cannot write " << fileName);
  }
  return true;
}

//------------------------------------------------------------------------------
// A file is the magic text, the digest of the payload, and the payload: width, height, arrays.
bool vtkSSAOTruthCache::Read(
  const std::string& fileName, int width, int height, vtkSSAOTruthImage& image)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    return false;
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t headerSize = MagicSize + DigestSize;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::size_t payloadSize = 2 * sizeof(int) + pixels * (9 * sizeof(float) + 1);
  if (bytes.size() != headerSize + payloadSize || bytes.compare(0, MagicSize, Magic) != 0)
  {
    return false;
  }
  const char* payload = bytes.data() + headerSize;
  if (bytes.compare(MagicSize, DigestSize, GetDigestOf(payload, payloadSize)) != 0)
  {
    return false;
  }
  int size[2];
  std::memcpy(size, payload, sizeof(size));
  payload += sizeof(size);
  if (size[0] != width || size[1] != height)
  {
    return false;
  }
  image.Allocate(width, height);
  Take(payload, image.Visibility);
  Take(payload, image.StandardError);
  Take(payload, image.Hit);
  Take(payload, image.Depth);
  Take(payload, image.Normal);
  Take(payload, image.GeometricNormal);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSSAOTruthCache::Write(const std::string& fileName, const vtkSSAOTruthImage& image)
{
  std::string payload;
  const int size[2] = { image.Width, image.Height };
  payload.append(reinterpret_cast<const char*>(size), sizeof(size));
  Put(image.Visibility, payload);
  Put(image.StandardError, payload);
  Put(image.Hit, payload);
  Put(image.Depth, payload);
  Put(image.Normal, payload);
  Put(image.GeometricNormal, payload);

  // Two programs may trace the same image at the same time.
  const std::string partName =
    fileName + "." + std::to_string(vtksys::SystemInformation().GetProcessId()) + ".part";
  bool written = false;
  {
    std::ofstream file(partName, std::ios::binary | std::ios::trunc);
    file.write(Magic, MagicSize);
    const std::string digest = GetDigestOf(payload.data(), payload.size());
    file.write(digest.data(), static_cast<std::streamsize>(digest.size()));
    file.write(payload.data(), static_cast<std::streamsize>(payload.size()));
    file.close();
    written = !file.fail();
  }
  written = written && std::rename(partName.c_str(), fileName.c_str()) == 0;
  if (!written)
  {
    std::remove(partName.c_str());
  }
  return written;
}
