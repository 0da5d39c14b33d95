// SPDX-License-Identifier: BSD-3-Clause
// Text and sliders over the scene.
#ifndef InteractiveViewer_Panel_h
#define InteractiveViewer_Panel_h

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSliderWidget.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <functional>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace viewer
{
/// A value that a slider shows and sets.
struct Control
{
  std::string Title;
  double Low;
  double High;
  std::function<double()> Get;
  std::function<void(double)> Set;
};

class Panel
{
public:
  /// Puts a layer with a slider for each control over the window. The interactor must live longer.
  Panel(vtkRenderWindow* window, vtkRenderWindowInteractor* interactor,
    const std::vector<Control>& controls);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  void SetStatus(const std::string& text) { this->Status->SetInput(text.c_str()); }
  void SetHelp(const std::string& text) { this->Help->SetInput(text.c_str()); }

  /// Moves the sliders to the values of the controls.
  void Refresh();

  ///@{
  /// A hidden panel takes no part in the picture, and its sliders no events.
  void SetVisible(bool visible);
  bool GetVisible() const { return this->Visible; }
  ///@}

private:
  void AddStrip();
  void AddSlider(size_t i, vtkRenderWindowInteractor* interactor);
  void TakeValue(vtkObject* slider, unsigned long event, void* data);

  vtkNew<vtkRenderer> Renderer; // of its own, because some modes show nothing else in the scene's
  vtkNew<vtkActor2D> Strip;     // behind the sliders
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Help;
  std::vector<Control> Controls;
  std::vector<vtkSmartPointer<vtkSliderWidget>> Sliders; // one for each control
  bool Visible = true;
};
}

#endif
