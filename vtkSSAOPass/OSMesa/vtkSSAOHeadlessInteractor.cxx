// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOHeadlessInteractor.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSSAOHeadlessInteractor);

//------------------------------------------------------------------------------
int vtkSSAOHeadlessInteractor::InternalCreateTimer(
  int timerId, int timerType, unsigned long duration)
{
  const int platformTimerId = this->Superclass::InternalCreateTimer(timerId, timerType, duration);
  return platformTimerId ? platformTimerId : timerId;
}

//------------------------------------------------------------------------------
int vtkSSAOHeadlessInteractor::InternalDestroyTimer(int platformTimerId)
{
  this->Superclass::InternalDestroyTimer(platformTimerId);
  return 1;
}
