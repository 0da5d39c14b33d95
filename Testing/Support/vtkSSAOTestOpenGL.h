// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOTestOpenGL.h
 * @brief  OpenGL's functions as VTK calls them.
 */

#ifndef vtkSSAOTestOpenGL_h
#define vtkSSAOTestOpenGL_h

#include <string>

/**
 * Where VTK's loader, GLEW or glad, keeps the pointer of a function ("glEnable"); null if it has
 * none. GLEW has none of OpenGL 1.1.
 */
void** vtkSSAOFindOpenGLPointer(const std::string& name);

/**
 * A function: that of the library that is loaded, or else that of VTK's loader. Null if there is
 * none.
 */
void* vtkSSAOFindOpenGL(const std::string& name);

#endif
