// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScreenSpaceAmbientOcclusionPass
 * @brief   Darkens ambient light where nearby geometry blocks it, and nothing else.
 *
 * The pass draws the opaque props of a renderer, captures their view-space depth and normals on the
 * way, estimates from them the ambient visibility V of every pixel (1: open, 0: closed), removes
 * the noise without crossing edges, and takes the hidden part of the ambient light out of the
 * picture. Background, lines, unlit props, translucent props, volumes and overlays stay as they
 * are: everything that is not opaque is drawn after the occlusion was applied.
 *
 * The scene is drawn straight into the renderer's own framebuffer, to which the capture textures
 * are attached while the opaque props are drawn. So clearing, gradient backgrounds, layers,
 * antialiasing and the depth buffer stay VTK's own.
 *
 * Use it with vtkRenderer::SetPass. A delegate is optional: without one the pass draws the scene
 * as the renderer itself would, with the renderer's flags (depth peeling, order-independent
 * translucency, FXAA, hidden line removal). With one, the opaque pass inside it
 * (vtkRenderStepsPass, vtkCameraPass, vtkSequencePass, vtkOpaquePass, vtkDefaultPass or an image
 * processing pass over one of them) is wrapped while it renders.
 *
 * All lengths are world units. Radius 0 is automatic.
 *
 * @sa vtkSSAOPass vtkRenderStepsPass vtkOpaquePass
 */

#ifndef vtkScreenSpaceAmbientOcclusionPass_h
#define vtkScreenSpaceAmbientOcclusionPass_h

#include "vtkImageProcessingPass.h"
#include "vtkSSAOPassModule.h" // For export macro

#include <memory> // For std::unique_ptr

class vtkImageData;
class vtkRenderer;
class vtkSSAOView;

