// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTestOpenGL.h"

#if defined(__unix__) && !defined(__APPLE__)
#include <dlfcn.h>
#endif

//------------------------------------------------------------------------------
void** vtkSSAOFindOpenGLPointer(const std::string& name)
{
#if defined(__unix__) && !defined(__APPLE__)
  // The prefix of glad's pointers differs between versions of VTK.
  for (const std::string& symbol :
    { "__glew" + name.substr(2), "vtk_glad_" + name, "vtkglad_glad_" + name, "glad_" + name })
  {
    if (void* pointer = dlsym(RTLD_DEFAULT, symbol.c_str()))
    {
      return static_cast<void**>(pointer);
    }
  }
#else
  (void)name;
#endif
  return nullptr;
}

//------------------------------------------------------------------------------
void* vtkSSAOFindOpenGL(const std::string& name)
{
#if defined(__unix__) && !defined(__APPLE__)
  if (void* function = dlsym(RTLD_DEFAULT, name.c_str()))
  {
    return function;
  }
#endif
  void** pointer = vtkSSAOFindOpenGLPointer(name);
  return pointer ? *pointer : nullptr;
}
