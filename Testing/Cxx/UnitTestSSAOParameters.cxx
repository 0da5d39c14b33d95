// SPDX-License-Identifier: BSD-3-Clause

// Defaults, presets, ranges, what is refused, and what PrintSelf prints.

#include "vtkNew.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

struct Parameter
{
  std::string Name;
  double Default;
  std::vector<double> Good; ///< ends of the range among them
  std::vector<double> Bad;
  std::function<void(Pass*, double)> Set;
  std::function<double(Pass*)> Get;
  bool Whole;
};

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

#define PARAMETER(name, standard, whole, ...)                                                \
  {                                                                                          \
#name, standard, __VA_ARGS__, [](Pass * pass, double value) { pass->Set##name(value); }, \
      [](Pass * pass) { return static_cast<double>(pass->Get##name()); }, whole              \
  }

//------------------------------------------------------------------------------
std::vector<Parameter> Parameters()
{
  const std::vector<double> never = { NaN, Infinity, -Infinity };
  const auto with = [&](std::vector<double> values)
  {
    values.insert(values.end(), never.begin(), never.end());
    return values;
  };
  return {
    PARAMETER(Radius, 0.0, false, { 0.0, 1.0e-30, 0.5, 1.0e30 }, with({ -1.0, -1.0e-30 })),
    PARAMETER(Bias, -1.0, false, { 0.0, 1.0e-30, 0.5, 1.0e30 }, with({ -0.5, -1.0e-30 })),
    PARAMETER(Intensity, 1.0, false, { 0.0, 0.5, 10.0 }, with({ -0.1, 10.1 })),
    PARAMETER(Power, 1.0, false, { 0.01, 2.0, 16.0 }, with({ 0.0, -1.0, 16.5 })),
    PARAMETER(IntensityScale, 1.0, false, { 0.0, 0.5, 10.0 }, with({ -0.1, 10.1 })),
    PARAMETER(IntensityShift, 0.0, false, { -1.0, 0.5, 1.0 }, with({ -1.1, 1.1 })),
    PARAMETER(VolumeOpacityThreshold, 0.9, false, { 0.0, 0.5, 1.0 }, with({ -0.1, 1.1 })),
    PARAMETER(KernelSize, 32.0, true, { 1, 7, 1024 }, { 0, -1, 1025, 2147483647 }),
    PARAMETER(NoiseSize, 4.0, true, { 1, 3, 64 }, { 0, -1, 65, 2147483647 }),
    PARAMETER(Denoiser, Pass::EdgeAware, true, { 0, 1, 4 }, { -1, 5, 1000 }),
    PARAMETER(Modulation, Pass::AmbientAndDiffuse, true, { 0, 1, 2 }, { -1, 3 }),
    PARAMETER(OutputMode, Pass::Composite, true, { 0, 1, 2, 3, 4 }, { -1, 5 }),
    PARAMETER(
      Estimator, Pass::LayeredBitmask, true, { 0, 1, 2, 3, 4, 5, 6, 7, 8 }, { -1, 9, 1000 }),
    PARAMETER(Layers, 5.0, true, { 1, 2, 5, 9 }, { 0, -1, 10, 2147483647 }),
    PARAMETER(Thickness, 0.0, false, { 0.0, 1.0e-30, 0.5, 1.0e30 }, with({ -1.0, -1.0e-30 })),
    PARAMETER(Downsampling, 2.0, true, { 1, 2, 4 }, { 0, -1, 5, 2147483647 }),
    PARAMETER(LayerDownsampling, 4.0, true, { 1, 2, 4 }, { 0, -1, 5, 2147483647 }),
    PARAMETER(Directions, 1.0, true, { 1, 7, 64 }, { 0, -1, 65, 2147483647 }),
    PARAMETER(Steps, 10.0, true, { 1, 7, 64 }, { 0, -1, 65, 2147483647 }),
    PARAMETER(AngleBias, 30.0, false, { 0.0, 45.0, 89.0 }, with({ -0.1, 89.5, 90.0 })),
    PARAMETER(HalfRule, 1.0, true, { 0, 1 }, {}),
    PARAMETER(RangeCheck, 1.0, true, { 0, 1 }, {}),
    PARAMETER(MinimumDifference, 0.01, false, { 0.0, 0.5, 1.0 }, with({ -0.01, 1.01 })),
    PARAMETER(Attenuation, 1.0, false, { 0.01, 2.0, 100.0 }, with({ 0.0, -1.0, 100.5 })),
    PARAMETER(Falloff, Pass::PowerFalloff, true, { 0, 1, 2 }, { -1, 3, 1000 }),
  };
}
#undef PARAMETER

//------------------------------------------------------------------------------
void TestParameter(vtkSSAOTestMonitor& test, const Parameter& parameter)
{
  vtkNew<Pass> pass;
  vtkSSAOErrorObserver observer(pass);
  test.ExpectEqual(parameter.Get(pass), parameter.Default, parameter.Name + " by default");
  for (double value : parameter.Good)
  {
    vtkMTimeType before = pass->GetMTime();
    const bool change = parameter.Get(pass) != value;
    parameter.Set(pass, value);
    test.ExpectEqual(parameter.Get(pass), value, parameter.Name + " after setting it");
    test.Expect((pass->GetMTime() > before) == change,
      parameter.Name + (change ? " modifies the pass" : " to the same does not modify the pass"));
    before = pass->GetMTime();
    parameter.Set(pass, value);
    test.Expect(pass->GetMTime() == before, parameter.Name + " again does not modify the pass");
  }
  test.ExpectEqual(
    observer.GetErrors() + observer.GetWarnings(), 0, parameter.Name + ": errors for good values");

  const double kept = parameter.Get(pass);
  for (double value : parameter.Bad)
  {
    std::ostringstream what;
    what << parameter.Name << " " << value << ": ";
    observer.Reset();
    const vtkMTimeType before = pass->GetMTime();
    parameter.Set(pass, value);
    test.ExpectEqual(observer.GetErrors(), 1, what.str() + "errors");
    std::ostringstream number;
    number << value;
    if (parameter.Whole)
    {
      number.str(std::to_string(static_cast<int>(value)));
    }
    test.Expect(observer.GetText().find(parameter.Name) != std::string::npos,
      what.str() + "the error names the parameter");
    // A large whole number may be printed with an exponent.
    test.Expect(
      std::abs(value) > 1.0e6 || observer.GetText().find(number.str()) != std::string::npos,
      what.str() + "the error names the value");
    test.ExpectEqual(parameter.Get(pass), kept, what.str() + "the value that stays");
    test.Expect(pass->GetMTime() == before, what.str() + "the pass is not modified");
  }
}

//------------------------------------------------------------------------------
void TestOthers(vtkSSAOTestMonitor& test)
{
  vtkNew<Pass> pass;
  vtkSSAOErrorObserver observer(pass);
  pass->SetBias(0.25);
  pass->SetBiasToAutomatic();
  test.ExpectEqual(pass->GetBias(), -1.0, "automatic bias");
  pass->SetRadius(2.5);
  test.ExpectEqual(pass->GetEffectiveRadius(), 2.5, "effective radius before any render");

  // Estimator, slices, samples to a side, noise, downsampling, that of layers.
  const int wanted[][6] = { { Pass::ExactHorizon, 1, 8, 4, 2, 2 },
    { Pass::LayeredBitmask, 1, 10, 4, 2, 4 }, { Pass::LayeredBitmask, 1, 14, 4, 1, 2 } };
  const std::function<void()> presets[] = { [&] { pass->SetQualityToFast(); },
    [&] { pass->SetQualityToBalanced(); }, [&] { pass->SetQualityToAccurate(); } };
  for (int preset = 0; preset < 3; ++preset)
  {
    pass->SetEstimatorToHemisphere();
    pass->SetDenoiserToNone();
    pass->SetLayers(9);
    pass->SetThickness(0.25);
    pass->SetLayerDownsampling(3);
    presets[preset]();
    test.ExpectEqual(pass->GetEstimator(), wanted[preset][0], "estimator of a preset");
    test.ExpectEqual(pass->GetDirections(), wanted[preset][1], "directions of a preset");
    test.ExpectEqual(pass->GetSteps(), wanted[preset][2], "steps of a preset");
    test.ExpectEqual(pass->GetNoiseSize(), wanted[preset][3], "noise size of a preset");
    test.ExpectEqual(pass->GetDownsampling(), wanted[preset][4], "downsampling of a preset");
    test.ExpectEqual(
      pass->GetLayerDownsampling(), wanted[preset][5], "layer downsampling of a preset");
    test.ExpectEqual(pass->GetLayers(), 5, "layers of a preset");
    test.ExpectEqual(pass->GetThickness(), 0.0, "thickness of a preset");
    test.ExpectEqual(pass->GetDenoiser(), Pass::EdgeAware, "denoiser of a preset");
  }
  vtkNew<Pass> standard;
  test.ExpectEqual(standard->GetEstimator(), Pass::LayeredBitmask, "estimator by default");

  // The systems of the sources get what they were made for.
  for (int estimator = Pass::CrytekSphere; estimator <= Pass::LayeredBitmask; ++estimator)
  {
    const bool slices = estimator >= Pass::ExactHorizon;
    pass->SetQualityToFast();
    pass->SetNoiseSize(7);
    pass->SetEstimator(estimator);
    const std::string what = "after changing to estimator " + std::to_string(estimator);
    test.ExpectEqual(pass->GetNoiseSize(), slices ? 7 : 4, "noise size " + what);
    test.ExpectEqual(pass->GetDownsampling(), slices ? 2 : 1, "downsampling " + what);
    test.ExpectEqual(pass->GetDirections(), slices ? 1 : 6, "directions " + what);
    test.ExpectEqual(pass->GetSteps(), slices ? 8 : 4, "steps " + what);
    if (!slices)
    {
      pass->SetNoiseSize(5);
      pass->SetDownsampling(3);
      pass->SetEstimator(estimator);
      test.ExpectEqual(pass->GetNoiseSize(), 5, "noise size stays where the estimator does");
      test.ExpectEqual(pass->GetDownsampling(), 3, "downsampling stays where the estimator does");
    }
  }

  pass->SetDenoiserToBox();
  pass->BlurOn();
  test.ExpectEqual(pass->GetDenoiser(), Pass::Box, "BlurOn keeps the denoiser");
  pass->BlurOff();
  test.ExpectEqual(pass->GetDenoiser(), Pass::None, "BlurOff");
  test.Expect(!pass->GetBlur(), "blur is off");
  pass->SetBlur(true);
  test.ExpectEqual(pass->GetDenoiser(), Pass::EdgeAware, "SetBlur(true)");
  test.Expect(pass->GetBlur(), "blur is on");
  pass->SetDepthFormat(3);
  test.ExpectEqual(pass->GetDepthFormat(), 3, "depth format");
  test.ExpectEqual(observer.GetErrors() + observer.GetWarnings(), 0, "errors of all that");
}

//------------------------------------------------------------------------------
void TestPrintSelf(vtkSSAOTestMonitor& test)
{
  vtkNew<Pass> pass;
  pass->SetRadius(0.515625);
  pass->SetBias(0.0625);
  pass->SetKernelSize(77);
  pass->SetDirections(11);
  pass->SetSteps(13);
  pass->SetAngleBias(12.5);
  pass->HalfRuleOff();
  pass->RangeCheckOff();
  pass->SetMinimumDifference(0.03125);
  pass->SetFalloffToInverseSquare();
  pass->SetAttenuation(1.75);
  pass->SetLayers(7);
  pass->SetThickness(0.1875);
  pass->SetDownsampling(3);
  pass->SetLayerDownsampling(3);
  pass->SetNoiseSize(9);
  pass->SetIntensity(1.25);
  pass->SetPower(3.125);
  pass->SetIntensityScale(2.375);
  pass->SetIntensityShift(-0.4375);
  pass->SetVolumeOpacityThreshold(0.8125);
  pass->SetDepthFormat(42);
  std::ostringstream printed;
  pass->Print(printed);
  const std::pair<const char*, const char*> lines[] = { { "Radius", "0.515625" },
    { "EffectiveRadius", "0.515625" }, { "Estimator", "" }, { "KernelSize", "77" },
    { "Directions", "11" }, { "Steps", "13" }, { "AngleBias", "12.5" }, { "HalfRule", "off" },
    { "RangeCheck", "off" }, { "MinimumDifference", "0.03125" }, { "Falloff", "2" },
    { "Attenuation", "1.75" }, { "NoiseSize", "9" }, { "Layers", "7" }, { "Thickness", "0.1875" },
    { "Downsampling", "3" }, { "LayerDownsampling", "3" }, { "Bias", "0.0625" }, { "Denoiser", "" },
    { "Modulation", "" }, { "Intensity", "1.25" }, { "Power", "3.125" },
    { "IntensityScale", "2.375" }, { "IntensityShift", "-0.4375" }, { "OutputMode", "" },
    { "DepthFormat", "42" }, { "VolumeOpacityThreshold", "0.8125" }, { "StageTiming", "" } };
  for (const auto& line : lines)
  {
    const std::string wanted = std::string(" ") + line.first + ": " + line.second;
    test.Expect(printed.str().find(wanted) != std::string::npos, "PrintSelf prints" + wanted);
  }
  vtkNew<Pass> standard;
  std::ostringstream defaults;
  standard->Print(defaults);
  test.Expect(defaults.str().find("automatic") != std::string::npos,
    "PrintSelf says that a length is automatic");
}
}

//------------------------------------------------------------------------------
int UnitTestSSAOParameters(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (const Parameter& parameter : Parameters())
  {
    TestParameter(test, parameter);
  }
  TestOthers(test);
  TestPrintSelf(test);
  return test.GetResult();
}
