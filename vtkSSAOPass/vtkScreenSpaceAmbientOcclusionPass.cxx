// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScreenSpaceAmbientOcclusionPass.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSSAOCapturePass.h"
#include "vtkSSAODelegateGraft.h"
#include "vtkSSAODenoiseStage.h"
#include "vtkSSAODisplayStage.h"
#include "vtkSSAOLayerStage.h"
#include "vtkSSAOModulateStage.h"
#include "vtkSSAOOcclusionSettings.h"
#include "vtkSSAOOcclusionStage.h"
#include "vtkSSAORenderSteps.h"
#include "vtkSSAOResolveStage.h"
#include "vtkSSAOShaderFunctions.h"
#include "vtkSSAOTileMargin.h"
#include "vtkSSAOView.h"
#include "vtkTextureObject.h"
#include "vtkViewport.h"
#include "vtkWeakPointer.h"
#include "vtkWindow.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkScreenSpaceAmbientOcclusionPass);

namespace
{
//------------------------------------------------------------------------------
// A render pass that calls a function: it takes the place of the opaque pass.
class vtkSSAOOpaqueStep : public vtkRenderPass
{
public:
  static vtkSSAOOpaqueStep* New();
  vtkTypeMacro(vtkSSAOOpaqueStep, vtkRenderPass);
  void Render(const vtkRenderState* s) override { this->NumberOfRenderedProps = this->Step(s); }
  std::function<int(const vtkRenderState*)> Step;

protected:
  vtkSSAOOpaqueStep() = default;
  ~vtkSSAOOpaqueStep() override = default;

private:
  vtkSSAOOpaqueStep(const vtkSSAOOpaqueStep&) = delete;
  void operator=(const vtkSSAOOpaqueStep&) = delete;
};
vtkStandardNewMacro(vtkSSAOOpaqueStep);

//------------------------------------------------------------------------------
// The props that a picker was told to choose from; nullptr for all. VTK has no method for it.
class PickListOf : public vtkViewport
{
public:
  static vtkPropCollection* Get(vtkViewport* viewport)
  {
    return viewport->*(&PickListOf::PickFromProps);
  }
};

//------------------------------------------------------------------------------
// A camera learns whether the window is in stereo when it renders itself, which VTK's pass for
// cameras does not have it do. VTK has no method for it.
class StereoOf : public vtkCamera
{
public:
  static void Set(vtkCamera* camera, int stereo)
  {
    if (camera->GetStereo() != stereo)
    {
      camera->*(&StereoOf::Stereo) = stereo;
      camera->Modified();
    }
  }
};

//------------------------------------------------------------------------------
// Draws what a hardware selector asks for in place of the scene.
class vtkSSAOSelectionStep : public vtkRenderPass
{
public:
  static vtkSSAOSelectionStep* New();
  vtkTypeMacro(vtkSSAOSelectionStep, vtkRenderPass);
  void Render(const vtkRenderState* s) override
  {
    vtkRenderer* renderer = s->GetRenderer();
    std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
    if (vtkPropCollection* pickList = PickListOf::Get(renderer))
    {
      props.clear();
      vtkCollectionSimpleIterator it;
      pickList->InitTraversal(it);
      while (vtkProp* prop = pickList->GetNextProp(it))
      {
        if (prop->GetVisibility())
        {
          props.push_back(prop);
        }
      }
    }
    this->NumberOfRenderedProps =
      renderer->GetSelector()->Render(renderer, props.data(), static_cast<int>(props.size()));
  }

protected:
  vtkSSAOSelectionStep() = default;
  ~vtkSSAOSelectionStep() override = default;

private:
  vtkSSAOSelectionStep(const vtkSSAOSelectionStep&) = delete;
  void operator=(const vtkSSAOSelectionStep&) = delete;
};
vtkStandardNewMacro(vtkSSAOSelectionStep);

//------------------------------------------------------------------------------
// Diagonal of the bounds of the renderer's visible opaque props, 0 if there is nothing. All props
// count, also those outside the view, so that the radius does not change as the camera moves.
double DiagonalOfOpaqueProps(vtkRenderer* renderer)
{
  vtkBoundingBox box;
  vtkCollectionSimpleIterator it;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    const double* bounds =
      prop->GetVisibility() && prop->GetUseBounds() && prop->HasOpaqueGeometry() ? prop->GetBounds()
                                                                                 : nullptr;
    bool finite = bounds && bounds[0] <= bounds[1];
    for (int i = 0; i < 6 && finite; ++i)
    {
      finite = std::isfinite(bounds[i]) && std::abs(bounds[i]) < 1.0e29;
    }
    if (finite)
    {
      box.AddBounds(bounds);
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

//------------------------------------------------------------------------------
// A depth as the textures hold it, counted from the camera on. 0 and no end stay, and so does a
// sign.
float FromCamera(float depth, double origin)
{
  const bool isPlace = depth != 0.0F && std::abs(depth) < 1.0e29F;
  return isPlace ? depth + std::copysign(static_cast<float>(origin), depth) : depth;
}

//------------------------------------------------------------------------------
// Gives the image one float array of the viewport's size; returns where its pixels go.
float* NewPixels(vtkImageData* image, const glm::ivec4& viewport, int components, const char* name)
{
  image->Initialize();
  image->SetDimensions(viewport.z, viewport.w, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  image->GetPointData()->GetScalars()->SetName(name);
  return static_cast<float*>(image->GetScalarPointer());
}

//------------------------------------------------------------------------------
// Directions and steps whose product is nearest to a number of samples, 3 directions for 2 steps as
// far as that allows.
std::array<int, 2> NearestDirectionsAndSteps(int samples)
{
  const double ideal = std::sqrt(samples / 1.5);
  std::array<int, 2> best = { samples, 1 };
  double least = std::numeric_limits<double>::infinity();
  for (int steps = std::max(1, static_cast<int>(ideal / 1.6)); steps <= 1.6 * ideal + 1.0; ++steps)
  {
    const int directions = std::max(1, static_cast<int>(std::lround(double(samples) / steps)));
    // A product that is off by one weighs more than any proportion.
    const double cost =
      std::abs(directions * steps - samples) + 0.1 * std::abs(std::log(directions / (1.5 * steps)));
    if (cost < least)
    {
      least = cost;
      best = { directions, steps };
    }
  }
  return best;
}

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int LargestKernel = 1024;
constexpr int LargestNoise = 64;
constexpr int LargestDirections = 64;
constexpr int LargestDownsampling = 4;
}

//------------------------------------------------------------------------------
// The stages, and what is known of the last render.
class vtkScreenSpaceAmbientOcclusionPass::Pipeline
{
public:
  vtkNew<vtkCameraPass> Camera;
  vtkNew<vtkSSAORenderSteps> Steps;
  vtkNew<vtkLightsPass> Lights;
  vtkNew<vtkOpaquePass> Opaque;
  vtkNew<vtkSSAOOpaqueStep> OpaqueStep;
  vtkNew<vtkSSAOSelectionStep> SelectionStep;

  vtkNew<vtkSSAOCapturePass> Capture;
  vtkSSAOResolveStage Resolve;
  vtkSSAOLayerStage Layers;
  vtkSSAOOcclusionStage Occlusion;
  vtkSSAODenoiseStage Denoise;
  vtkSSAOModulateStage Modulate;
  vtkSSAODisplayStage Display;

  double EffectiveRadius = -1.0;
  vtkTextureObject* Geometry = nullptr;   ///< of this frame, one sample per pixel
  vtkTextureObject* Visibility = nullptr; ///< of this frame, denoised
  bool HasSolids = false;                 ///< whether the layer stage holds this frame's
  int Unestimated = 1; ///< edge of the squares of which Visibility holds one pixel only
  std::unique_ptr<vtkSSAOView> LastView; ///< of this frame, where that is above 1
  glm::ivec4 Viewport = glm::ivec4(0);   ///< of this frame within these textures
  double DepthOrigin = 0.0;              ///< of this frame, see vtkSSAOView
  glm::ivec4 Estimated = glm::ivec4(0);  ///< part of this frame's estimated pixels that was drawn
  bool Reused = false;                   ///< whether this frame's visibility is the last one's
  std::vector<double> Frame;             ///< what the last visibility depends on
  vtkSmartPointer<vtkTextureObject> LastVisibility;
  vtkSmartPointer<vtkTextureObject> VisibilityOfTile; ///< of this frame, if it is a tile
  bool Warned = false;
  bool Failed = false;              ///< whether something could not be built for the window
  vtkWeakPointer<vtkWindow> Window; ///< whose context the textures and programs belong to
  std::array<double, NumberOfStages> Times{};
  std::chrono::steady_clock::time_point StageStart;

  std::array<const vtkSSAOFullScreenStage*, 6> FullScreenStages() const
  {
    return { &this->Resolve, &this->Layers, &this->Occlusion, &this->Denoise, &this->Modulate,
      &this->Display };
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Camera->ReleaseGraphicsResources(window);
    this->Steps->ReleaseGraphicsResources(window);
    this->Opaque->ReleaseGraphicsResources(window);
    this->Capture->ReleaseGraphicsResources(window);
    this->Resolve.ReleaseGraphicsResources(window);
    this->Layers.ReleaseGraphicsResources(window);
    this->Occlusion.ReleaseGraphicsResources(window);
    this->Denoise.ReleaseGraphicsResources(window);
    this->Modulate.ReleaseGraphicsResources(window);
    this->Display.ReleaseGraphicsResources(window);
    this->Geometry = nullptr;
    this->Visibility = nullptr;
    this->Unestimated = 1;
    this->HasSolids = false;
    this->Frame.clear();
    this->VisibilityOfTile = nullptr;
    this->LastVisibility = nullptr;
    this->Failed = false;
  }
};

//------------------------------------------------------------------------------
vtkScreenSpaceAmbientOcclusionPass::vtkScreenSpaceAmbientOcclusionPass()
  : Stages(new Pipeline)
{
  this->SetQualityToBalanced();
}

//------------------------------------------------------------------------------
vtkScreenSpaceAmbientOcclusionPass::~vtkScreenSpaceAmbientOcclusionPass() = default;

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  Pipeline& stages = *this->Stages;
  stages.Geometry = nullptr;
  stages.Visibility = nullptr;
  stages.HasSolids = false;
  stages.Unestimated = 1;
  stages.VisibilityOfTile = nullptr;
  stages.Reused = false;
  stages.Times.fill(0.0);
  this->FollowWindow(s->GetRenderer()->GetVTKWindow());
  if (vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow())
  {
    StereoOf::Set(s->GetRenderer()->GetActiveCamera(), window->GetStereoRender());
  }

  if (s->GetRenderer()->GetSelector())
  {
    stages.Camera->SetDelegatePass(stages.SelectionStep);
    stages.Camera->Render(s);
    this->NumberOfRenderedProps = stages.Camera->GetNumberOfRenderedProps();
    return;
  }
  this->RenderScene(s);
  if (this->OutputMode == Occlusion || this->OutputMode == Normal || this->OutputMode == Depth)
  {
    this->DisplayBuffers(s);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::FollowWindow(vtkWindow* window)
{
  Pipeline& stages = *this->Stages;
  // A window that loses its context tells the passes that are set, but not one that is to be set
  // again.
  if ((stages.Window && stages.Window != window) || stages.Capture->HasLostContext())
  {
    // One that is gone has taken its resources along; VTK 9.6 asserts that there is a window.
    stages.ReleaseGraphicsResources(stages.Window ? stages.Window.Get() : window);
  }
  stages.Window = window;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::RenderScene(const vtkRenderState* s)
{
  Pipeline& stages = *this->Stages;
  vtkRenderPass* root = nullptr;
  vtkSSAODelegateGraft graft(this->DelegatePass, stages.OpaqueStep);
  if (!this->DelegatePass)
  {
    stages.Steps->SetOpaquePass(stages.OpaqueStep);
    stages.Camera->SetDelegatePass(stages.Steps);
    stages.Capture->SetOpaquePass(stages.Opaque);
    root = stages.Camera;
    if (const char* reason = vtkSSAORenderSteps::WhyOtherPass(s))
    {
      this->WarnOnce(reason);
    }
  }
  else
  {
    if (!graft.GetOpaquePass())
    {
      this->WarnOnce("the delegate has no vtkOpaquePass");
    }
    stages.Capture->SetOpaquePass(graft.GetOpaquePass());
    root = graft.GetRoot();
  }
  if (root == stages.OpaqueStep && s->GetRenderer()->GetPass() == this)
  {
    // A bare opaque pass under the renderer: nobody else clears and sets the viewport.
    stages.Camera->SetDelegatePass(stages.OpaqueStep);
    root = stages.Camera;
  }
  stages.OpaqueStep->Step = [this](const vtkRenderState* state)
  { return this->RenderOpaqueWithOcclusion(state); };
  root->Render(s);
  this->NumberOfRenderedProps = root->GetNumberOfRenderedProps();
  stages.OpaqueStep->Step = nullptr;
  stages.Capture->SetOpaquePass(nullptr);
}

//------------------------------------------------------------------------------
int vtkScreenSpaceAmbientOcclusionPass::RenderOpaqueWithOcclusion(const vtkRenderState* s)
{
  Pipeline& stages = *this->Stages;
  // A delegate may lack lights; setting them up twice changes nothing.
  stages.Lights->Render(s);
  vtkSSAOView view(s);
  this->UpdateEffectiveRadius(s->GetRenderer());
  if (!view.IsValid() || !this->NeedsBuffers())
  {
    if (!view.IsValid() && view.Viewport.z > 0 && view.Viewport.w > 0)
    {
      this->WarnOnce(view.WhyInvalid());
    }
    stages.Capture->Render(s);
    return stages.Capture->GetNumberOfRenderedProps();
  }

  stages.StageStart = std::chrono::steady_clock::now();
  if (vtkSSAOTileMargin::IsNeeded(view))
  {
    this->FindVisibilityOfTile(view);
  }
  stages.Capture->Prepare(s, view);
  if (!this->CaptureSurfaces(s, view))
  {
    this->Fail("A shader or framebuffer of the capture");
    stages.Capture->Render(s);
    return stages.Capture->GetNumberOfRenderedProps();
  }
  const bool known = stages.VisibilityOfTile != nullptr;
  stages.Visibility = stages.VisibilityOfTile;
  if (this->Denoiser == None || this->Denoiser == EdgeAware)
  {
    // The others average over the background.
    view.Drawn = stages.Capture->RectangleOnScreen(view);
  }
  stages.Estimated = view.Coarse(vtkSSAOOcclusionSettings::Of(this).Downsampling).Drawn;
  const bool nothingToShade = this->OutputMode == Composite && !stages.Capture->HasSurfaces();
  const bool shaded = nothingToShade ||
    ((known || this->ReuseVisibility(view) ||
       (this->FindLayers(s, view) && this->ComputeOcclusion(view) && this->RemoveNoise(view) &&
         this->KeepVisibility())) &&
      this->ModulateLight(view));
  if (!shaded)
  {
    this->Fail("A shader or framebuffer of the occlusion");
  }
  stages.Capture->RenderRemainder(s);
  return stages.Capture->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::NeedsBuffers() const
{
  return !this->Stages->Failed && this->OutputMode != Unoccluded &&
    (this->OutputMode != Composite || this->Intensity > 0.0);
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::CaptureSurfaces(
  const vtkRenderState* s, const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  glm::vec3 weights(0.0F);
  if (this->OutputMode == Composite)
  {
    weights = this->Modulation == All
      ? glm::vec3(0.0F, 0.0F, 1.0F)
      : glm::vec3(1.0F, this->Modulation == Ambient ? 0.0F : 1.0F, 0.0F);
  }
  stages.Capture->SetOccludableWeights(weights);
  if (!stages.Capture->CanCompile(view, false) || !stages.Capture->Capture(s, view))
  {
    return false;
  }
  stages.Viewport = view.Viewport;
  stages.DepthOrigin = view.DepthOrigin;
  stages.Geometry = stages.Capture->GetGeometry();
  if (view.Samples)
  {
    stages.Geometry =
      stages.Resolve.Render(view, stages.Geometry) ? stages.Resolve.GetOutput() : nullptr;
  }
  this->TimeStage(CaptureStage, view);
  return stages.Geometry != nullptr;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::FindVisibilityOfTile(const vtkSSAOView& tile)
{
  Pipeline& stages = *this->Stages;
  const vtkSSAOOcclusionSettings settings = vtkSSAOOcclusionSettings::Of(this);
  vtkSSAOTileMargin margin(tile, stages.EffectiveRadius,
    std::lcm(settings.Downsampling * this->NoiseSize, settings.LayerDownsampling));
  vtkSSAOView& view = margin.GetView();
  const vtkRenderState* s = margin.GetState();
  stages.Capture->SetOccludableWeights(glm::vec3(0.0F));
  stages.Capture->Prepare(s, view);
  if (!view.IsValid() || !stages.Capture->CanCompile(view, false) ||
    !stages.Capture->Capture(s, view))
  {
    return; // the visibility is found from the tile alone
  }
  stages.Geometry = stages.Capture->GetGeometry();
  if (stages.Capture->HasSurfaces() && this->FindLayers(s, view) && this->ComputeOcclusion(view) &&
    this->RemoveNoise(view))
  {
    stages.VisibilityOfTile = margin.CutTile(stages.Visibility);
  }
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::ReuseVisibility(const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  std::vector<double> frame = stages.Capture->DescribeFrame(view);
  if (!frame.empty())
  {
    frame.push_back(static_cast<double>(this->GetMTime()));
    frame.push_back(stages.EffectiveRadius);
  }
  stages.Reused = !frame.empty() && frame == stages.Frame && stages.LastVisibility;
  if (stages.Reused)
  {
    stages.Visibility = stages.LastVisibility;
    this->PostponeInterpolation(view);
    stages.HasSolids = vtkSSAOOcclusionSettings::Of(this).LooksBehind();
    return true;
  }
  stages.Frame = frame;
  stages.LastVisibility = nullptr;
  return false;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::KeepVisibility()
{
  Pipeline& stages = *this->Stages;
  stages.LastVisibility = stages.Visibility;
  return true;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::FindLayers(
  const vtkRenderState* s, const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  const vtkSSAOOcclusionSettings settings = vtkSSAOOcclusionSettings::Of(this);
  if (!settings.LooksBehind())
  {
    return true;
  }
  vtkSSAOLayerSettings layers;
  layers.Layers = settings.Layers;
  layers.Downsampling = settings.LayerDownsampling;
  layers.Radius = settings.Radius;
  layers.Sheet = settings.Sheet;
  layers.SheetsOnly = settings.SheetsOnly;
  stages.HasSolids = stages.Capture->CanCompile(view, true) &&
    stages.Layers.Render(s, view, stages.Capture, layers, stages.Geometry);
  this->TimeStage(LayersStage, view);
  return stages.HasSolids;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::ComputeOcclusion(const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  const vtkSSAOOcclusionSettings settings = vtkSSAOOcclusionSettings::Of(this);
  if (!stages.Occlusion.Render(view, settings, stages.Geometry, stages.Layers))
  {
    return false;
  }
  stages.Visibility = stages.Occlusion.GetOutput();
  this->TimeStage(OcclusionStage, view);
  return true;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::RemoveNoise(const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  const vtkSSAODenoiseSettings settings = this->DenoiseSettings();
  if (this->Denoiser == None || (this->NoiseSize == 1 && settings.Downsampling == 1))
  {
    return true;
  }
  if (this->PostponeInterpolation(view))
  {
    stages.Visibility =
      stages.Denoise.DenoiseEstimated(view, settings, stages.Geometry, stages.Visibility);
  }
  else
  {
    stages.Visibility = stages.Denoise.Render(view, settings, stages.Geometry, stages.Visibility)
      ? stages.Denoise.GetOutput()
      : nullptr;
  }
  this->TimeStage(DenoiseStage, view);
  return stages.Visibility != nullptr;
}

//------------------------------------------------------------------------------
vtkSSAODenoiseSettings vtkScreenSpaceAmbientOcclusionPass::DenoiseSettings()
{
  vtkSSAODenoiseSettings settings;
  settings.Denoiser = this->Denoiser;
  settings.NoiseSize = this->NoiseSize;
  settings.Downsampling = vtkSSAOOcclusionSettings::Of(this).Downsampling;
  settings.Radius = this->Stages->EffectiveRadius;
  return settings;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::PostponeInterpolation(const vtkSSAOView& view)
{
  // A texture of the interpolated visibility is worth its time only to what looks at it again.
  Pipeline& stages = *this->Stages;
  const int downsampling = this->DenoiseSettings().Downsampling;
  if (downsampling == 1 || this->OutputMode != Composite || view.Samples ||
    vtkSSAOTileMargin::IsNeeded(view))
  {
    return false;
  }
  stages.Unestimated = downsampling;
  stages.LastView = std::make_unique<vtkSSAOView>(view);
  return true;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::InterpolateNow()
{
  Pipeline& stages = *this->Stages;
  const bool isThere = stages.Window && stages.Visibility && stages.Visibility->GetHandle();
  if (stages.Unestimated > 1 && isThere)
  {
    stages.LastView->Window->MakeCurrent();
    // The controls may have changed since.
    vtkSSAODenoiseSettings settings = this->DenoiseSettings();
    settings.Downsampling = stages.Unestimated;
    stages.Visibility =
      stages.Denoise.Interpolate(*stages.LastView, settings, stages.Geometry, stages.Visibility)
      ? stages.Denoise.GetOutput()
      : nullptr;
    stages.Unestimated = 1;
  }
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::ModulateLight(const vtkSSAOView& view)
{
  Pipeline& stages = *this->Stages;
  if (this->OutputMode != Composite)
  {
    return true;
  }
  vtkSSAOStrength strength;
  strength.Power = this->Power;
  strength.Intensity = this->Intensity;
  strength.Scale = this->IntensityScale;
  strength.Shift = this->IntensityShift;
  const bool drawn = stages.Modulate.Render(view, strength, stages.Unestimated, stages.Geometry,
    stages.Visibility, stages.Capture->GetOccludable(), stages.Capture->GetLit());
  this->TimeStage(ModulateStage, view);
  return drawn;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::DisplayBuffers(const vtkRenderState* s)
{
  Pipeline& stages = *this->Stages;
  vtkSSAOView view(s);
  view.CountDepthsFrom(stages.DepthOrigin);
  if (view.IsValid() && stages.Geometry && stages.Visibility &&
    !stages.Display.Render(
      view, this->OutputMode, stages.Viewport, stages.Geometry, stages.Visibility))
  {
    this->Fail("A shader of the output mode");
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::UpdateEffectiveRadius(vtkRenderer* renderer)
{
  this->Stages->EffectiveRadius =
    this->Radius > 0.0 ? this->Radius : 0.1 * DiagonalOfOpaqueProps(renderer);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::WarnOnce(const char* reason)
{
  if (!this->Stages->Warned && this->NeedsBuffers())
  {
    this->Stages->Warned = true;
    vtkWarningMacro("No ambient occlusion: " << reason << ". The scene is drawn without it.");
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::Fail(const char* what)
{
  // Until the resources of the window are released: then it is tried again.
  this->Stages->Failed = true;
  this->Stages->Geometry = nullptr;
  this->Stages->Visibility = nullptr;
  vtkErrorMacro(<< what << " could not be built; the scene is drawn without occlusion.");
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::TimeStage(int stage, const vtkSSAOView& view)
{
  if (this->StageTiming)
  {
    view.Window->WaitForCompletion();
    const auto now = std::chrono::steady_clock::now();
    this->Stages->Times[stage] =
      std::chrono::duration<double>(now - this->Stages->StageStart).count();
    this->Stages->StageStart = now;
  }
}

//------------------------------------------------------------------------------
double vtkScreenSpaceAmbientOcclusionPass::GetStageTime(int stage) const
{
  return stage >= 0 && stage < NumberOfStages ? this->Stages->Times[stage] : 0.0;
}

//------------------------------------------------------------------------------
unsigned long vtkScreenSpaceAmbientOcclusionPass::GetTextureMemory() const
{
  const Pipeline& stages = *this->Stages;
  unsigned long bytes = stages.Capture->GetTextureMemory();
  for (const vtkSSAOFullScreenStage* stage : stages.FullScreenStages())
  {
    bytes += stage->GetTextureMemory();
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkScreenSpaceAmbientOcclusionPass::GetNumberOfProgramBuilds() const
{
  int builds = 0;
  for (const vtkSSAOFullScreenStage* stage : this->Stages->FullScreenStages())
  {
    builds += stage->GetNumberOfProgramBuilds();
  }
  return builds;
}

//------------------------------------------------------------------------------
int vtkScreenSpaceAmbientOcclusionPass::GetNumberOfEstimatedPixels() const
{
  return this->Stages->Visibility && !this->Stages->Reused
    ? this->Stages->Estimated.z * this->Stages->Estimated.w
    : 0;
}

//------------------------------------------------------------------------------
int vtkScreenSpaceAmbientOcclusionPass::GetNumberOfSampledPixels() const
{
  const Pipeline& stages = *this->Stages;
  if (this->GetNumberOfEstimatedPixels() == 0)
  {
    return 0;
  }
  const std::vector<float> values =
    vtkSSAOFullScreenStage::Download(stages.Occlusion.GetOutput(), stages.Estimated);
  int pixels = 0;
  for (std::size_t i = 3; i < values.size(); i += 4)
  {
    pixels += values[i] > 0.5F ? 1 : 0;
  }
  return pixels;
}

//------------------------------------------------------------------------------
int vtkScreenSpaceAmbientOcclusionPass::GetNumberOfLayerDrawings() const
{
  return this->Stages->HasSolids && !this->Stages->Reused ? this->Stages->Layers.GetNumberOfRounds()
                                                          : 0;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::GetVisibility(vtkImageData* image)
{
  this->InterpolateNow();
  const glm::ivec4 viewport = this->Stages->Viewport;
  vtkTextureObject* visibility = this->Stages->Visibility;
  const std::vector<float> values = vtkSSAOFullScreenStage::Download(visibility, viewport);
  if (!visibility || values.empty())
  {
    return false;
  }
  // Where there is no surface nothing may have been drawn.
  const std::vector<float> geometry =
    vtkSSAOFullScreenStage::Download(this->Stages->Geometry, viewport);
  float* pixel = NewPixels(image, viewport, 1, "Visibility");
  const std::size_t components = visibility->GetComponents();
  for (std::size_t i = 0; i < geometry.size() / 4; ++i)
  {
    pixel[i] = geometry[4 * i] > 0.0F ? values[i * components] : 1.0F;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::GetGeometry(vtkImageData* image)
{
  const glm::ivec4 viewport = this->Stages->Viewport;
  const double origin = this->Stages->DepthOrigin;
  const std::vector<float> values =
    vtkSSAOFullScreenStage::Download(this->Stages->Geometry, viewport);
  if (values.empty())
  {
    return false;
  }
  float* pixel = NewPixels(image, viewport, 8, "Geometry");
  for (std::size_t i = 0; i < values.size(); i += 4, pixel += 8)
  {
    const bool surface = values[i] > 0.0F;
    const glm::vec3 normal = surface ? shader::ssaoUnpackNormal(values[i + 1]) : glm::vec3(0.0F);
    const glm::vec3 facet = surface ? shader::ssaoUnpackFacet(values[i + 2]) : glm::vec3(0.0F);
    pixel[0] = surface ? FromCamera(values[i], origin) : 0.0F;
    std::copy(&normal[0], &normal[0] + 3, pixel + 1);
    std::copy(&facet[0], &facet[0] + 3, pixel + 4);
    pixel[7] = surface ? shader::ssaoUnpackFacing(values[i + 2]) : 0.0F;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkScreenSpaceAmbientOcclusionPass::GetSolids(vtkImageData* image)
{
  const Pipeline& stages = *this->Stages;
  const glm::ivec4 viewport = stages.Layers.GetViewport();
  const std::vector<float> first = vtkSSAOFullScreenStage::Download(
    stages.HasSolids ? stages.Layers.GetSolids() : nullptr, viewport);
  const std::vector<float> second = vtkSSAOFullScreenStage::Download(
    stages.HasSolids ? stages.Layers.GetMoreSolids() : nullptr, viewport);
  if (first.empty() || second.empty())
  {
    return false;
  }
  float* pixel = NewPixels(image, viewport, 8, "Solids");
  for (std::size_t i = 0; i < first.size(); i += 4, pixel += 8)
  {
    for (int j = 0; j < 4; ++j)
    {
      pixel[j] = FromCamera(first[i + j], stages.DepthOrigin);
      pixel[4 + j] = FromCamera(second[i + j], stages.DepthOrigin);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Superclass::ReleaseGraphicsResources(w);
  this->Stages->ReleaseGraphicsResources(w);
}

//------------------------------------------------------------------------------
double vtkScreenSpaceAmbientOcclusionPass::GetEffectiveRadius() const
{
  return this->Stages->EffectiveRadius < 0.0 ? this->Radius : this->Stages->EffectiveRadius;
}

//------------------------------------------------------------------------------
double vtkScreenSpaceAmbientOcclusionPass::GetEffectiveBias() const
{
  const double automatic = this->Estimator == Hemisphere ? 0.05 * this->GetEffectiveRadius() : 0.0;
  return this->Bias < 0.0 ? automatic : this->Bias;
}

//------------------------------------------------------------------------------
template <typename Value>
void vtkScreenSpaceAmbientOcclusionPass::SetInRange(
  const char* name, Value& variable, double value, double low, double high)
{
  if (!std::isfinite(value) || value < low || value > high)
  {
    std::ostringstream range;
    range.precision(10);
    range << value << " is refused: it must be ";
    if (high < Infinity)
    {
      range << "from " << low << " to " << high;
    }
    else
    {
      range << "finite and at least " << low;
    }
    vtkErrorMacro(<< name << " " << range.str() << ". It stays " << variable << ".");
    return;
  }
  if (variable != static_cast<Value>(value))
  {
    variable = static_cast<Value>(value);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetRadius(double radius)
{
  this->SetInRange("Radius", this->Radius, radius, 0.0, Infinity);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetQuality(
  int estimator, int directions, int steps, int downsampling, int layerDownsampling)
{
  this->SetEstimator(estimator);
  this->SetDirections(directions);
  this->SetSteps(steps);
  this->SetLayers(5);
  this->SetThickness(0.0);
  this->SetNoiseSize(4);
  this->SetDownsampling(downsampling);
  this->SetLayerDownsampling(layerDownsampling);
  this->SetDenoiserToEdgeAware();
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetQualityToFast()
{
  this->SetQuality(ExactHorizon, 1, 8, 2, 2);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetQualityToBalanced()
{
  this->SetQuality(LayeredBitmask, 1, 10, 2, 4);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetQualityToAccurate()
{
  this->SetQuality(LayeredBitmask, 1, 14, 1, 2);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetEstimator(int estimator)
{
  const int before = this->Estimator;
  this->SetInRange("Estimator", this->Estimator, estimator, CrytekSphere, LayeredBitmask);
  if (this->Estimator != before && this->Estimator <= HorizonAngle)
  {
    // What the sources have, not what a preset of ours left.
    this->SetNoiseSize(4);
    this->SetDownsampling(1);
    this->SetDirections(6);
    this->SetSteps(4);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetKernelSize(int size)
{
  this->SetInRange("KernelSize", this->KernelSize, size, 1, LargestKernel);
  if (this->Estimator >= HorizonAngle && this->KernelSize == size)
  {
    const std::array<int, 2> factors = NearestDirectionsAndSteps(size);
    this->SetDirections(factors[0]);
    this->SetSteps(factors[1]);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetDirections(int directions)
{
  this->SetInRange("Directions", this->Directions, directions, 1, LargestDirections);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetSteps(int steps)
{
  this->SetInRange("Steps", this->Steps, steps, 1, LargestDirections);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetAngleBias(double degrees)
{
  this->SetInRange("AngleBias", this->AngleBias, degrees, 0.0, 89.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetLayers(int layers)
{
  this->SetInRange("Layers", this->Layers, layers, 1, vtkSSAOLayerStage::MostLayers);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetThickness(double thickness)
{
  this->SetInRange("Thickness", this->Thickness, thickness, 0.0, Infinity);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetMinimumDifference(double share)
{
  this->SetInRange("MinimumDifference", this->MinimumDifference, share, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetFalloff(int falloff)
{
  this->SetInRange("Falloff", this->Falloff, falloff, PowerFalloff, InverseSquareFalloff);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetAttenuation(double attenuation)
{
  this->SetInRange("Attenuation", this->Attenuation, attenuation, 0.01, 100.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetNoiseSize(int size)
{
  this->SetInRange("NoiseSize", this->NoiseSize, size, 1, LargestNoise);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetDownsampling(int edge)
{
  this->SetInRange("Downsampling", this->Downsampling, edge, 1, LargestDownsampling);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetLayerDownsampling(int edge)
{
  this->SetInRange("LayerDownsampling", this->LayerDownsampling, edge, 1, LargestDownsampling);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetBias(double bias)
{
  this->SetInRange("Bias", this->Bias, bias, 0.0, Infinity);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetBiasToAutomatic()
{
  this->SetInRange("Bias", this->Bias, -1.0, -1.0, -1.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetDenoiser(int denoiser)
{
  this->SetInRange("Denoiser", this->Denoiser, denoiser, None, EdgeAware);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetBlur(bool blur)
{
  if (blur != this->GetBlur())
  {
    this->SetDenoiser(blur ? EdgeAware : None);
  }
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetModulation(int modulation)
{
  this->SetInRange("Modulation", this->Modulation, modulation, Ambient, All);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetIntensity(double intensity)
{
  this->SetInRange("Intensity", this->Intensity, intensity, 0.0, 10.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetPower(double power)
{
  this->SetInRange("Power", this->Power, power, 0.01, 16.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetIntensityScale(double scale)
{
  this->SetInRange("IntensityScale", this->IntensityScale, scale, 0.0, 10.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetIntensityShift(double shift)
{
  this->SetInRange("IntensityShift", this->IntensityShift, shift, -1.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetOutputMode(int mode)
{
  this->SetInRange("OutputMode", this->OutputMode, mode, Composite, Depth);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::SetVolumeOpacityThreshold(double threshold)
{
  this->SetInRange("VolumeOpacityThreshold", this->VolumeOpacityThreshold, threshold, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkScreenSpaceAmbientOcclusionPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << (this->Radius > 0.0 ? "" : " (automatic)") << "\n";
  os << indent << "EffectiveRadius: " << this->GetEffectiveRadius() << "\n";
  os << indent << "Estimator: " << this->Estimator << "\n";
  os << indent << "KernelSize: " << this->KernelSize << "\n";
  os << indent << "Directions: " << this->Directions << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "AngleBias: " << this->AngleBias << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Thickness: " << this->Thickness
     << (this->Thickness > 0.0 ? "" : " (from the layers)") << "\n";
  os << indent << "HalfRule: " << (this->HalfRule ? "on" : "off") << "\n";
  os << indent << "RangeCheck: " << (this->RangeCheck ? "on" : "off") << "\n";
  os << indent << "MinimumDifference: " << this->MinimumDifference << "\n";
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "Attenuation: " << this->Attenuation << "\n";
  os << indent << "NoiseSize: " << this->NoiseSize << "\n";
  os << indent << "Downsampling: " << this->Downsampling << "\n";
  os << indent << "LayerDownsampling: " << this->LayerDownsampling << "\n";
  os << indent << "Bias: " << this->Bias << (this->Bias < 0.0 ? " (automatic)" : "") << "\n";
  os << indent << "EffectiveBias: " << this->GetEffectiveBias() << "\n";
  os << indent << "Denoiser: " << this->Denoiser << "\n";
  os << indent << "Modulation: " << this->Modulation << "\n";
  os << indent << "Intensity: " << this->Intensity << "\n";
  os << indent << "Power: " << this->Power << "\n";
  os << indent << "IntensityScale: " << this->IntensityScale << "\n";
  os << indent << "IntensityShift: " << this->IntensityShift << "\n";
  os << indent << "OutputMode: " << this->OutputMode << "\n";
  os << indent << "DepthFormat: " << this->DepthFormat << "\n";
  os << indent << "StageTiming: " << (this->StageTiming ? "on" : "off") << "\n";
  os << indent << "VolumeOpacityThreshold: " << this->VolumeOpacityThreshold << "\n";
}
