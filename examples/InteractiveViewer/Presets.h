// SPDX-License-Identifier: BSD-3-Clause
// The presets of the pass by name.
#ifndef InteractiveViewer_Presets_h
#define InteractiveViewer_Presets_h

#include <string>
#include <vector>

class vtkScreenSpaceAmbientOcclusionPass;

namespace viewer
{
struct Preset
{
  char Key;
  const char* Name;
  void (vtkScreenSpaceAmbientOcclusionPass::*Set)();
};

/// Fast, Balanced, Accurate.
const std::vector<Preset>& GetPresets();

/// The preset that the pass is set to, or that some of its controls were changed.
std::string NameOfPreset(vtkScreenSpaceAmbientOcclusionPass* pass);
}

#endif
