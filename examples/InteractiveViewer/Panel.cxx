// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace viewer
{
namespace
{
// Shares of the window's height.
const double StripHeight = 0.17;
const double SliderHeight = 0.075;

/// Dark on a light ground, because the scene behind may be of any colour.
void SetFont(vtkTextActor* text)
{
  vtkTextProperty* font = text->GetTextProperty();
  font->SetFontSize(14);
  font->SetLineSpacing(1.25);
  font->SetColor(0.1, 0.1, 0.1);
  font->SetBackgroundColor(1.0, 1.0, 1.0);
  font->SetBackgroundOpacity(0.75);
  font->SetVerticalJustificationToTop();
}
}

//------------------------------------------------------------------------------
Panel::Panel(vtkRenderWindow* window, vtkRenderWindowInteractor* interactor,
  const std::vector<Control>& controls)
  : Controls(controls)
{
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff(); // the mouse turns the scene
  window->SetNumberOfLayers(2);
  window->AddRenderer(this->Renderer);

  this->AddStrip();
  SetFont(this->Status);
  this->Status->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Status->SetPosition(0.01, 0.99);
  this->Renderer->AddViewProp(this->Status);
  SetFont(this->Help);
  this->Help->GetTextProperty()->SetJustificationToRight();
  this->Help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Help->SetPosition(0.99, 0.99);
  this->Renderer->AddViewProp(this->Help);
  for (size_t i = 0; i < controls.size(); ++i)
  {
    this->AddSlider(i, interactor);
  }
}

//------------------------------------------------------------------------------
Panel::~Panel()
{
  for (vtkSliderWidget* slider : this->Sliders)
  {
    slider->Off();
  }
}

//------------------------------------------------------------------------------
void Panel::AddStrip()
{
  vtkNew<vtkPlaneSource> strip;
  strip->SetOrigin(0.0, 0.0, 0.0);
  strip->SetPoint1(1.0, 0.0, 0.0);
  strip->SetPoint2(0.0, StripHeight, 0.0);
  vtkNew<vtkCoordinate> shares;
  shares->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(strip->GetOutputPort());
  mapper->SetTransformCoordinate(shares);
  this->Strip->SetMapper(mapper);
  this->Strip->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Strip->GetProperty()->SetOpacity(0.75);
  this->Renderer->AddViewProp(this->Strip);
}

//------------------------------------------------------------------------------
void Panel::AddSlider(size_t i, vtkRenderWindowInteractor* interactor)
{
  const double width = 1.0 / this->Controls.size();
  vtkNew<vtkSliderRepresentation2D> drawn;
  drawn->SetMinimumValue(this->Controls[i].Low);
  drawn->SetMaximumValue(this->Controls[i].High);
  drawn->SetTitleText(this->Controls[i].Title.c_str());
  drawn->SetLabelFormat("%.4g");
  drawn->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedViewport();
  drawn->GetPoint1Coordinate()->SetValue((i + 0.1) * width, SliderHeight);
  drawn->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedViewport();
  drawn->GetPoint2Coordinate()->SetValue((i + 0.9) * width, SliderHeight);
  drawn->SetTubeWidth(0.008);
  drawn->SetSliderLength(0.03);
  drawn->SetSliderWidth(0.03);
  drawn->SetEndCapWidth(0.02);
  drawn->SetTitleHeight(0.025);
  drawn->SetLabelHeight(0.025);
  for (vtkTextProperty* font : { drawn->GetTitleProperty(), drawn->GetLabelProperty() })
  {
    font->SetColor(0.1, 0.1, 0.1);
    font->ShadowOff();
    font->ItalicOff();
    font->BoldOff();
  }
  drawn->GetTubeProperty()->SetColor(0.6, 0.6, 0.6);
  drawn->GetCapProperty()->SetColor(0.6, 0.6, 0.6);
  drawn->GetSliderProperty()->SetColor(0.2, 0.4, 0.7);
  drawn->GetSelectedProperty()->SetColor(0.9, 0.5, 0.1);

  auto slider = vtkSmartPointer<vtkSliderWidget>::New();
  slider->SetInteractor(interactor);
  slider->SetDefaultRenderer(this->Renderer);
  slider->SetRepresentation(drawn);
  slider->SetAnimationModeToJump();
  slider->KeyPressActivationOff(); // the key i would switch it off
  slider->AddObserver(vtkCommand::InteractionEvent, this, &Panel::TakeValue);
  slider->AddObserver(vtkCommand::EndInteractionEvent, this, &Panel::TakeValue);
  slider->On();
  this->Sliders.push_back(slider);
}

//------------------------------------------------------------------------------
void Panel::TakeValue(vtkObject* slider, unsigned long, void*)
{
  for (size_t i = 0; i < this->Sliders.size(); ++i)
  {
    if (this->Sliders[i] == slider)
    {
      this->Controls[i].Set(this->Sliders[i]->GetSliderRepresentation()->GetValue());
    }
  }
}

//------------------------------------------------------------------------------
void Panel::Refresh()
{
  for (size_t i = 0; i < this->Sliders.size(); ++i)
  {
    const Control& control = this->Controls[i];
    this->Sliders[i]->GetSliderRepresentation()->SetValue(
      std::clamp(control.Get(), control.Low, control.High));
  }
}

//------------------------------------------------------------------------------
void Panel::SetVisible(bool visible)
{
  this->Visible = visible;
  this->Strip->SetVisibility(visible);
  this->Status->SetVisibility(visible);
  this->Help->SetVisibility(visible);
  for (vtkSliderWidget* slider : this->Sliders)
  {
    slider->SetEnabled(visible);
  }
}
}
