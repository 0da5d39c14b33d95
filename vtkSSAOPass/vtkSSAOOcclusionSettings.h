// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOOcclusionSettings.h
 * @brief  What the estimators need to know. No OpenGL.
 */

#ifndef vtkSSAOOcclusionSettings_h
#define vtkSSAOOcclusionSettings_h

#include "vtkSSAOKernel.h"                      // For the sample points
#include "vtkScreenSpaceAmbientOcclusionPass.h" // For the controls

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
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
  int Downsampling = 1;
  int LayerDownsampling = 1;
  int Layers = 5;
  double Sheet = 0.1;      ///< thickness of what has no known back, world units
  bool SheetsOnly = false; ///< every surface is that thick

  /**
   * Whether the estimator asks for more than the first surface.
   */
  bool LooksBehind() const
  {
    return this->Estimator == vtkScreenSpaceAmbientOcclusionPass::LayeredBitmask;
  }

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
    settings.Layers = pass->GetLayers();
    // The interpolation is the edge-aware denoiser's.
    settings.Downsampling = pass->GetDenoiser() == vtkScreenSpaceAmbientOcclusionPass::EdgeAware
      ? pass->GetDownsampling()
      : 1;
    settings.LayerDownsampling = std::max(pass->GetLayerDownsampling(), settings.Downsampling);
    settings.SheetsOnly = pass->GetThickness() > 0.0;
    settings.Sheet = settings.SheetsOnly ? pass->GetThickness() : 0.1 * settings.Radius;
    return settings;
  }

  /**
   * Whether the estimator cuts the hemisphere into slices.
   */
  bool UsesSlices() const
  {
    return this->Estimator == vtkScreenSpaceAmbientOcclusionPass::ExactHorizon ||
      this->Estimator == vtkScreenSpaceAmbientOcclusionPass::LayeredBitmask;
  }

  /**
   * Pixels that the radius must cover for samples to be taken: those of slices are 1.3 pixels off
   * at least.
   */
  double LeastReach() const { return this->UsesSlices() ? 1.3 : 0.0; }

  /**
   * The random numbers of the pixels, see vtkSSAONoiseTile. For slices the angle is that of the
   * first of them, which saves the shader its sines.
   */
  std::vector<glm::vec4> MakeNoise() const
  {
    std::vector<glm::vec4> tile = vtkSSAONoiseTile(this->NoiseSize);
    for (glm::vec4& noise : tile)
    {
      if (this->UsesSlices())
      {
        const double angle = this->SliceAngle() * noise.x;
        noise.z = static_cast<float>(std::cos(angle));
        noise.w = static_cast<float>(std::sin(angle));
      }
    }
    return tile;
  }

  /**
   * Angle from one slice to the next, radians.
   */
  double SliceAngle() const { return glm::pi<double>() / this->Directions; }

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