class VTKSSAOPASS_EXPORT vtkScreenSpaceAmbientOcclusionPass : public vtkImageProcessingPass
{
public:
  static vtkScreenSpaceAmbientOcclusionPass* New();
  vtkTypeMacro(vtkScreenSpaceAmbientOcclusionPass, vtkImageProcessingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How ambient visibility is estimated from the captured buffers.
  enum EstimatorType
  {
    Hemisphere = 3
  };

  /// How the noise of the estimate is removed.
  enum DenoiserType
  {
    None = 0,
    Box = 1,
    EdgeAware = 4
  };

  /// Which part of the light is ambient, so that occlusion may take it away.
  enum ModulationType
  {
    Ambient = 0,
    AmbientAndDiffuse = 1,
    All = 2
  };

  /// What the pass shows.
  enum OutputModeType
  {
    Composite = 0,
    Occlusion = 1,
    Unoccluded = 2,
    Normal = 3,
    Depth = 4
  };

  ///@{
  /**
   * Distance within which geometry occludes, in world units. Range [0, inf); 0, the default, is
   * automatic: a tenth of the diagonal of the bounds of the renderer's visible opaque props.
   * A negative, infinite or NaN value is refused with an error.
   */
  void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

  /**
   * The radius used by the last render, in world units. Before any render: Radius.
   */
  double GetEffectiveRadius() const;

  ///@{
  /**
   * Choose all of estimator, KernelSize and denoiser together. Balanced is the default. Each
   * control may be changed afterwards.
   */
  void SetQualityToFast();
  void SetQualityToBalanced();
  void SetQualityToAccurate();
  ///@}

  ///@{
  /**
   * The estimator of ambient visibility. Hemisphere (default): the normal-oriented hemisphere of
   * Chapman ("SSAO Tutorial", 2013) and LearnOpenGL: KernelSize points in the hemisphere above the
   * surface, turned per pixel by a tile of NoiseSize x NoiseSize rotations, count as hidden when
   * the captured surface lies in front of them by more than Bias and within about Radius.
   * An unknown value is refused with an error.
   */
  void SetEstimator(int estimator);
  vtkGetMacro(Estimator, int);
  void SetEstimatorToHemisphere() { this->SetEstimator(Hemisphere); }
  ///@}

  ///@{
  /**
   * Number of sample points per pixel. Range [1, 1024], default 32. A value out of range is
   * refused with an error.
   */
  void SetKernelSize(int size);
  vtkGetMacro(KernelSize, int);
  ///@}

  ///@{
  /**
   * Edge length of the tile of random rotations, in pixels. Range [1, 64], default 4; 1 uses one
   * rotation for all pixels, which shows as banding. The denoisers span one tile.
   * A value out of range is refused with an error.
   */
  void SetNoiseSize(int size);
  vtkGetMacro(NoiseSize, int);
  ///@}

  ///@{
  /**
   * How far the captured surface must lie in front of a sample point to hide it, in world units.
   * Automatic by default: 0.05 x the effective radius; GetBias() is then -1. Range of SetBias:
   * [0, inf). The depth that the surface itself gains within half a pixel is always added, so that
   * a grazing plane does not hide itself. A negative, infinite or NaN value is refused with an
   * error.
   */
  void SetBias(double bias);
  void SetBiasToAutomatic();
  vtkGetMacro(Bias, double);
  ///@}

  ///@{
  /**
   * How the noise of the estimator is removed. None: not at all. Box: the mean over one noise tile
   * (4x4 pixels at -2..1 for the default NoiseSize), as in the tutorials; leaks over edges.
   * EdgeAware (default): the mean over one noise tile of the pixels on the same surface, by
   * distance from the tangent plane and by normal. An unknown value is refused with an error.
   */
  void SetDenoiser(int denoiser);
  vtkGetMacro(Denoiser, int);
  void SetDenoiserToNone() { this->SetDenoiser(None); }
  void SetDenoiserToBox() { this->SetDenoiser(Box); }
  void SetDenoiserToEdgeAware() { this->SetDenoiser(EdgeAware); }
  ///@}

  ///@{
  /**
   * Denoiser on or off, by the name that vtkSSAOPass uses: on sets EdgeAware unless a denoiser is
   * set already, off sets None.
   */
  void SetBlur(bool blur);
  bool GetBlur() const { return this->Denoiser != None; }
  void BlurOn() { this->SetBlur(true); }
  void BlurOff() { this->SetBlur(false); }
  ///@}

  ///@{
  /**
   * The light that occlusion takes away. With C the colour of a pixel and V its visibility, the
   * picture is C - (1 - V) x O, per colour channel, before clamping, textures included.
   * Ambient: O is the ambient term of the material (image-based light for PBR).
   * AmbientAndDiffuse (default): O is the ambient and the diffuse term (for PBR the direct Lambert
   * term), because VTK's default material has ambient 0. All: O is C, as in vtkSSAOPass.
   * PBR is computed in linear light. An unknown value is refused with an error.
   */
  void SetModulation(int modulation);
  vtkGetMacro(Modulation, int);
  void SetModulationToAmbient() { this->SetModulation(Ambient); }
  void SetModulationToAmbientAndDiffuse() { this->SetModulation(AmbientAndDiffuse); }
  void SetModulationToAll() { this->SetModulation(All); }
  ///@}

  ///@{
  /**
   * Strength of the effect: V becomes 1 - Intensity x (1 - V^Power), clamped to [0, 1].
   * Range [0, 10], default 1; at 0 the picture is the one without the pass and no occlusion is
   * computed. A value out of range is refused with an error.
   */
  void SetIntensity(double intensity);
  vtkGetMacro(Intensity, double);
  ///@}

  ///@{
  /**
   * Exponent of V, for contrast. Range [0.01, 16], default 1 (V as measured).
   * A value out of range is refused with an error.
   */
  void SetPower(double power);
  vtkGetMacro(Power, double);
  ///@}

  ///@{
  /**
   * The two controls that vtkSSAOPass has for strength: V becomes
   * clamp(IntensityScale x (1 - V) + IntensityShift) taken from 1.
   * IntensityScale: range [0, 10], default 1. IntensityShift: range [-1, 1], default 0.
   * Applied before Intensity. A value out of range is refused with an error.
   */
  void SetIntensityScale(double scale);
  vtkGetMacro(IntensityScale, double);
  void SetIntensityShift(double shift);
  vtkGetMacro(IntensityShift, double);
  ///@}

  ///@{
  /**
   * What is shown. Composite (default): the picture with occlusion. Occlusion: V as grey, after
   * denoising, before Power and Intensity, linear: 1 open, 0 closed; 1 wherever no lit opaque
   * surface is seen. Unoccluded: the picture without occlusion. Normal: view-space normals as
   * 0.5 N + 0.5, black where there is none. Depth: linear view depth as grey, 0 at the near and 1
   * at the far end of the camera's clipping range, 1 where no lit opaque surface is seen.
   * In Occlusion, Normal and Depth nothing else is drawn over the viewport.
   * An unknown value is refused with an error.
   */
  void SetOutputMode(int mode);
  vtkGetMacro(OutputMode, int);
  void SetOutputModeToComposite() { this->SetOutputMode(Composite); }
  void SetOutputModeToOcclusion() { this->SetOutputMode(Occlusion); }
  void SetOutputModeToUnoccluded() { this->SetOutputMode(Unoccluded); }
  void SetOutputModeToNormal() { this->SetOutputMode(Normal); }
  void SetOutputModeToDepth() { this->SetOutputMode(Depth); }
  ///@}

  ///@{
  /**
   * Kept so that programs written for vtkSSAOPass compile: the depth buffer is the renderer's own
   * here and volumes are never part of the occlusion, so neither value changes the picture.
   * Range of VolumeOpacityThreshold: [0, 1], default 0.9; a value out of range is refused with an
   * error.
   */
  vtkSetMacro(DepthFormat, int);
  vtkGetMacro(DepthFormat, int);
  void SetVolumeOpacityThreshold(double threshold);
  vtkGetMacro(VolumeOpacityThreshold, double);
  ///@}

  /// The stages of the pipeline, in its order.
  enum StageType
  {
    CaptureStage = 0,
    OcclusionStage = 1,
    DenoiseStage = 2,
    ModulateStage = 3,
    NumberOfStages = 4
  };

  ///@{
  /**
   * Measure how long each stage takes. Off by default, because the pass then waits for the graphics
   * card after each stage. GetStageTime() gives seconds of wall time in the last render, 0 if the
   * stage did not run; the capture includes drawing the opaque props.
   */
  vtkSetMacro(StageTiming, bool);
  vtkGetMacro(StageTiming, bool);
  vtkBooleanMacro(StageTiming, bool);
  double GetStageTime(int stage) const;
  ///@}

  /**
   * Bytes of graphics memory that the textures of the pass take now.
   */
  unsigned long GetTextureMemory() const;

  /**
   * Number of shader programs that the stages have built since the pass was made, the mappers'
   * not counted. It stays where it is while parameters change.
   */
  int GetNumberOfProgramBuilds() const;

  ///@{
  /**
   * The last render as data, in the pixels of the renderer's viewport, bottom row first.
   * GetVisibility: one float, V after denoising, before Power and Intensity, 1 where no lit opaque
   * surface is seen. GetGeometry: seven floats, linear view depth in world units (0: no surface),
   * shading normal and facet normal in view coordinates, towards the viewer.
   * False, and the image is left alone, if the last render made none: before any render, in output
   * mode Unoccluded, with Intensity 0 in output mode Composite, or after
   * ReleaseGraphicsResources.
   */
  bool GetVisibility(vtkImageData* image);
  bool GetGeometry(vtkImageData* image);
  ///@}

  /**
   * Draw the renderer's scene with ambient occlusion into the current framebuffer.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Release textures, framebuffers and programs that belong to the window.
   */
  void ReleaseGraphicsResources(vtkWindow* w) override;

protected:
  vtkScreenSpaceAmbientOcclusionPass();
  ~vtkScreenSpaceAmbientOcclusionPass() override;

private:
  vtkScreenSpaceAmbientOcclusionPass(const vtkScreenSpaceAmbientOcclusionPass&) = delete;
  void operator=(const vtkScreenSpaceAmbientOcclusionPass&) = delete;

  double Radius = 0.0;
  int Estimator = Hemisphere;
  int KernelSize = 32;
  int NoiseSize = 4;
  double Bias = -1.0;
  int Denoiser = EdgeAware;
  int Modulation = AmbientAndDiffuse;
  double Intensity = 1.0;
  double Power = 1.0;
  double IntensityScale = 1.0;
  double IntensityShift = 0.0;
  int OutputMode = Composite;
  int DepthFormat = 0;
  double VolumeOpacityThreshold = 0.9;
  bool StageTiming = false;

  class Pipeline;
  std::unique_ptr<Pipeline> Stages;

  // Render() in the order of the pipeline.
  void FollowWindow(vtkWindow* window);
  void RenderScene(const vtkRenderState* s);
  int RenderOpaqueWithOcclusion(const vtkRenderState* s);
  bool CaptureSurfaces(const vtkRenderState* s, const vtkSSAOView& view);
  bool ComputeOcclusion(const vtkSSAOView& view);
  bool RemoveNoise(const vtkSSAOView& view);
  bool ModulateLight(const vtkSSAOView& view);
  void DisplayBuffers(const vtkRenderState* s);

  bool NeedsBuffers() const;
  void UpdateEffectiveRadius(vtkRenderer* renderer);
  void WarnOnce(const char* reason);
  void TimeStage(int stage, const vtkSSAOView& view);
  void SetQuality(int kernelSize);
  template <typename Value>
  void SetInRange(const char* name, Value& variable, double value, double low, double high);
};

#endif
