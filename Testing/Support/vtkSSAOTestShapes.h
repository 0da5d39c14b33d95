// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkSSAOTestShapes.h
 * @brief   Small scenes that the tests share. Lengths are in world units times scale.
 */

#ifndef vtkSSAOTestShapes_h
#define vtkSSAOTestShapes_h

#include "vtkSmartPointer.h"

#include <array>

class vtkActor;
class vtkPolyData;
class vtkProperty;
class vtkRenderer;
class vtkSSAOTestView;

/**
 * A parallelogram origin, origin + a, origin + b with the normal a x b, without point normals.
 */
vtkSmartPointer<vtkPolyData> vtkSSAOQuad(
  const double (&origin)[3], const double (&a)[3], const double (&b)[3]);

/**
 * A horizontal square of edge 40 about the origin, facing up (+y).
 */
vtkActor* vtkSSAOAddFloor(vtkSSAOTestView& view, double scale = 1.0);

/**
 * A floor (y = 0, z > 0, facing up) and a wall (z = 0, y > 0, facing +z) that meet in the x axis,
 * 40 long and 20 wide.
 */
void vtkSSAOAddCorner(vtkSSAOTestView& view, double scale = 1.0);

/**
 * Camera for the corner: 45 degrees above the floor, from a distance of 20.
 */
void vtkSSAOLookAtCorner(vtkSSAOTestView& view, bool parallel, double scale = 1.0);

/**
 * A floor (z = -0.4) and up to 9 spheres about z = 0 that sink into it, all of one material if one
 * is given, seen from above. Sets the camera. A good radius is .5.
 */
void vtkSSAOAddFloorAndSpheres(
  vtkRenderer* renderer, int spheres, double radius, vtkProperty* property = nullptr);

/**
 * A still life on a floor before a wall, about 4 wide: box, sphere and torus-like ring, coloured,
 * with ambient, diffuse and specular light. Sets camera and background. A good radius is .5.
 */
void vtkSSAOAddStillLife(vtkSSAOTestView& view, double scale = 1.0);
void vtkSSAOLookAtStillLife(vtkSSAOTestView& view, bool parallel, double scale = 1.0);

/**
 * Move the points of all actors themselves, in double, and the camera with them.
 */
void vtkSSAOMoveScene(vtkSSAOTestView& view, const std::array<double, 3>& offset);

/**
 * The still life in perspective with radius .5, and V in place of the picture.
 */
void vtkSSAOShowOcclusionOfStillLife(vtkSSAOTestView& view);

#endif
