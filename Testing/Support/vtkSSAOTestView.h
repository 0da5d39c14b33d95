// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOTestView
 * @brief   A window with one renderer and the pass, and what it shows.
 *
 * On destruction the window, the renderer and the pass must be the last references to themselves:
 * a leaked one fails the test. The environment variable SSAO_TEST_WINDOW names the class that the
 * window must have.
 */

#ifndef vtkSSAOTestView_h
#define vtkSSAOTestView_h

#include "vtkSSAOTestImage.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkSmartPointer.h" // For members

#include <string>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkImageData;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;
class vtkSSAOTestMonitor;

class vtkSSAOTestView
{
public:
  explicit vtkSSAOTestView(
    vtkSSAOTestMonitor& monitor, int width = 300, int height = 200, int multiSamples = 0);
  ~vtkSSAOTestView();
  vtkSSAOTestView(const vtkSSAOTestView&) = delete;
  void operator=(const vtkSSAOTestView&) = delete;

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkScreenSpaceAmbientOcclusionPass> Pass;

  /// The presets of quality: 0 Fast, 1 Balanced, 2 Accurate.
  static constexpr int NumberOfPresets = 3;
  static const char* GetPresetName(int preset);
  void SetPreset(int preset);

  ///@{
  /**
   * Add an actor with VTK's default material.
   */
  vtkActor* Add(vtkPolyData* surface);
  vtkActor* Add(vtkAlgorithm* source);
  ///@}

  /**
   * Place the camera; the clipping range is fitted to the props.
   */
  void Look(const std::vector<double>& from, const std::vector<double>& at,
    const std::vector<double>& up, double viewAngle = 30.0);

  /**
   * Parallel projection; scale is half the height of the view in world units.
   */
  void LookParallel(const std::vector<double>& from, const std::vector<double>& at,
    const std::vector<double>& up, double scale);

  /**
   * Render the window and read the visibility of the pass in float32, after denoising.
   */
  vtkSSAOTestImage Visibility();

  /**
   * What VTK's own pass makes of the same scene, as the report sets it: 64 points, blur, bias a
   * hundredth of the radius. It multiplies the finished colour, so the scene is white meanwhile.
   */
  vtkSSAOTestImage VisibilityOfVTK(double radius);

  ///@{
  /**
   * The geometry that the last render captured: where a lit opaque surface is seen (1, elsewhere
   * 0), linear depth in world units (0: none), one component (0 to 2) of the shading normal.
   */
  vtkSSAOTestImage Surfaces();
  vtkSSAOTestImage Depth();
  vtkSSAOTestImage Normal(int component);
  ///@}

  /**
   * Statistics of an image over the pixels that show a surface in the last render.
   */
  vtkSSAOStatistics MeasureSurfaces(const vtkSSAOTestImage& image);

  /**
   * Render the window with the pass as it is set, and read the picture (RGB).
   */
  vtkSmartPointer<vtkImageData> Picture();

private:
  void Render();
  vtkSSAOTestImage ReadGeometry(int component);

  vtkSSAOTestMonitor& Monitor;
  bool Watched = false;
};

/**
 * The picture of a window (RGB) as it was rendered last.
 */
vtkSmartPointer<vtkImageData> vtkSSAOReadWindow(vtkRenderWindow* window);

#endif
