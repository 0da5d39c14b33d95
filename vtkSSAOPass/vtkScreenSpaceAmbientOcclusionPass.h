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
 * (vtkRenderStepsPass, vtkCameraPass, vtkSequencePass, vtkOpaquePass or an image processing pass
 * over one of them) is wrapped while it renders; a delegate without one is drawn without occlusion.
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
struct vtkSSAODenoiseSettings;

class VTKSSAOPASS_EXPORT vtkScreenSpaceAmbientOcclusionPass : public vtkImageProcessingPass
{
public:
  /// A pass with the defaults.
  static vtkScreenSpaceAmbientOcclusionPass* New();
  vtkTypeMacro(vtkScreenSpaceAmbientOcclusionPass, vtkImageProcessingPass);
  /// Print all parameters.
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How ambient visibility is estimated from the captured buffers.
  enum EstimatorType
  {
    CrytekSphere = 0,
    PositionSphere = 1,
    DepthSphere = 2,
    Hemisphere = 3,
    HemisphereLinearDepth = 4,
    ReflectedHemisphere = 5,
    HorizonAngle = 6,
    ExactHorizon = 7,
    LayeredBitmask = 8
  };

  /// How the noise of the estimate is removed.
  enum DenoiserType
  {
    None = 0,
    Box = 1,
    BoxCentered = 2,
    SeparableGaussian = 3,
    EdgeAware = 4
  };

  /// How the weight of an occluder falls with its distance, for ReflectedHemisphere.
  enum FalloffType
  {
    PowerFalloff = 0,
    NullSquareFalloff = 1,
    InverseSquareFalloff = 2
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
   * Choose estimator, Directions, Steps, Layers, Thickness, NoiseSize, Downsampling,
   * LayerDownsampling and denoiser together. Balanced is the default. Each control may be changed
   * afterwards. All have a noise tile of 4 x 4.
   * - Fast: ExactHorizon, 1 slice of 2 x 8 samples at one of 2 x 2 pixels, interpolated.
   * - Balanced: LayeredBitmask, 5 layers at one of 4 x 4 pixels, 1 slice of 2 x 10 samples at one
   *   of 2 x 2 pixels, interpolated.
   * - Accurate: LayeredBitmask, 5 layers at one of 2 x 2 pixels, 1 slice of 2 x 14 samples at every
   *   pixel.
   */
  void SetQualityToFast();
  void SetQualityToBalanced();
  void SetQualityToAccurate();
  ///@}

  ///@{
  /**
   * The estimator of ambient visibility, by the system it stands for. Those that know of points
   * count a point as hidden when the captured surface lies in front of it. In all of them samples
   * outside the picture are skipped and leave the divisor (the sources take the nearest pixel of
   * the border), and all lengths scale with the radius.
   *
   * - CrytekSphere: Crytek, 2007 (Mittring, "Finding Next Gen: CryEngine 2"). KernelSize points in
   * the ball about the surface, reflected per pixel by the noise tile; no normal. See HalfRule,
   * RangeCheck.
   * - PositionSphere: OGLdev, tutorial 45. KernelSize (128 in the source) fixed points in a cube
   * about the surface; visibility is squared. In the source the cube does not scale with the
   * radius. No noise. See RangeCheck.
   * - DepthSphere: OGLdev, tutorial 46. The same with positions rebuilt from a depth buffer of 32
   * bits, and as exact as that is: the nearer the near end of the clipping range, the less.
   * - Hemisphere: Chapman, "SSAO Tutorial", 2013, and LearnOpenGL, "SSAO". KernelSize (64
   * in the source) points in the hemisphere above the surface, turned per pixel by the noise tile.
   * See Bias, RangeCheck.
   * - HemisphereLinearDepth: the older version of LearnOpenGL, "SSAO". The same without bias.
   * - ReflectedHemisphere: the SSAO image effect of Unity's standard assets. KernelSize (8, 14 or
   * 26 in the source) points reflected per pixel by the noise tile, turned to the normal's side and
   * pushed by 0.3 along the normal. Their distance in the picture is the radius in pixels at the
   * surface's depth, in the source a share of the picture's width. See MinimumDifference,
   * Attenuation, Falloff.
   * - HorizonAngle: HBAO (Bavoil, Sainz, Dimitrov, "Image-Space Horizon-Based Ambient Occlusion",
   * 2008). The horizon above the tangent plane in Directions x Steps samples. Elevations are
   * against the plane that faces the viewer, in the source against the view plane. See AngleBias.
   * - ExactHorizon: GTAO (Jimenez, Wu, Pesce, Jarabo, "Practical Realtime Strategies for Accurate
   * Indirect Occlusion", 2016). The horizon to either side in Directions slices of twice Steps
   * samples, and the cosine-weighted visibility above it in closed form. Everything behind the
   * horizon counts as solid.
   * - LayeredBitmask: the same slices, but what a sample's ray meets is known behind its first
   * surface too, from Layers layers of depth, so that light passes behind what is thin. See Layers,
   * Thickness. The sectors of a slice that are hidden are kept as bits (Therrien, Levesque, Gilet,
   * "Screen Space Indirect Lighting with Visibility Bitmask", 2023). The default.
   *
   * Changing to one of the first seven, which stand for a source's system, also sets what a preset
   * may have left otherwise: NoiseSize 4, Downsampling 1, Directions 6, Steps 4. An unknown value
   * is refused with an error.
   */
  void SetEstimator(int estimator);
  vtkGetMacro(Estimator, int);
  void SetEstimatorToCrytekSphere() { this->SetEstimator(CrytekSphere); }
  void SetEstimatorToPositionSphere() { this->SetEstimator(PositionSphere); }
  void SetEstimatorToDepthSphere() { this->SetEstimator(DepthSphere); }
  void SetEstimatorToHemisphere() { this->SetEstimator(Hemisphere); }
  void SetEstimatorToHemisphereLinearDepth() { this->SetEstimator(HemisphereLinearDepth); }
  void SetEstimatorToReflectedHemisphere() { this->SetEstimator(ReflectedHemisphere); }
  void SetEstimatorToHorizonAngle() { this->SetEstimator(HorizonAngle); }
  void SetEstimatorToExactHorizon() { this->SetEstimator(ExactHorizon); }
  void SetEstimatorToLayeredBitmask() { this->SetEstimator(LayeredBitmask); }
  ///@}

