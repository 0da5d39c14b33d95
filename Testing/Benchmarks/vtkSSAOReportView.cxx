// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportView.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageError.h"
#include "vtkSSAOOcclusionSettings.h"
#include "vtkSSAOScenes.h"
#include "vtkSSAOTruthCache.h"
#include "vtkSSAOTruthCamera.h"
#include "vtkSSAOTruthScene.h"
#include "vtkSSAOTruthTracer.h"
#include "vtkSSAOTwin.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace
{
using OurPass = vtkScreenSpaceAmbientOcclusionPass;
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

//------------------------------------------------------------------------------
// Value at a share of the sorted values, linearly interpolated. share in [0, 1].
double Quantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return NotMeasured;
  }
  std::sort(values.begin(), values.end());
  const double position = share * (values.size() - 1);
  const auto low = static_cast<std::size_t>(position);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (position - low) * (values[high] - values[low]);
}

//------------------------------------------------------------------------------
std::vector<float> Values(vtkImageData* image)
{
  const auto* first = static_cast<const float*>(image->GetScalarPointer());
  return std::vector<float>(first, first + image->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
// Mean over the pixels of the mask.
double Mean(const std::vector<float>& values, const std::vector<unsigned char>& mask)
{
  double sum = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sum += mask[i] ? values[i] : 0.0;
    pixels += mask[i] ? 1 : 0;
  }
  return pixels ? sum / pixels : 1.0;
}

//------------------------------------------------------------------------------
// Root mean square of the difference over the pixels of the mask.
template <typename A, typename B>
double RootMeanSquare(
  const std::vector<A>& a, const std::vector<B>& b, const std::vector<unsigned char>& mask)
{
  double sum = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    if (mask[i])
    {
      const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
      sum += difference * difference;
      ++pixels;
    }
  }
  return pixels ? std::sqrt(sum / pixels) : 0.0;
}
}

//------------------------------------------------------------------------------
struct vtkSSAOReportView::Trial
{
  const vtkSSAOReportMethod* Method = nullptr;
  vtkSmartPointer<vtkImageProcessingPass> Pass;
  std::vector<double> PlainTimes;
  std::vector<double> Costs;
  std::array<std::vector<double>, OurPass::NumberOfStages> StageTimes;
  std::vector<float> Visibility;
  double TextureBytes = NotMeasured;
  double ArithmeticError = NotMeasured;
  double TwinError = NotMeasured;
};

//------------------------------------------------------------------------------
vtkSSAOReportView::vtkSSAOReportView(const std::string& scene, int view, const Settings& settings)
  : Scene(scene)
  , View(view)
  , Options(settings)
{
}

//------------------------------------------------------------------------------
vtkSSAOReportView::~vtkSSAOReportView() = default;

