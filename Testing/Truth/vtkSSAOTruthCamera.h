// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTruthCamera
 * @brief   The rays through the pixel centres that VTK's rasteriser samples.
 *
 * The matrices are those that vtkOpenGLCamera gives the mappers: model-view and projection at
 * aspect = width / height, with everything they contain (parallel or perspective, window centre,
 * shear, off-axis, user transforms), in double precision. Points are relative to an origin in the
 * scene, so that a scene far from the world's origin keeps its precision. No OpenGL is needed.
 */

#ifndef vtkSSAOTruthCamera_h
#define vtkSSAOTruthCamera_h

#include <string>

class vtkCamera;

class vtkSSAOTruthCamera
{
public:
  /**
   * The camera of a viewport of width x height pixels; origin in world coordinates.
   */
  vtkSSAOTruthCamera(vtkCamera* camera, int width, int height, const double origin[3]);

  ///@{
  /**
   * Size of the viewport in pixels.
   */
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  ///@}

  /**
   * Where the ray through the centre of pixel (x, y), counted from the bottom left, enters and
   * leaves the clipping range; world axes relative to the origin.
   */
  void GetRay(int x, int y, double nearPoint[3], double farPoint[3]) const;

  /**
   * The point at the centre of pixel (x, y) that is `depth` in front of the camera along its axis,
   * relative to the origin: the inverse of GetDepth.
   */
  void GetPoint(int x, int y, double depth, double point[3]) const;

  /**
   * Distance of a point (relative to the origin) in front of the camera along its axis.
   */
  double GetDepth(const double point[3]) const;

  /**
   * Turns a direction from world axes to view axes.
   */
  void ToView(const double world[3], double view[3]) const;

  /**
   * Whether the view mirrors the world, which makes rasterised front faces those that face away.
   */
  bool IsMirrored() const;

  /**
   * Digest of all that GetRay depends on.
   */
  std::string GetDigest() const;

private:
  int Width;
  int Height;
  double ViewMatrix[16];        // world - origin -> view, row major
  double InverseViewMatrix[16]; // view -> world - origin
  double InverseProjection[16]; // normalised device coordinates -> view, homogeneous
};

#endif