  ///@{
  /**
   * Number of sample points per pixel. Range [1, 1024], default 32. Set while the estimator is
   * HorizonAngle, ExactHorizon or LayeredBitmask, which have none, it also sets Directions and
   * Steps to those with the nearest product, about 3 directions for 2 steps. A value out of range
   * is refused with an error.
   */
  void SetKernelSize(int size);
  vtkGetMacro(KernelSize, int);
  ///@}

  ///@{
  /**
   * HorizonAngle: number of directions about a pixel, and of samples in each; 6 and 4 in NVIDIA's
   * sample. ExactHorizon, LayeredBitmask: number of slices, and of samples to either side of the
   * pixel in each; where the radius covers fewer pixels there are fewer samples. Range [1, 64]
   * each, defaults 6 and 4. A value out of range is refused with an error.
   */
  void SetDirections(int directions);
  vtkGetMacro(Directions, int);
  void SetSteps(int steps);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /**
   * HorizonAngle: elevation above the tangent plane below which nothing occludes, in degrees, so
   * that the facets of a coarse mesh do not show. Range [0, 89], default 30, as in NVIDIA's sample.
   * A value out of range is refused with an error.
   */
  void SetAngleBias(double degrees);
  vtkGetMacro(AngleBias, double);
  ///@}

  ///@{
  /**
   * LayeredBitmask: how many surfaces behind each other are known of each pixel: 1, or up to 5, for
   * which the opaque props are drawn once more without lighting (the first surface, and behind it
   * the nearest and the farthest front and back), or up to 9, for which they are drawn twice more.
   * Range [1, 9], default 5. A value out of range is refused with an error.
   */
  void SetLayers(int layers);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * LayeredBitmask: how thick every surface is, in world units. Range [0, inf); 0, the default:
   * what lies between a front and the back that closes it is solid, by counting entries and exits,
   * and a surface that nothing closes is a sheet of a tenth of the radius, or, if nothing else is
   * behind it, the border of something that goes on, as a terrain is. A negative, infinite or NaN
   * value is refused with an error.
   */
  void SetThickness(double thickness);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * CrytekSphere: with V the share of points that is not hidden, the visibility is min(1, 2 V) (on,
   * default), so that only what is hidden beyond one half counts, or V (off), which leaves open
   * surfaces grey.
   */
  vtkSetMacro(HalfRule, bool);
  vtkGetMacro(HalfRule, bool);
  vtkBooleanMacro(HalfRule, bool);
  ///@}

  ///@{
  /**
   * CrytekSphere, PositionSphere, DepthSphere, Hemisphere, HemisphereLinearDepth: whether a surface
   * that lies farther in front than the radius counts less (on, default): not at all in the two of
   * OGLdev, by smoothstep(0, 1, radius / difference of depths) in the others. Off, objects have
   * dark halos on what is far behind them.
   */
  vtkSetMacro(RangeCheck, bool);
  vtkGetMacro(RangeCheck, bool);
  vtkBooleanMacro(RangeCheck, bool);
  ///@}

