// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthCache
 * @brief   Keeps ray-traced images on disk, named by what they were made of.
 *
 * A file's name is the digest of the geometry, the normals, the matrices, the camera, the size, the
 * radius, the ray count and the version of the algorithm; the number of threads is not part of it.
 * A file holds a checksum of its contents: one that is cut short, altered or of another format is
 * traced again and replaced. A file is written beside its place and then moved there, so that a
 * program that is interrupted leaves no half file. Files are for the machine that wrote them (byte
 * order).
 */

#ifndef vtkSSAOTruthCache_h
#define vtkSSAOTruthCache_h

#include <string>

class vtkSSAOTruthCamera;
class vtkSSAOTruthScene;
class vtkSSAOTruthTracer;
struct vtkSSAOTruthImage;

class vtkSSAOTruthCache
{
public:
  /**
   * Files go to `directory`, which is made if it does not exist.
   */
  explicit vtkSSAOTruthCache(const std::string& directory);

  /**
   * Path of the file that would hold this image.
   */
  std::string GetFileName(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera,
    const vtkSSAOTruthTracer& tracer) const;

  /**
   * Reads the image, or traces and keeps it. Returns false where tracing failed; a directory that
   * cannot be written to is a warning only.
   */
  bool GetImage(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera,
    const vtkSSAOTruthTracer& tracer, vtkSSAOTruthImage& image);

  /**
   * Whether the last GetImage read a file (true) or traced (false).
   */
  bool GetLastWasRead() const { return this->LastWasRead; }

  /**
   * Reads a file into an image of the expected size; false if the file is missing or damaged.
   */
  static bool Read(const std::string& fileName, int width, int height, vtkSSAOTruthImage& image);

  /**
   * Writes a file; false if that failed, and then nothing is left behind.
   */
  static bool Write(const std::string& fileName, const vtkSSAOTruthImage& image);

private:
  std::string Directory;
  bool LastWasRead = false;
};

#endif
