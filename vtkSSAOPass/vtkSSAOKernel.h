// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOKernel.h
 * @brief  Sample points and rotations, the same on every machine. No OpenGL.
 */

#ifndef vtkSSAOKernel_h
#define vtkSSAOKernel_h

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

/**
 * Points in the unit hemisphere about +z, denser near the centre (Chapman, "SSAO Tutorial", 2013;
 * LearnOpenGL, "SSAO"): a direction through a random point of the box [-1,1] x [-1,1] x [0,1],
 * times a random length, times 0.1 + 0.9 (i / size)^2. The random numbers are a four-dimensional
 * additive recurrence (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
 * size >= 1; w is 0.
 */
std::vector<glm::vec4> vtkSSAOHemisphereKernel(int size);

/**
 * Points in the unit ball in pairs through its centre, so that of an even number exactly half lie
 * behind any plane through the centre. Lengths grow from about 1/11 to 1, each (1 + 2.4 / size)
 * times the one before, as in Crytek's shader of 2007. size >= 1; w is 0.
 */
std::vector<glm::vec4> vtkSSAOSphereKernel(int size);

/**
 * Points in the unit ball, uniform by volume. size >= 1; w is 0.
 */
std::vector<glm::vec4> vtkSSAOBallKernel(int size);

/**
 * Points in the cube (-1, 1)^3, denser near the centre (OGLdev, tutorial 45): a random point of the
 * cube times 0.1 + 0.9 (i / size)^2. size >= 1; w is 0.
 */
std::vector<glm::vec4> vtkSSAOCubeKernel(int size);

/**
 * The rotations (cos, sin) of a tile of size x size pixels, row by row: size^2 angles evenly spaced
 * over the circle, neighbours far apart. size >= 1.
 */
std::vector<glm::vec2> vtkSSAORotationTile(int size);

/**
 * The random numbers of a tile of size x size pixels, row by row: x, the angle of the pixel's
 * rotation as a share of the circle; y, in (0, 1), as evenly spaced and independent of x; z and w,
 * the rotation of vtkSSAORotationTile. size >= 1.
 */
std::vector<glm::vec4> vtkSSAONoiseTile(int size);

#endif