  ///@{
  /**
   * ReflectedHemisphere: the depth by which a surface must lie in front of a sample point to hide
   * it, as a share of the radius. Range [0, 1], default 0.01 ("MinZ" of the source). A value out of
   * range is refused with an error.
   */
  void SetMinimumDifference(double share);
  vtkGetMacro(MinimumDifference, double);
  ///@}

  ///@{
  /**
   * ReflectedHemisphere: how the weight of an occluder depends on z, the depth by which it lies in
   * front of the sample point, as a share of the radius from 0 to 1. PowerFalloff (default):
   * (1 - z)^(1 / Attenuation). NullSquareFalloff: 1 - min(1, (1 - z)^11 + z). InverseSquareFalloff:
   * 1 / (1 + 10 z^2), which does not fall to 0. The latter two stand in the source as alternatives,
   * commented out. An unknown value is refused with an error.
   */
  void SetFalloff(int falloff);
  vtkGetMacro(Falloff, int);
  void SetFalloffToPower() { this->SetFalloff(PowerFalloff); }
  void SetFalloffToNullSquare() { this->SetFalloff(NullSquareFalloff); }
  void SetFalloffToInverseSquare() { this->SetFalloff(InverseSquareFalloff); }
  ///@}

  ///@{
  /**
   * ReflectedHemisphere with PowerFalloff: above 1 far occluders count more, below less. Range
   * [0.01, 100], default 1; the source offers 0.2 to 2. A value out of range is refused with an
   * error.
   */
  void SetAttenuation(double attenuation);
  vtkGetMacro(Attenuation, double);
  ///@}

  ///@{
  /**
   * Edge length of the tile of random numbers, in pixels: the rotations, reflections and shifts
   * that differ from pixel to pixel. Range [1, 64], default 4; 1 uses the same for all pixels,
   * which shows as banding. The denoisers span one tile. A value out of range is refused with an
   * error.
   */
  void SetNoiseSize(int size);
  vtkGetMacro(NoiseSize, int);
  ///@}

  ///@{
  /**
   * Visibility is estimated for one pixel of each square of N x N and interpolated along the
   * surfaces between them, by the EdgeAware denoiser; with another denoiser N is 1. The noise tile
   * counts estimated pixels. More samples for fewer pixels are more accurate than the reverse.
   * Range [1, 4], default 1. A value out of range is refused with an error.
   */
  void SetDownsampling(int edge);
  vtkGetMacro(Downsampling, int);
  ///@}

  ///@{
  /**
   * LayeredBitmask: layers are looked for at one pixel of each square of N x N, or of Downsampling,
   * if that is larger. What lies behind the first surface needs to be known less finely than where
   * visibility is estimated. Range [1, 4], default 4. A value out of range is refused with an
   * error.
   */
  void SetLayerDownsampling(int edge);
  vtkGetMacro(LayerDownsampling, int);
  ///@}

  ///@{
  /**
   * How far the captured surface must lie in front of a sample point to hide it, in world units:
   * CrytekSphere, PositionSphere, DepthSphere, Hemisphere, HemisphereLinearDepth. Automatic by
   * default, GetBias() is then -1: 0.05 x the effective radius for Hemisphere, as in its source,
   * and 0 for the others, whose sources have none. Range of SetBias: [0, inf). In Hemisphere the
   * depth that the surface itself gains within half a pixel is always added, so that a grazing
   * plane does not hide itself. A negative, infinite or NaN value is refused with an error.
   */
  void SetBias(double bias);
  void SetBiasToAutomatic();
  vtkGetMacro(Bias, double);
  ///@}

  /**
   * Bias, or the automatic one for the effective radius, in world units.
   */
  double GetEffectiveBias() const;

