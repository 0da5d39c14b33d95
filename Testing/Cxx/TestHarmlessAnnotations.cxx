// SPDX-License-Identifier: BSD-3-Clause

// Text, 2D actors, legends, axes, orientation markers and widgets stay as they are.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"

#include "vtkAxisActor2D.h"
#include "vtkBoxWidget2.h"
#include "vtkCaptionActor2D.h"
#include "vtkCornerAnnotation.h"
#include "vtkCubeAxesActor.h"
#include "vtkLegendBoxActor.h"
#include "vtkOrientationMarkerWidget.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
void AddTexts(Stage& stage)
{
  Grid grid(3);
  AddAnnotations(stage.Renderer, grid);
  vtkNew<vtkCornerAnnotation> corner;
  corner->SetText(2, "corner");
  stage.Renderer->AddViewProp(corner);
  vtkNew<vtkCaptionActor2D> caption;
  caption->SetCaption("caption");
  caption->SetAttachmentPoint(1.0, 1.0, 0.5);
  stage.Renderer->AddViewProp(caption);
}

//------------------------------------------------------------------------------
void AddLegendAndAxes(Stage& stage)
{
  vtkNew<vtkLegendBoxActor> legend;
  legend->SetNumberOfEntries(2);
  double red[3] = { 1.0, 0.2, 0.2 };
  double blue[3] = { 0.2, 0.2, 1.0 };
  legend->SetEntry(0, MakeSphere(0.4, 6), "one", red);
  legend->SetEntry(1, MakeSphere(0.4, 6), "two", blue);
  legend->UseBackgroundOn();
  legend->SetBackgroundOpacity(0.5);
  stage.Renderer->AddViewProp(legend);
  vtkNew<vtkAxisActor2D> axis;
  axis->SetPoint1(0.1, 0.9);
  axis->SetPoint2(0.9, 0.9);
  stage.Renderer->AddViewProp(axis);
  vtkNew<vtkCubeAxesActor> cube;
  cube->SetBounds(-1.0, 3.0, -1.0, 3.0, -0.4, 0.5);
  cube->SetCamera(stage.Camera());
  stage.Renderer->AddViewProp(cube);
}

//------------------------------------------------------------------------------
// Widgets with their interactors: they outlive the stages.
struct Widgets
{
  std::vector<vtkSmartPointer<vtkRenderWindowInteractor>> Interactors;
  std::vector<vtkSmartPointer<vtkInteractorObserver>> All;

  void Add(Stage& stage)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(stage.Window);
    this->Interactors.emplace_back(interactor);
    vtkNew<vtkAxesActor> axes;
    vtkNew<vtkOrientationMarkerWidget> marker;
    marker->SetOrientationMarker(axes);
    marker->SetViewport(0.7, 0.0, 1.0, 0.4);
    vtkNew<vtkBoxWidget2> box;
    box->CreateDefaultRepresentation();
    double bounds[6] = { 0.0, 2.0, 0.0, 2.0, -0.3, 0.6 };
    vtkWidgetRepresentation* representation = box->GetRepresentation();
    representation->PlaceWidget(bounds);
    vtkNew<vtkSliderRepresentation2D> bar;
    bar->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    bar->GetPoint1Coordinate()->SetValue(0.1, 0.2);
    bar->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
    bar->GetPoint2Coordinate()->SetValue(0.5, 0.2);
    vtkNew<vtkSliderWidget> slider;
    slider->SetRepresentation(bar);
    for (vtkInteractorObserver* widget : { static_cast<vtkInteractorObserver*>(marker),
           static_cast<vtkInteractorObserver*>(box), static_cast<vtkInteractorObserver*>(slider) })
    {
      widget->SetInteractor(interactor);
      widget->SetCurrentRenderer(stage.Renderer);
      widget->SetEnabled(1);
      this->All.emplace_back(widget);
    }
  }

  void Clear()
  {
    for (vtkInteractorObserver* widget : this->All)
    {
      widget->SetEnabled(0);
    }
    this->All.clear();
    this->Interactors.clear();
  }
};
}

//------------------------------------------------------------------------------
int TestHarmlessAnnotations(int, char*[])
{
  Report report;
  CheckHarmless(report, "text, billboards, captions, scalar bar", AddTexts);
  CheckHarmless(report, "legend, axes", AddLegendAndAxes);
  Widgets widgets;
  CheckHarmless(report, "orientation marker, box and slider widgets",
    [&](Stage& stage) { widgets.Add(stage); });
  widgets.Clear();
  HarmlessOptions samples;
  samples.MultiSamples = 4;
  CheckHarmless(report, "text, 4 samples", AddTexts, samples);
  return report.GetResult();
}
