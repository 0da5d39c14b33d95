// SPDX-License-Identifier: BSD-3-Clause

// Estimators, denoisers, kernel and tile sizes and all other controls are changed 1,000 times:
// textures and programs stay as many as they were, and the picture is the one before.

#include "vtkRenderWindow.h"
#include "vtkSSAOTestEstimators.h"

namespace
{
//------------------------------------------------------------------------------
void Set(vtkScreenSpaceAmbientOcclusionPass* pass, int step)
{
  pass->SetEstimator(step % vtkSSAOTest::NumberOfEstimators);
  pass->SetDenoiser(step % 5);
  pass->SetNoiseSize(2 + step % 6);
  pass->SetDownsampling(1 + step % 3);
  pass->SetLayers(1 + 4 * (step % 3));
  pass->SetThickness(0.1 * (step % 2));
  pass->SetKernelSize(4 + step % 29);
  pass->SetDirections(1 + step % 4);
  pass->SetSteps(1 + step % 3);
  pass->SetAngleBias(step % 40);
  pass->SetHalfRule(step % 2 == 0);
  pass->SetRangeCheck(step % 3 == 0);
  pass->SetMinimumDifference(0.01 * (step % 10));
  pass->SetFalloff(step % 3);
  pass->SetAttenuation(1.0 + step % 2);
  step % 2 ? pass->SetBias(0.01) : pass->SetBiasToAutomatic();
  pass->SetRadius(0.5 + 0.1 * (step % 4));
}
}

//------------------------------------------------------------------------------
int TestEstimatorSwitching(int, char*[])
{
  vtkSSAOTestMonitor test;
  vtkSSAOTestView view(test, 24, 16);
  vtkSSAOAddStillLife(view);
  vtkSSAOLookAtStillLife(view, false);
  // Once each, so that all programs are built.
  for (int step = 0; step < 45; ++step)
  {
    Set(view.Pass, step);
    view.Visibility();
  }
  Set(view.Pass, 3);
  const vtkSSAOTestImage before = view.Visibility();
  const int builds = view.Pass->GetNumberOfProgramBuilds();
  const unsigned long bytes = view.Pass->GetTextureMemory();
  const char* kinds[] = { "Texture", "Program", "Shader", "Framebuffer", "Buffer" };
  std::vector<int> counts;
  for (const char* kind : kinds)
  {
    counts.push_back(vtkSSAOCountObjects(view.Window, kind));
  }
  // Whole rounds of the settings: textures that wait for their estimator have the same sizes again.
  for (int step = 0; step < 1035; ++step)
  {
    Set(view.Pass, step);
    view.Visibility();
  }
  Set(view.Pass, 3);
  test.Expect(view.Visibility() == before, "the picture is the one before");
  test.ExpectEqual(view.Pass->GetNumberOfProgramBuilds(), builds, "programs built");
  // Nine estimators, four denoisers, the interpolation, gaps, solids of 5 and of 9 layers, and the
  // modulation of the light.
  test.ExpectAtMost(builds, 18, "of these before");
  test.ExpectEqual(static_cast<double>(view.Pass->GetTextureMemory()), static_cast<double>(bytes),
    "texture bytes");
  for (int i = 0; i < 5; ++i)
  {
    test.ExpectEqual(vtkSSAOCountObjects(view.Window, kinds[i]), counts[i],
      std::string("OpenGL objects of the kind ") + kinds[i]);
  }
  return test.GetResult();
}
