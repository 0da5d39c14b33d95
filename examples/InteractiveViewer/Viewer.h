// SPDX-License-Identifier: BSD-3-Clause
// What the keys and sliders do to the pass, and what the panel tells about it.
#ifndef InteractiveViewer_Viewer_h
#define InteractiveViewer_Viewer_h

#include "Estimators.h"
#include "FrameBudget.h"
#include "KeyStyle.h"
#include "Panel.h"
#include "Presets.h"
#include "TruthError.h"

#include <vtkCallbackCommand.h>
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
  /// Shows the scene of a renderer, which must be in the window and have its camera. The preset is
  /// a number of GetPresets(); while the camera moves there should be frameRate frames per second.
  Viewer(vtkRenderWindow* window, vtkRenderer* renderer, int preset, double frameRate);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Opens the window and draws.
  void Open();

  /// Until the window is closed.
  void Interact() { this->Interactor->Start(); }

  /// Plays a file of events, as vtkInteractorEventRecorder writes it.
  void Play(const std::string& file);

  /// Writes what the window shows as a PNG.
  void WritePicture(const std::string& file);

  /// A line for each thing that may be changed: "name: value".
  std::string GetState() const;

private:
  std::vector<Control> MakeControls() const;
  bool UseKey(char key);
  void SetPreset(int preset);
  void StepEstimator(int step);
  void StepModulation();
  void GrabPicture();
  void ToggleTruth();
  const Estimator& CurrentEstimator() const;
  std::string DescribeSamples(vtkScreenSpaceAmbientOcclusionPass* pass) const;
  std::string DescribeRadius() const;
  std::string DescribeCost(vtkScreenSpaceAmbientOcclusionPass* pass, double seconds) const;
  void BeforeFrame();
  void AfterFrame();
  void WatchTracing(bool tracing);
  void FollowTracing(const int* timer);

  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  vtkNew<vtkScreenSpaceAmbientOcclusionPass> Pass;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<KeyStyle> Style;
  std::vector<Estimator> Estimators = FindEstimators();
  int CurrentPreset;
  FrameBudget Budget;
  TruthError Truth;
  std::string Message; // of the last key
  std::string Cost;    // of the last frame whose visibility was estimated
  std::unique_ptr<Panel> Controls;
  unsigned long Observers[2];
  vtkNew<vtkCallbackCommand> TimerCommand;
  int Timer = 0;           // while the truth is traced
  double FrameStart = 0.0; // seconds
};
}

#endif
