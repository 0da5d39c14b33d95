// SPDX-License-Identifier: BSD-3-Clause
#include "TruthError.h"

namespace viewer
{
struct TruthError::Job
{
};

TruthError::TruthError() = default;
TruthError::~TruthError() = default;
bool TruthError::IsAvailable()
{
  return false;
}
void TruthError::Start(vtkRenderer*, vtkScreenSpaceAmbientOcclusionPass*) {}
void TruthError::Cancel() {}
void TruthError::Follow(vtkRenderer*, vtkScreenSpaceAmbientOcclusionPass*) {}
void TruthError::Wait() {}
bool TruthError::IsTracing() const
{
  return false;
}
void TruthError::Compare(vtkScreenSpaceAmbientOcclusionPass*) {}
std::string TruthError::Describe() const
{
  return "not in this build";
}
}
