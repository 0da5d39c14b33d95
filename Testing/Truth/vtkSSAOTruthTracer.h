// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthTracer
 * @brief   Ambient visibility by ray tracing (Embree), the truth that estimators are compared to.
 *
 * A ray through the pixel centre finds the surface point P that VTK shows there (within the
 * clipping range, without culled faces and what clipping planes cut away). There
 *
 *     V = sum of max(0, N.w) over the open directions w / sum of max(0, N.w) over all directions w,
 *
 * over the directions with Ng.w > 0. Ng is the normal of the facet itself, facing the viewer; N is
 * the shading normal as VTK draws it (interpolated and turned for back faces), turned to the side
 * of Ng. A direction is open if the ray from P, as long as the radius, hits no surface from either
 * side. So every convex body has V = 1 exactly, whatever its tessellation and its normals.
 *
 * The directions are drawn with density max(0, N.w) / pi about N (vtkSSAOTruthSampler), so V is the
 * open share of those with Ng.w > 0. They come in independent replicates, whose scatter gives the
 * standard error.
 *
 * A ray never hits its own facet or a coplanar or convex neighbour: a triangle or sphere that
 * nowhere rises more than 1e-4 rad above the facet's plane, seen from P, does not occlude (all such
 * surfaces together could hide 1e-8 of the cosine-weighted hemisphere about Ng). Embree traces in
 * single precision; P, that test, and what lies so near to P or to the end of the ray that single
 * precision may be wrong are computed in double. So there is no offset, and no length that depends
 * on the scale of the scene.
 *
 * The image does not depend on the number of threads.
 */

#ifndef vtkSSAOTruthTracer_h
#define vtkSSAOTruthTracer_h

#include <functional>
#include <string>
#include <utility>

class vtkSSAOTruthCamera;
class vtkSSAOTruthScene;
struct vtkSSAOTruthImage;

class vtkSSAOTruthTracer
{
public:
  ///@{
  /**
   * Distance within which surfaces occlude, in world units. Range (0, inf], infinity included;
   * default 1.
   */
  void SetRadius(double radius) { this->Radius = radius; }
  double GetRadius() const { return this->Radius; }
  ///@}

  ///@{
  /**
   * Directions tried per pixel. At least 1; default 256. Rounded up to a multiple of Replicates;
   * best is Replicates times a power of two.
   */
  void SetRaysPerPixel(int rays) { this->RaysPerPixel = rays; }
  int GetRaysPerPixel() const { return this->RaysPerPixel; }
  ///@}

  ///@{
  /**
   * Independent low-discrepancy sets that the rays of a pixel are divided into. More sets give a
   * surer standard error, fewer a smaller error. At least 2; default 4.
   */
  void SetReplicates(int replicates) { this->Replicates = replicates; }
  int GetReplicates() const { return this->Replicates; }
  ///@}

  ///@{
  /**
   * Threads that trace; 0, the default, is one per processor. The image is the same for any.
   */
  void SetThreads(int threads) { this->Threads = threads; }
  int GetThreads() const { return this->Threads; }
  ///@}

  ///@{
  /**
   * For tests only: without the cosine weight all directions above the surface weigh the same;
   * without the cutoff surfaces occlude at any distance. Both on by default.
   */
  void SetCosineWeight(bool cosineWeight) { this->CosineWeight = cosineWeight; }
  void SetCutoff(bool cutoff) { this->Cutoff = cutoff; }
  ///@}

  /**
   * Called after each row of pixels, by the threads that trace, with the share of the rows that is
   * done. Tracing stops where it returns false. None by default.
   */
  void SetProgress(std::function<bool(double share)> progress)
  {
    this->Progress = std::move(progress);
  }

  /**
   * Digest of the version of the algorithm and of the settings that change the image.
   */
  std::string GetDigest() const;

  /**
   * Traces the view of a scene. The camera must have been made with the scene's origin. Returns
   * false, with a message and an image of background, where a setting is out of range or Embree
   * fails, and without a message where the progress function stopped it.
   */
  bool Trace(const vtkSSAOTruthScene& scene, const vtkSSAOTruthCamera& camera,
    vtkSSAOTruthImage& image) const;

private:
  double Radius = 1.0;
  int RaysPerPixel = 256;
  int Replicates = 4;
  int Threads = 0;
  bool CosineWeight = true;
  bool Cutoff = true;
  std::function<bool(double share)> Progress;
};

#endif
