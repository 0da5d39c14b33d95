// SPDX-License-Identifier: BSD-3-Clause
// What the keys and sliders do to the pass, and what the panel tells about it.
#ifndef InteractiveViewer_Viewer_h
#define InteractiveViewer_Viewer_h

#include "Estimators.h"
#include "KeyStyle.h"
#include "Panel.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>

#include <memory>
#include <string>
#include <vector>

namespace viewer
{
class Viewer
{
public:
  /// Shows the scene of a renderer, which must be in the window and have its camera.
  Viewer(vtkRenderWindow* window, vtkRenderer* renderer);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Opens the window and draws.
  void Open();

  /// Until the window is closed.
  void Interact() { this->Interactor->Start(); }

  /// Plays a file of events, as vtkInteractorEventRecorder writes it.
  void Play(const std::string& file);

  /// A line for each thing that may be changed: "name: value".
  std::string GetState() const;

private:
  std::vector<Control> MakeControls() const;
  bool UseKey(char key);
  void StepEstimator(int step);
  const Estimator& CurrentEstimator() const;
  std::string DescribeSamples() const;
  std::string DescribeRadius() const;
  void BeforeFrame();
  void AfterFrame();

  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> Pass;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<KeyStyle> Style;
  std::vector<Estimator> Estimators = FindEstimators();
  std::unique_ptr<Panel> Controls;
  unsigned long Observers[2];
  double FrameStart = 0.0; // seconds
  double FrameTime = 0.0;  // seconds, of the last frame; 0 before it
};
}

#endif