//------------------------------------------------------------------------------
bool vtkSSAOReportView::Prepare(std::string& error)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(this->Options.Width, this->Options.Height);
  this->Window->AddRenderer(this->Renderer);
  if (!vtkSSAOScenes::Build(
        this->Scene, this->View, this->Renderer, this->Options.DataDirectory, &error))
  {
    return false;
  }
  this->Radius = vtkSSAOScenes::GetInfo(this->Scene).Radius;
  this->Renderer->ResetCameraClippingRange();

  vtkSSAOTruthScene scene;
  scene.Gather(this->Renderer);
  if (!scene.GetSkipped().empty())
  {
    error = "no ray-traced truth for props drawn by " + scene.GetSkipped().front();
    return false;
  }
  const vtkSSAOTruthCamera camera(this->Renderer->GetActiveCamera(), this->Options.Width,
    this->Options.Height, scene.GetOrigin());
  vtkSSAOTruthTracer tracer;
  tracer.SetRadius(this->Radius);
  tracer.SetRaysPerPixel(this->Options.RaysPerPixel);
  vtkSSAOTruthCache cache(this->Options.CacheDirectory);
  if (!cache.GetImage(scene, camera, tracer, this->Truth))
  {
    error = "the truth could not be traced";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkSSAOReportView::TimeFrame()
{
  // The camera counts as moved, so that no method may keep what it has.
  this->Renderer->GetActiveCamera()->Modified();
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
void vtkSSAOReportView::MeasureCosts(std::vector<Trial>& trials)
{
  // The first frame after a change of pass may build shaders and textures; it is not timed. A plain
  // frame serves the methods that are drawn right after it.
  const std::size_t methodsPerPlainFrame = 3;
  for (int round = 0; round < this->Options.Rounds; ++round)
  {
    double plain = NotMeasured;
    for (std::size_t i = 0; i < trials.size(); ++i)
    {
      if (i % methodsPerPlainFrame == 0)
      {
        this->Renderer->SetPass(nullptr);
        this->TimeFrame();
        plain = this->TimeFrame();
      }
      Trial& trial = trials[i];
      this->Renderer->SetPass(trial.Pass);
      this->TimeFrame();

      // The times of the stages come from the same frame. That they wait for the card costs less
      // than frames vary, and whatever it costs is counted against us.
      auto* ours = OurPass::SafeDownCast(trial.Pass);
      if (ours)
      {
        ours->StageTimingOn();
      }
      // Otherwise an unchanged frame would be taken from the last one.
      trial.Pass->Modified();
      const double with = this->TimeFrame();
      for (int stage = 0; ours && stage < OurPass::NumberOfStages; ++stage)
      {
        trial.StageTimes[stage].push_back(ours->GetStageTime(stage));
      }
      if (ours)
      {
        ours->StageTimingOff();
      }
      trial.PlainTimes.push_back(plain);
      trial.Costs.push_back(with - plain);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOReportView::MeasureOurs(std::vector<Trial>& trials, std::string& error)
{
  std::unique_ptr<vtkSSAOTwin> twin; // One for all: what is captured depends on no control.
  for (Trial& trial : trials)
  {
    auto* pass = OurPass::SafeDownCast(trial.Pass);
    if (!pass)
    {
      continue;
    }
    this->Renderer->SetPass(pass);
    this->TimeFrame();
    trial.TextureBytes = static_cast<double>(pass->GetTextureMemory());

    vtkNew<vtkImageData> visibility;
    bool made = pass->GetVisibility(visibility);
    if (made && !twin)
    {
      vtkNew<vtkImageData> geometry;
      made = pass->GetGeometry(geometry);
      if (made)
      {
        twin.reset(new vtkSSAOTwin(geometry, this->Renderer->GetActiveCamera()));
      }
    }
    vtkNew<vtkImageData> raw;
    const int denoiser = pass->GetDenoiser();
    pass->SetDenoiserToNone();
    this->TimeFrame();
    made = made && pass->GetVisibility(raw);
    pass->SetDenoiser(denoiser);
    if (!made)
    {
      error = trial.Method->Name + " made no visibility";
      return false;
    }
    vtkNew<vtkImageData> solids;
    if (pass->GetSolids(solids))
    {
      twin->SetSolids(solids);
    }
    trial.Visibility = Values(visibility);
    this->MeasureArithmetic(trial, *twin, Values(raw));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSSAOReportView::MeasureArithmetic(
  Trial& trial, const vtkSSAOTwin& twin, const std::vector<float>& raw)
{
  const std::vector<double> exact =
    twin.Visibility(vtkSSAOOcclusionSettings::Of(OurPass::SafeDownCast(trial.Pass)));
  if (exact.empty())
  {
    return; // an estimator without a twin
  }
  // Over all pixels: the error is that of a few, where rounding decides a comparison.
  trial.ArithmeticError = RootMeanSquare(raw, exact, this->Truth.Hit);
  trial.TwinError = RootMeanSquare(exact, this->Truth.Visibility, this->Truth.Hit);
}

//------------------------------------------------------------------------------
void vtkSSAOReportView::ShowVisibilityAsColor()
{
  // VTK's pass multiplies the finished colour, so a white scene without shading shows V itself.
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    actor->GetMapper()->ScalarVisibilityOff();
    actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    actor->GetProperty()->SetAmbient(1.0);
    actor->GetProperty()->SetDiffuse(0.0);
    actor->GetProperty()->SetSpecular(0.0);
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOReportView::MeasureVTK(Trial& trial)
{
  this->Renderer->SetPass(trial.Pass);
  this->TimeFrame();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(
    0, 0, this->Options.Width - 1, this->Options.Height - 1, /*front=*/0, pixels);
  trial.Visibility.resize(this->Truth.Visibility.size());
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(trial.Visibility.size()))
  {
    return false;
  }
  for (std::size_t i = 0; i < trial.Visibility.size(); ++i)
  {
    trial.Visibility[i] = pixels->GetValue(static_cast<vtkIdType>(i) * 3) / 255.0F;
  }
  // Its textures in VTK 9.1: RGBA32F colour, RGB16F position with mipmaps and RGB16F normals, R8
  // visibility, 32-bit depth.
  trial.TextureBytes =
    (16.0 + 6.0 * 4.0 / 3.0 + 6.0 + 1.0 + 4.0) * this->Options.Width * this->Options.Height;
  return true;
}

//------------------------------------------------------------------------------
void vtkSSAOReportView::FillErrors(const Trial& trial, vtkSSAOReportRow& row) const
{
  vtkSSAOImageError error;
  error.Compare(trial.Visibility, this->Truth);
  row.RootMeanSquare = error.GetRootMeanSquare();
  row.Bias = error.GetBias();
  row.Percentile99 = error.GetPercentile99();
  row.Maximum = error.GetMaximum();
  row.StructuralSimilarity = error.GetStructuralSimilarity();
  row.TruthMean = Mean(this->Truth.Visibility, this->Truth.Hit);
  row.TruthStandardError = RootMeanSquare(
    this->Truth.StandardError, std::vector<float>(this->Truth.Hit.size(), 0.0F), this->Truth.Hit);
}

//------------------------------------------------------------------------------
bool vtkSSAOReportView::Measure(const std::vector<vtkSSAOReportMethod>& methods,
  std::vector<vtkSSAOReportRow>& rows, std::string& error)
{
  std::vector<Trial> trials;
  for (const vtkSSAOReportMethod& method : methods)
  {
    trials.emplace_back();
    trials.back().Method = &method;
    trials.back().Pass = method.NewPass(this->Radius);
  }
  this->MeasureCosts(trials);
  if (!this->MeasureOurs(trials, error))
  {
    return false;
  }
  this->ShowVisibilityAsColor();
  for (Trial& trial : trials)
  {
    if (trial.Method->IsVTK && !this->MeasureVTK(trial))
    {
      error = trial.Method->Name + " made no picture";
      return false;
    }
  }
  this->Renderer->SetPass(nullptr);

  const auto costOf = [&trials](const std::string& name)
  {
    for (const Trial& trial : trials)
    {
      if (trial.Method->Name == name)
      {
        return Quantile(trial.Costs, 0.5);
      }
    }
    return NotMeasured;
  };
  const double vtk32 = costOf("VTK K=32");
  const double vtk64 = costOf("VTK K=64");
  const double vtk256 = costOf("VTK K=256");

  for (const Trial& trial : trials)
  {
    vtkSSAOReportRow row;
    row.Scene = this->Scene;
    row.Kind = vtkSSAOScenes::KindName(vtkSSAOScenes::GetInfo(this->Scene).SceneKind);
    row.View = this->View;
    row.Width = this->Options.Width;
    row.Height = this->Options.Height;
    row.Radius = this->Radius;
    row.Method = trial.Method->Name;
    row.Family = trial.Method->Family;
    row.Samples = trial.Method->Samples;
    this->FillErrors(trial, row);
    row.PlainTime = Quantile(trial.PlainTimes, 0.5);
    row.Cost = Quantile(trial.Costs, 0.5);
    row.CostSpread = 0.5 * (Quantile(trial.Costs, 0.75) - Quantile(trial.Costs, 0.25));
    row.RatioToVTK32 = row.Cost / vtk32;
    row.RatioToVTK64 = row.Cost / vtk64;
    row.RatioToVTK256 = row.Cost / vtk256;
    for (int stage = 0; stage < OurPass::NumberOfStages; ++stage)
    {
      row.StageTimes[stage] = Quantile(trial.StageTimes[stage], 0.5);
    }
    row.TextureBytes = trial.TextureBytes;
    row.ArithmeticError = trial.ArithmeticError;
    row.TwinError = trial.TwinError;
    rows.push_back(row);
    this->Pictures.emplace_back(row.Method, trial.Visibility);
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<float> vtkSSAOReportView::GetVisibility(const std::string& method) const
{
  for (const auto& picture : this->Pictures)
  {
    if (picture.first == method)
    {
      return picture.second;
    }
  }
  return {};
}
