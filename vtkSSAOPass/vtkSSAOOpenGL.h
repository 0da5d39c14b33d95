// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOOpenGL.h
 * @brief  What differs between the VTK versions the module compiles for.
 *
 * OpenGL's enumerants come from GLEW up to VTK 9.3 and from glad from VTK 9.4 on; vtkOpenGLError.h
 * brings whichever it is. Only enumerants are taken from there: all calls go through VTK's classes.
 */

#ifndef vtkSSAOOpenGL_h
#define vtkSSAOOpenGL_h

#include "vtkObject.h" // vtkOpenGLError.h needs the complete type

#include "vtkOpenGLError.h"

#endif
