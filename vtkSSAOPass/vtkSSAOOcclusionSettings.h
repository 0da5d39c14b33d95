// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOOcclusionSettings.h
 * @brief  What the estimators need to know. No OpenGL.
 */

#ifndef vtkSSAOOcclusionSettings_h
#define vtkSSAOOcclusionSettings_h

#include "vtkSSAOKernel.h"                      // For the sample points
#include "vtkScreenSpaceAmbientOcclusionPass.h" // For the controls

#include <algorithm>
#include <vector>

/**
 * The controls of the public class, with those that are automatic worked out for a radius: lengths
 * in world units, angles in degrees.
 */
struct vtkSSAOOcclusionSettings
{
  int Estimator = vtkScreenSpaceAmbientOcclusionPass::Hemisphere;
  double Radius = 1.0;
  double Bias = 0.0;
  int KernelSize = 32;
  int NoiseSize = 4;
  bool RangeCheck = true;
  bool HalfRule = true;
  double MinimumDifference = 0.01;
  double Attenuation = 1.0;
  int Falloff = vtkScreenSpaceAmbientOcclusionPass::PowerFalloff;
  int Directions = 6;
  int Steps = 4;
  double AngleBias = 30.0;

  /**
   * The settings of a pass with its effective radius and effective bias.
   */
  static vtkSSAOOcclusionSettings Of(vtkScreenSpaceAmbientOcclusionPass* pass)
  {
    vtkSSAOOcclusionSettings settings;
    settings.Estimator = pass->GetEstimator();
    // A scene without extent has no automatic radius; single precision squares lengths.
    settings.Radius = std::min(std::max(pass->GetEffectiveRadius(), 1.0e-15), 1.0e15);
    settings.Bias = pass->GetEffectiveBias();
    settings.KernelSize = pass->GetKernelSize();
    settings.NoiseSize = pass->GetNoiseSize();
    settings.RangeCheck = pass->GetRangeCheck();
    settings.HalfRule = pass->GetHalfRule();
    settings.MinimumDifference = pass->GetMinimumDifference();
    settings.Attenuation = pass->GetAttenuation();
    settings.Falloff = pass->GetFalloff();
    settings.Directions = pass->GetDirections();
    settings.Steps = pass->GetSteps();
    settings.AngleBias = pass->GetAngleBias();
    return settings;
  }

  /**
   * The sample points of the estimator; any for one without.
   */
  std::vector<glm::vec4> MakeKernel() const
  {
    switch (this->Estimator)
    {
      case vtkScreenSpaceAmbientOcclusionPass::CrytekSphere:
        return vtkSSAOSphereKernel(this->KernelSize);
      case vtkScreenSpaceAmbientOcclusionPass::PositionSphere:
      case vtkScreenSpaceAmbientOcclusionPass::DepthSphere:
        return vtkSSAOCubeKernel(this->KernelSize);
      case vtkScreenSpaceAmbientOcclusionPass::ReflectedHemisphere:
        return vtkSSAOBallKernel(this->KernelSize);
      default:
        return vtkSSAOHemisphereKernel(this->KernelSize);
    }
  }
};

#endif
