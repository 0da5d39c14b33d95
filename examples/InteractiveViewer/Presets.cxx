// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include <vtkNew.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>

#include <array>

namespace viewer
{
namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

/// What a preset sets.
std::array<double, 9> ControlsOf(Pass* pass)
{
  return { static_cast<double>(pass->GetEstimator()), static_cast<double>(pass->GetDirections()),
    static_cast<double>(pass->GetSteps()), static_cast<double>(pass->GetLayers()),
    pass->GetThickness(), static_cast<double>(pass->GetNoiseSize()),
    static_cast<double>(pass->GetDownsampling()), static_cast<double>(pass->GetLayerDownsampling()),
    static_cast<double>(pass->GetDenoiser()) };
}
}

//------------------------------------------------------------------------------
const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = { { '1', "Fast", &Pass::SetQualityToFast },
    { '2', "Balanced", &Pass::SetQualityToBalanced },
    { '3', "Accurate", &Pass::SetQualityToAccurate } };
  return presets;
}

//------------------------------------------------------------------------------
std::string NameOfPreset(Pass* pass)
{
  for (const Preset& preset : GetPresets())
  {
    vtkNew<Pass> other;
    (other->*preset.Set)();
    if (ControlsOf(other) == ControlsOf(pass))
    {
      return preset.Name;
    }
  }
  return "no preset";
}
}
