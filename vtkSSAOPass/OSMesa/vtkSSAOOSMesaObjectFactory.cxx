// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOOSMesaObjectFactory.h"

#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSSAOHeadlessInteractor.h"
#include "vtkVersion.h"

#ifdef VTKSSAO_OSMESA_OWN_WINDOW
#include "vtkSSAOOSMesaRenderWindow.h"
#else
#include <cstdlib>
#include <dlfcn.h>
#endif

vtkStandardNewMacro(vtkSSAOOSMesaObjectFactory);

VTK_CREATE_CREATE_FUNCTION(vtkSSAOHeadlessInteractor);
#ifdef VTKSSAO_OSMESA_OWN_WINDOW
VTK_CREATE_CREATE_FUNCTION(vtkSSAOOSMesaRenderWindow);
#endif

namespace
{
#ifndef VTKSSAO_OSMESA_OWN_WINDOW
// VTK 9.4 and later contain the OSMesa and the EGL window and choose between these and X at run
// time by an environment variable. Mesa 25.1 and later have no OSMesa; EGL is headless there.
void ChooseWindowOfVTK()
{
  bool hasOSMesa = false;
  for (const char* name : { "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so" })
  {
    if (void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL))
    {
      hasOSMesa = true;
      dlclose(library);
      break;
    }
  }
  const int overwrite = 0;
  setenv("VTK_DEFAULT_OPENGL_WINDOW", hasOSMesa ? "vtkOSOpenGLRenderWindow" : "vtkEGLRenderWindow",
    overwrite);
}
#endif

// Runs when the library is loaded. VTK asks its factories in the order of this list, and
// RegisterFactory appends.
bool RegisterInFront()
{
  vtkNew<vtkSSAOOSMesaObjectFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  vtkCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  if (factories->GetNumberOfItems() > 1) // vtkCollection cannot insert into an empty list
  {
    factories->RemoveItem(factory);
    factories->InsertItem(-1, factory);
  }
#ifndef VTKSSAO_OSMESA_OWN_WINDOW
  ChooseWindowOfVTK();
#endif
  return true;
}

const bool Registered = RegisterInFront();
}

//------------------------------------------------------------------------------
vtkSSAOOSMesaObjectFactory::vtkSSAOOSMesaObjectFactory()
{
  const int enabled = 1;
#ifdef VTKSSAO_OSMESA_OWN_WINDOW
  this->RegisterOverride("vtkRenderWindow", "vtkSSAOOSMesaRenderWindow",
    "render window in memory through libOSMesa", enabled,
    vtkObjectFactoryCreatevtkSSAOOSMesaRenderWindow);
#endif
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkSSAOHeadlessInteractor",
    "interactor that opens no display", enabled, vtkObjectFactoryCreatevtkSSAOHeadlessInteractor);
}

//------------------------------------------------------------------------------
const char* vtkSSAOOSMesaObjectFactory::GetVTKSourceVersion() VTK_FUTURE_CONST
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkSSAOOSMesaObjectFactory::GetDescription() VTK_FUTURE_CONST
{
  return "Headless render window and interactor of vtkSSAOPass::OSMesa";
}
