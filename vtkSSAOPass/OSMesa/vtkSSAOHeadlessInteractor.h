// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOHeadlessInteractor
 * @brief   An interactor that opens no display, for programs written for a window on a screen.
 *
 * Initialize() renders once. ProcessEvents() does nothing. Start() initializes if needed and
 * returns at once, since nobody can produce an event or close the window. Events that the program
 * invokes itself (InvokeEvent, TimerEvent, or a vtkInteractorEventRecorder that plays a log) reach
 * the interactor style, widgets and observers as usual.
 *
 * Timers can be created and destroyed, but do not fire by themselves. As with the superclass,
 * observers of CreateTimerEvent and DestroyTimerEvent may provide real ones.
 */

#ifndef vtkSSAOHeadlessInteractor_h
#define vtkSSAOHeadlessInteractor_h

#include "vtkGenericRenderWindowInteractor.h"

class vtkSSAOHeadlessInteractor : public vtkGenericRenderWindowInteractor
{
public:
  /// An interactor without a display.
  static vtkSSAOHeadlessInteractor* New();
  vtkTypeMacro(vtkSSAOHeadlessInteractor, vtkGenericRenderWindowInteractor);

protected:
  vtkSSAOHeadlessInteractor() = default;
  ~vtkSSAOHeadlessInteractor() override = default;

  ///@{
  /**
   * Succeed also without an observer; interactor styles report an error otherwise.
   */
  int InternalCreateTimer(int timerId, int timerType, unsigned long duration) override;
  int InternalDestroyTimer(int platformTimerId) override;
  ///@}

private:
  vtkSSAOHeadlessInteractor(const vtkSSAOHeadlessInteractor&) = delete;
  void operator=(const vtkSSAOHeadlessInteractor&) = delete;
};

#endif
