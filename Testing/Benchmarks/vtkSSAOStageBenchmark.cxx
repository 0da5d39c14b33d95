// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOStageBenchmark.cxx
 * @brief  What each stage of the pass costs, by resolution, radius in pixels and samples.
 *
 * Wall time of a stage, with the graphics finished before and after. Counters: pixels of the
 * viewport, texture fetches per pixel, nanoseconds per pixel. CopyFloor is what any full-screen
 * stage costs at least: one fetch, one write.
 */

#include "vtkSSAOScenes.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <string>

namespace
{
using Pass = vtkScreenSpaceAmbientOcclusionPass;

//------------------------------------------------------------------------------
// One window with one scene, kept from one benchmark to the next.
class Stage
{
public:
  static Stage& Get(int width, int height)
  {
    static Stage stage;
    stage.Window->SetSize(width, height);
    return stage;
  }

  // World radius that covers so many pixels at the focal point.
  double RadiusOf(double pixels)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double height = 2.0 * camera->GetDistance() *
      std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
    return pixels * height / this->Window->GetSize()[1];
  }

  void Render()
  {
    this->Renderer->GetActiveCamera()->Modified();
    this->Occlusion->Modified(); // an unchanged frame would be taken from the last one
    this->Window->Render();
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<Pass> Occlusion;

private:
  Stage()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    vtkSSAOScenes::Build("sphere_pack", 0, this->Renderer, "");
    this->Renderer->SetPass(this->Occlusion);
    this->Occlusion->StageTimingOn();
  }
};

//------------------------------------------------------------------------------
// Times one stage; arguments: width, height, then what configure takes.
void MeasureStage(benchmark::State& state, int stage, double fetches)
{
  Stage& scene = Stage::Get(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  scene.Render();
  for (auto _ : state)
  {
    scene.Render();
    state.SetIterationTime(scene.Occlusion->GetStageTime(stage));
  }
  const double pixels = static_cast<double>(state.range(0) * state.range(1));
  state.counters["pixels"] = pixels;
  state.counters["fetches/px"] = fetches;
  state.counters["ns/px"] = benchmark::Counter(
    pixels * 1.0e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

//------------------------------------------------------------------------------
Pass* Configure(benchmark::State& state, int kernelSize, double radiusInPixels, int denoiser)
{
  Stage& scene = Stage::Get(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  scene.Occlusion->SetEstimatorToHemisphere();
  scene.Occlusion->SetKernelSize(kernelSize);
  scene.Occlusion->SetRadius(scene.RadiusOf(radiusInPixels));
  scene.Occlusion->SetDenoiser(denoiser);
  return scene.Occlusion;
}

//------------------------------------------------------------------------------
void Capture(benchmark::State& state)
{
  Configure(state, 1, 32.0, Pass::None);
  MeasureStage(state, Pass::CaptureStage, 0.0);
}

//------------------------------------------------------------------------------
// Arguments: width, height, samples, radius in pixels. Per sample one depth and one kernel fetch.
void OcclusionHemisphere(benchmark::State& state)
{
  const int kernelSize = static_cast<int>(state.range(2));
  Configure(state, kernelSize, static_cast<double>(state.range(3)), Pass::None);
  MeasureStage(state, Pass::OcclusionStage, 2.0 + 2.0 * kernelSize);
}

//------------------------------------------------------------------------------
void DenoiseBox(benchmark::State& state)
{
  Configure(state, 1, 32.0, Pass::Box);
  MeasureStage(state, Pass::DenoiseStage, 1.0 + 16.0);
}

//------------------------------------------------------------------------------
void DenoiseEdgeAware(benchmark::State& state)
{
  Configure(state, 1, 32.0, Pass::EdgeAware);
  MeasureStage(state, Pass::DenoiseStage, 1.0 + 2.0 * 25.0);
}

//------------------------------------------------------------------------------
void Modulate(benchmark::State& state)
{
  Configure(state, 1, 32.0, Pass::None);
  MeasureStage(state, Pass::ModulateStage, 2.0);
}

//------------------------------------------------------------------------------
// A quad that copies one float texture to another.
void CopyFloor(benchmark::State& state)
{
  const int width = static_cast<int>(state.range(0));
  const int height = static_cast<int>(state.range(1));
  Stage& scene = Stage::Get(width, height);
  scene.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  window->MakeCurrent();
  vtkOpenGLState* gl = window->GetState();

  vtkNew<vtkTextureObject> from;
  vtkNew<vtkTextureObject> to;
  for (vtkTextureObject* texture : { from.Get(), to.Get() })
  {
    texture->SetContext(window);
    texture->Allocate2D(width, height, 1, VTK_FLOAT);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  framebuffer->SetContext(window);
  gl->PushFramebufferBindings();
  framebuffer->Bind();
  framebuffer->AddColorAttachment(0, to);
  framebuffer->ActivateDrawBuffers(1);
  framebuffer->StartNonOrtho(width, height);
  const char* copy = "//VTK::System::Dec\n"
                     "//VTK::Output::Dec\n"
                     "in vec2 texCoord;\n"
                     "uniform sampler2D from;\n"
                     "void main() { gl_FragData[0] = textureLod(from, texCoord, 0.0); }\n";
  auto quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, copy, "");
  from->Activate();
  quad->Program->SetUniformi("from", from->GetTextureUnit());
  quad->Render();
  window->WaitForCompletion();
  for (auto _ : state)
  {
    const auto start = std::chrono::steady_clock::now();
    quad->Render();
    window->WaitForCompletion();
    state.SetIterationTime(
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  const double pixels = static_cast<double>(width) * height;
  state.counters["pixels"] = pixels;
  state.counters["fetches/px"] = 1.0;
  state.counters["ns/px"] = benchmark::Counter(
    pixels * 1.0e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  from->Deactivate();
  framebuffer->RemoveColorAttachment(0);
  gl->PopFramebufferBindings();
  quad.reset();
  framebuffer->ReleaseGraphicsResources(window);
  from->ReleaseGraphicsResources(window);
  to->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void Sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "width", "height" });
  for (const auto& size : { std::pair<int, int>(400, 300), { 800, 600 }, { 1920, 1080 } })
  {
    benchmark->Args({ size.first, size.second });
  }
}

//------------------------------------------------------------------------------
void SizesSamplesRadii(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "width", "height", "samples", "radius_px" });
  for (const auto& size : { std::pair<int, int>(400, 300), { 800, 600 }, { 1920, 1080 } })
  {
    benchmark->Args({ size.first, size.second, 32, 32 });
  }
  for (int samples : { 8, 16, 64, 128, 256 })
  {
    benchmark->Args({ 800, 600, samples, 32 });
  }
  for (int radius : { 4, 16, 64, 128, 256 })
  {
    benchmark->Args({ 800, 600, 32, radius });
  }
}
}

BENCHMARK(CopyFloor)->Apply(Sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(Capture)->Apply(Sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(OcclusionHemisphere)
  ->Apply(SizesSamplesRadii)
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(DenoiseBox)->Apply(Sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(DenoiseEdgeAware)->Apply(Sizes)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(Modulate)->Apply(Sizes)->UseManualTime()->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
