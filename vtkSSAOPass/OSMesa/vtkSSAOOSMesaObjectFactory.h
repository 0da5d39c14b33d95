// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOOSMesaObjectFactory
 * @brief   Makes vtkRenderWindow::New() return a window that needs no display.
 *
 * Loading the library registers one instance in front of all other factories, so it wins over
 * VTK's own X window. It overrides
 *
 * - vtkRenderWindow by vtkSSAOOSMesaRenderWindow, where VTK has no headless window of its own.
 *   Where it has one (VTK 9.4 and later), VTK is asked to choose that instead: through the
 *   environment variable VTK_DEFAULT_OPENGL_WINDOW, unless the user has set it.
 * - vtkRenderWindowInteractor by vtkSSAOHeadlessInteractor, since VTK's own opens an X display.
 */

#ifndef vtkSSAOOSMesaObjectFactory_h
#define vtkSSAOOSMesaObjectFactory_h

#include "vtkObjectFactory.h"

#ifndef VTK_FUTURE_CONST // VTK 9.1 does not have it
#define VTK_FUTURE_CONST
#endif

class vtkSSAOOSMesaObjectFactory : public vtkObjectFactory
{
public:
  /// A factory; vtkObjectFactory::RegisterFactory makes VTK use it.
  static vtkSSAOOSMesaObjectFactory* New();
  vtkTypeMacro(vtkSSAOOSMesaObjectFactory, vtkObjectFactory);

  ///@{
  /**
   * What VTK tells about its factories.
   */
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override;
  const char* GetDescription() VTK_FUTURE_CONST override;
  ///@}

protected:
  vtkSSAOOSMesaObjectFactory();
  ~vtkSSAOOSMesaObjectFactory() override = default;

private:
  vtkSSAOOSMesaObjectFactory(const vtkSSAOOSMesaObjectFactory&) = delete;
  void operator=(const vtkSSAOOSMesaObjectFactory&) = delete;
};

#endif
