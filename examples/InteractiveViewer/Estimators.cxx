// SPDX-License-Identifier: BSD-3-Clause
#include "Estimators.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>

namespace viewer
{
namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

const char* const Names[] = { "CrytekSphere", "PositionSphere", "DepthSphere", "Hemisphere",
  "HemisphereLinearDepth", "ReflectedHemisphere", "HorizonAngle", "ExactHorizon",
  "LayeredBitmask" };

std::string NameOf(int estimator)
{
  const int count = sizeof(Names) / sizeof(Names[0]);
  return estimator < count ? Names[estimator] : "estimator " + std::to_string(estimator);
}

/// Where the samples are directions x steps, the kernel size sets these.
bool TakesDirections(int estimator)
{
  vtkNew<Pass> pass;
  pass->SetEstimator(estimator);
  pass->SetDirections(1);
  pass->SetSteps(1);
  pass->SetKernelSize(64);
  return pass->GetDirections() > 1;
}
}

//------------------------------------------------------------------------------
std::vector<Estimator> FindEstimators()
{
  vtkNew<Pass> pass;
  vtkNew<vtkCallbackCommand> silence; // an error that is observed is not printed
  pass->AddObserver(vtkCommand::ErrorEvent, silence);
  std::vector<Estimator> estimators;
  for (int value = 0; value < 64; ++value)
  {
    pass->SetEstimator(value);
    if (pass->GetEstimator() == value)
    {
      estimators.push_back({ value, NameOf(value), TakesDirections(value) });
    }
  }
  return estimators;
}
}
