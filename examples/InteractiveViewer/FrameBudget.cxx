// SPDX-License-Identifier: BSD-3-Clause
#include "FrameBudget.h"

#include <algorithm>
#include <iterator>

namespace viewer
{
namespace
{
/// From the best to the cheapest.
const char* const Levels[] = { "Fast", "Fast, one of 4 x 4 pixels", "without occlusion" };
const int CoarseLevel = 1;
const int LastLevel = static_cast<int>(std::size(Levels)) - 1;
}

//------------------------------------------------------------------------------
FrameBudget::Pass* FrameBudget::Choose(Pass* chosen, bool moving)
{
  if (!moving)
  {
    this->IsMoving = false;
    return chosen;
  }
  if (!this->IsMoving) // it may be cheaper than the last movement was
  {
    this->SetLevel(std::max(0, this->Level - 1));
    this->IsMoving = true;
  }
  this->Moving->SetRadius(chosen->GetRadius());
  this->Moving->SetModulation(chosen->GetModulation());
  this->Moving->SetPower(chosen->GetPower());
  this->Moving->SetOutputMode(chosen->GetOutputMode());
  this->Moving->SetIntensity(this->Level == LastLevel ? 0.0 : chosen->GetIntensity());
  this->Moving->SetStageTiming(chosen->GetStageTiming());
  return this->Moving;
}

//------------------------------------------------------------------------------
void FrameBudget::Judge(double seconds, double budget)
{
  ++this->Frames;
  // The first frame may have to compile shaders.
  if (this->IsMoving && this->Frames > 1 && seconds > budget && this->Level < LastLevel)
  {
    this->SetLevel(this->Level + 1);
  }
}

//------------------------------------------------------------------------------
const char* FrameBudget::GetName() const
{
  return Levels[std::max(0, this->Level)];
}

//------------------------------------------------------------------------------
void FrameBudget::SetLevel(int level)
{
  this->Level = level;
  this->Frames = 0;
  this->Moving->SetQualityToFast();
  if (level >= CoarseLevel)
  {
    this->Moving->SetDownsampling(4);
  }
}
}
