// SPDX-License-Identifier: BSD-3-Clause

// glXGetProcAddressARB of this program. GLEW asks it for every OpenGL function beyond 1.1, and the
// one of libGL knows nothing of OSMesa: what it returns draws into the GLX context, of which there
// is none. So this definition, which comes before libGL's in the search order, answers from OSMesa
// while one of its contexts is current, and hands all other questions on. A program that also opens
// X windows keeps working, except that GLEW's table holds the functions of the last window
// initialized.

#include <GL/osmesa.h>

#include <cstring>
#include <dlfcn.h>

extern "C"
{
  using vtkSSAOProc = void (*)();

  __attribute__((visibility("default"))) vtkSSAOProc glXGetProcAddressARB(const GLubyte* name);

  vtkSSAOProc glXGetProcAddressARB(const GLubyte* name)
  {
    const char* text = reinterpret_cast<const char*>(name);
    if (OSMesaGetCurrentContext() && std::strncmp(text, "glX", 3) != 0)
    {
      return OSMesaGetProcAddress(text);
    }

    using Lookup = vtkSSAOProc (*)(const GLubyte*);
    static const Lookup next = reinterpret_cast<Lookup>(dlsym(RTLD_NEXT, "glXGetProcAddressARB"));
    return next ? next(name) : nullptr;
  }
}