  ///@{
  /**
   * How the noise of the estimator is removed, over one noise tile of N x N pixels (N = NoiseSize;
   * with N = 1 there is nothing to remove and all do nothing).
   * - None: not at all.
   * - Box: the plain mean at -N/2 .. N/2 - 1 pixels (LearnOpenGL, "SSAO": -2..1). It leaks over
   * edges, as the next does.
   * - BoxCentered: the plain mean at -(N-1)/2 .. (N-1)/2 pixels with linear filtering (OGLdev,
   * tutorial 45: -1.5..1.5), so that the picture does not shift.
   * - SeparableGaussian: across, then down, over N pixels to either side with a standard deviation
   * of N/2, of the pixels whose depth differs by less than half the radius and whose normal by less
   * than 41 degrees (Unity's SSAO image effect, whose weights 5 4 3 2 1 have the same variance).
   * - EdgeAware (default): the mean over one noise tile of the pixels on the same surface, by
   * distance from the tangent plane and by normal.
   * An unknown value is refused with an error.
   */
  void SetDenoiser(int denoiser);
  vtkGetMacro(Denoiser, int);
  void SetDenoiserToNone() { this->SetDenoiser(None); }
  void SetDenoiserToBox() { this->SetDenoiser(Box); }
  void SetDenoiserToBoxCentered() { this->SetDenoiser(BoxCentered); }
  void SetDenoiserToSeparableGaussian() { this->SetDenoiser(SeparableGaussian); }
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
   * clamp(IntensityScale x (1 - V - IntensityShift)) taken from 1, so that a positive shift leaves
   * lightly occluded surfaces as they are.
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
    LayersStage = 1,
    OcclusionStage = 2,
    DenoiseStage = 3,
    ModulateStage = 4,
    NumberOfStages = 5
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
   * What the last render did. GetNumberOfEstimatedPixels: for how many pixels the estimator ran:
   * with the denoisers None and EdgeAware those of the rectangle that the opaque props cover on the
   * screen, over the square of Downsampling; 0 if no visibility was needed, or if that of the frame
   * before was used again, because neither scene, camera nor settings have changed since.
   * GetNumberOfSampledPixels: for how many of these samples were taken: not where there is no
   * surface, where ExactHorizon's or LayeredBitmask's radius covers less than 1.3 pixels, nor, with
   * LayeredBitmask, where all that is in reach is proven to be the one plane that the pixel shows.
   * It is counted when it is asked for, which takes some milliseconds.
   * GetNumberOfLayerDrawings: how often the opaque props were drawn once more for the layers behind
   * the first.
   */
  int GetNumberOfEstimatedPixels() const;
  int GetNumberOfSampledPixels() const;
  int GetNumberOfLayerDrawings() const;
  ///@}

  ///@{
  /**
   * The last render as data, in the pixels of the renderer's viewport, bottom row first.
   * GetVisibility: one float, V after denoising, before Power and Intensity, 1 where no lit opaque
   * surface is seen. GetGeometry: eight floats, linear view depth in world units (0: no surface),
   * shading normal and facet normal in view coordinates, towards the viewer, and 1 where the
   * surface shows its front, -1 where its back.
   * GetSolids: eight floats, for LayeredBitmask, of one pixel of each square in which layers are
   * looked for (see LayerDownsampling): front and back of up to four stretches of the ray inside
   * solids, as linear view depths, 0 and 0 for none, 1e30 for no end; the first front is negative
   * where the surface shows its back. False, and the image is left alone, if the last render made
   * none: before any render, in output mode Unoccluded, with Intensity 0 in output mode Composite,
   * or after ReleaseGraphicsResources.
   */
  bool GetVisibility(vtkImageData* image);
  bool GetGeometry(vtkImageData* image);
  bool GetSolids(vtkImageData* image);
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
  int Directions = 6;
  int Steps = 4;
  double AngleBias = 30.0;
  int Layers = 5;
  double Thickness = 0.0;
  bool HalfRule = true;
  bool RangeCheck = true;
  double MinimumDifference = 0.01;
  int Falloff = PowerFalloff;
  double Attenuation = 1.0;
  int NoiseSize = 4;
  int Downsampling = 1;
  int LayerDownsampling = 4;
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
  void FindVisibilityOfTile(const vtkSSAOView& tile);
  bool ReuseVisibility(const vtkSSAOView& view);
  bool KeepVisibility();
  bool FindLayers(const vtkRenderState* s, const vtkSSAOView& view);
  bool ComputeOcclusion(const vtkSSAOView& view);
  bool RemoveNoise(const vtkSSAOView& view);
  vtkSSAODenoiseSettings DenoiseSettings();
  bool PostponeInterpolation(const vtkSSAOView& view);
  void InterpolateNow();
  bool ModulateLight(const vtkSSAOView& view);
  void DisplayBuffers(const vtkRenderState* s);

  bool NeedsBuffers() const;
  void UpdateEffectiveRadius(vtkRenderer* renderer);
  void WarnOnce(const char* reason);
  void Fail(const char* what);
  void TimeStage(int stage, const vtkSSAOView& view);
  void SetQuality(
    int estimator, int directions, int steps, int downsampling, int layerDownsampling);
  template <typename Value>
  void SetInRange(const char* name, Value& variable, double value, double low, double high);
};

#endif
