// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportMethods.h"

#include "vtkNew.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"

#include <array>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

//------------------------------------------------------------------------------
// VTK's own pass as applications use it: over the render steps, blur on, bias 1 % of the radius.
vtkSSAOReportMethod VTKMethod(int kernelSize)
{
  vtkSSAOReportMethod method;
  method.Name = "VTK K=" + std::to_string(kernelSize);
  method.Family = "vtkSSAOPass (VTK)";
  method.Samples = kernelSize;
  method.IsVTK = true;
  method.NewPass = [kernelSize](double radius)
  {
    auto pass = vtkSmartPointer<vtkSSAOPass>::New();
    vtkNew<vtkRenderStepsPass> steps;
    pass->SetDelegatePass(steps);
    pass->SetRadius(radius);
    pass->SetBias(0.01 * radius);
    pass->SetKernelSize(kernelSize);
    pass->BlurOn();
    return vtkSmartPointer<vtkImageProcessingPass>(pass);
  };
  return method;
}

//------------------------------------------------------------------------------
vtkSSAOReportMethod OurMethod(const std::string& name, const std::string& family, int samples,
  const std::function<void(Pass*)>& configure)
{
  vtkSSAOReportMethod method;
  method.Name = name;
  method.Family = family;
  method.Samples = samples;
  method.NewPass = [configure](double radius)
  {
    auto pass = vtkSmartPointer<Pass>::New();
    pass->SetRadius(radius);
    configure(pass);
    return vtkSmartPointer<vtkImageProcessingPass>(pass);
  };
  return method;
}

//------------------------------------------------------------------------------
vtkSSAOReportMethod HemisphereMethod(int kernelSize, int denoiser, const std::string& denoiserName)
{
  const std::string family =
    "Hemisphere" + (denoiserName.empty() ? std::string() : ", " + denoiserName);
  return OurMethod(family + " K=" + std::to_string(kernelSize), family, kernelSize,
    [kernelSize, denoiser](Pass* pass)
    {
      pass->SetEstimatorToHemisphere();
      pass->SetKernelSize(kernelSize);
      pass->SetDenoiser(denoiser);
    });
}

//------------------------------------------------------------------------------
// The other systems with as many samples as their sources use, denoised alike.
vtkSSAOReportMethod KernelMethod(const std::string& name, int estimator, int kernelSize)
{
  return OurMethod(name + " K=" + std::to_string(kernelSize), name, kernelSize,
    [estimator, kernelSize](Pass* pass)
    {
      pass->SetEstimator(estimator);
      pass->SetKernelSize(kernelSize);
    });
}

//------------------------------------------------------------------------------
vtkSSAOReportMethod HorizonMethod(int directions, int steps)
{
  return OurMethod("HorizonAngle " + std::to_string(directions) + "x" + std::to_string(steps),
    "HorizonAngle", directions * steps,
    [directions, steps](Pass* pass)
    {
      pass->SetEstimatorToHorizonAngle();
      pass->SetDirections(directions);
      pass->SetSteps(steps);
    });
}

//------------------------------------------------------------------------------
// Estimators that cut the hemisphere into slices, every pixel estimated.
vtkSSAOReportMethod SliceMethod(const std::string& name, int estimator, int directions, int steps,
  int layers, int denoiser = Pass::EdgeAware)
{
  const std::string family = name +
    (estimator == Pass::LayeredBitmask && layers != 5
        ? ", " + std::to_string(layers) + (layers == 1 ? " layer" : " layers")
        : "");
  return OurMethod(family + " " + std::to_string(directions) + "x" + std::to_string(steps), family,
    2 * directions * steps,
    [estimator, directions, steps, layers, denoiser](Pass* pass)
    {
      pass->SetEstimator(estimator);
      pass->SetDirections(directions);
      pass->SetSteps(steps);
      pass->SetLayers(layers);
      pass->SetNoiseSize(2);
      pass->SetDownsampling(1);
      pass->SetDenoiser(denoiser);
    });
}

//------------------------------------------------------------------------------
// Sweeps of slices x steps: few but far apart, as each costs every view its frames.
void AddSlices(std::vector<vtkSSAOReportMethod>& methods, bool quick)
{
  using Slices = std::array<int, 2>;
  const std::vector<Slices> sweep = quick
    ? std::vector<Slices>{ Slices{ { 2, 8 } } }
    : std::vector<Slices>{ Slices{ { 1, 6 } }, Slices{ { 2, 8 } }, Slices{ { 4, 16 } } };
  for (const Slices& slices : sweep)
  {
    methods.push_back(SliceMethod("ExactHorizon", Pass::ExactHorizon, slices[0], slices[1], 5));
    methods.push_back(SliceMethod("LayeredBitmask", Pass::LayeredBitmask, slices[0], slices[1], 5));
  }
  if (!quick)
  {
    methods.push_back(SliceMethod("LayeredBitmask", Pass::LayeredBitmask, 2, 8, 1));
    methods.push_back(SliceMethod("LayeredBitmask", Pass::LayeredBitmask, 2, 8, 9));
    methods.push_back(
      SliceMethod("LayeredBitmask, raw", Pass::LayeredBitmask, 2, 8, 5, Pass::None));
  }
}

//------------------------------------------------------------------------------
// Every other estimator and denoiser once; quick: with fewer samples than the sources use.
void AddSystems(std::vector<vtkSSAOReportMethod>& methods, bool quick)
{
  methods.push_back(KernelMethod("CrytekSphere", Pass::CrytekSphere, 32));
  methods.push_back(KernelMethod("PositionSphere", Pass::PositionSphere, quick ? 32 : 128));
  methods.push_back(KernelMethod("DepthSphere", Pass::DepthSphere, quick ? 32 : 128));
  methods.push_back(
    KernelMethod("HemisphereLinearDepth", Pass::HemisphereLinearDepth, quick ? 32 : 64));
  methods.push_back(KernelMethod("ReflectedHemisphere", Pass::ReflectedHemisphere, 26));
  methods.push_back(HorizonMethod(6, 4));
  methods.push_back(HemisphereMethod(32, Pass::Box, "box"));
  methods.push_back(HemisphereMethod(32, Pass::BoxCentered, "centred box"));
  methods.push_back(HemisphereMethod(32, Pass::SeparableGaussian, "Gaussian"));
}
}

//------------------------------------------------------------------------------
std::vector<vtkSSAOReportMethod> vtkSSAOReportMethods(bool quick)
{
  std::vector<vtkSSAOReportMethod> methods;
  for (int kernelSize : { 32, 64, 256 })
  {
    methods.push_back(VTKMethod(kernelSize));
  }
  methods.push_back(OurMethod("Fast", "Preset", 0, [](Pass* pass) { pass->SetQualityToFast(); }));
  methods.push_back(
    OurMethod("Balanced", "Preset", 0, [](Pass* pass) { pass->SetQualityToBalanced(); }));
  methods.push_back(
    OurMethod("Accurate", "Preset", 0, [](Pass* pass) { pass->SetQualityToAccurate(); }));
  // Sweeps of the number of samples: few but far apart, as each costs every view its frames.
  const std::vector<int> kernelSizes =
    quick ? std::vector<int>{ 8, 128 } : std::vector<int>{ 8, 32, 128 };
  for (int kernelSize : kernelSizes)
  {
    methods.push_back(HemisphereMethod(kernelSize, Pass::EdgeAware, ""));
  }
  if (!quick)
  {
    methods.push_back(HemisphereMethod(32, Pass::None, "raw"));
  }
  AddSlices(methods, quick);
  AddSystems(methods, quick);
  return methods;
}
