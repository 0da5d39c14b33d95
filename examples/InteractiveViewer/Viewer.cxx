// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "../RenderMesh/Messages.h"

#include <vtkCommand.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkMath.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>

namespace viewer
{
namespace
{
using rendermesh::Text;
using AmbientOcclusion = vtkScreenSpaceAmbientOcclusionPass;

/// What a key shows. The first three are also one after the other on c.
struct Mode
{
  char Key;
  int OutputMode;
  const char* Name;
  const char* Text;
};
const Mode Modes[] = {
  { 'o', AmbientOcclusion::Unoccluded, "unoccluded", "without ambient occlusion" },
  { 'a', AmbientOcclusion::Composite, "composite", "with ambient occlusion" },
  { 'v', AmbientOcclusion::Occlusion, "occlusion", "ambient visibility alone" },
  { 'n', AmbientOcclusion::Normal, "normal", "normals" },
  { 'd', AmbientOcclusion::Depth, "depth", "depth" },
};
const char* const HelpText = "o off   a on   v alone   c next of these\n"
                             "n normals   d depth\n"
                             "e, shift-e estimator   0 automatic radius\n"
                             "h hide this   q quit";

const Mode& ModeOf(int outputMode)
{
  for (const Mode& mode : Modes)
  {
    if (mode.OutputMode == outputMode)
    {
      return mode;
    }
  }
  return Modes[0];
}

/// To as many digits as are worth reading.
double Rounded(double value, int digits)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.*g", digits, value);
  return std::strtod(text, nullptr);
}
}

//------------------------------------------------------------------------------
Viewer::Viewer(vtkRenderWindow* window, vtkRenderer* renderer)
  : Window(window)
  , Renderer(renderer)
{
  this->Renderer->SetPass(this->Pass);
  this->Interactor->SetRenderWindow(window);
  this->Interactor->SetInteractorStyle(this->Style);
  this->Style->SetKeyFunction([this](char key) { return this->UseKey(key); });
  this->Controls = std::make_unique<Panel>(window, this->Interactor, this->MakeControls());
  this->Controls->SetHelp(HelpText);
  this->Observers[0] = window->AddObserver(vtkCommand::StartEvent, this, &Viewer::BeforeFrame);
  this->Observers[1] = window->AddObserver(vtkCommand::EndEvent, this, &Viewer::AfterFrame);
}

//------------------------------------------------------------------------------
Viewer::~Viewer()
{
  for (unsigned long observer : this->Observers)
  {
    this->Window->RemoveObserver(observer);
  }
  this->Style->SetKeyFunction({});
}

//------------------------------------------------------------------------------
std::vector<Control> Viewer::MakeControls() const
{
  AmbientOcclusion* pass = this->Pass;
  double bounds[6];
  this->Renderer->ComputeVisiblePropBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const auto radius = [pass]
  { return pass->GetRadius() > 0.0 ? pass->GetRadius() : pass->GetEffectiveRadius(); };
  const auto samples = [this, pass]() -> double
  {
    return this->CurrentEstimator().HasDirections ? pass->GetDirections() * pass->GetSteps()
                                                  : pass->GetKernelSize();
  };
  return {
    { "radius", Rounded(0.005 * diagonal, 2), Rounded(0.4 * diagonal, 2), radius,
      [pass](double value) { pass->SetRadius(Rounded(value, 3)); } },
    { "intensity", 0.0, 4.0, [pass] { return pass->GetIntensity(); },
      [pass](double value) { pass->SetIntensity(0.05 * std::round(value / 0.05)); } },
    // With directions and steps the pass takes those with the nearest product.
    { "samples", 1.0, 128.0, samples,
      [pass](double value) { pass->SetKernelSize(static_cast<int>(std::lround(value))); } },
  };
}

//------------------------------------------------------------------------------
void Viewer::Open()
{
  this->Interactor->Initialize();
  this->Window->Render(); // now the pass knows the automatic radius
  this->Controls->Refresh();
  this->Window->Render();
}

//------------------------------------------------------------------------------
void Viewer::Play(const std::string& file)
{
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(this->Interactor);
  recorder->KeyPressActivationOff(); // the key i would switch it on
  recorder->SetFileName(file.c_str());
  recorder->Play();
  this->Window->Render();
}

//------------------------------------------------------------------------------
bool Viewer::UseKey(char key)
{
  const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(key)));
  const int outputMode = this->Pass->GetOutputMode();
  switch (lower)
  {
    case 'c':
      this->Pass->SetOutputMode(outputMode == AmbientOcclusion::Unoccluded
          ? AmbientOcclusion::Composite
          : outputMode == AmbientOcclusion::Composite ? AmbientOcclusion::Occlusion
                                                      : AmbientOcclusion::Unoccluded);
      break;
    case 'e':
      this->StepEstimator(this->Interactor->GetShiftKey() ? -1 : 1);
      break;
    case '0':
      this->Pass->SetRadius(0.0);
      this->Window->Render(); // now the pass knows it
      break;
    case 'h':
      this->Controls->SetVisible(!this->Controls->GetVisible());
      break;
    default:
    {
      const auto mode = std::find_if(std::begin(Modes), std::end(Modes),
        [lower](const Mode& candidate) { return candidate.Key == lower; });
      if (mode == std::end(Modes))
      {
        return false;
      }
      this->Pass->SetOutputMode(mode->OutputMode);
    }
  }
  this->Controls->Refresh();
  this->Interactor->Render();
  return true;
}

//------------------------------------------------------------------------------
void Viewer::StepEstimator(int step)
{
  const int count = static_cast<int>(this->Estimators.size());
  const int place = static_cast<int>(&this->CurrentEstimator() - this->Estimators.data());
  // From a source's system back to ours: with what the preset sets besides.
  this->Pass->SetQualityToBalanced();
  this->Pass->SetEstimator(this->Estimators[(place + step + count) % count].Value);
}

//------------------------------------------------------------------------------
const Estimator& Viewer::CurrentEstimator() const
{
  for (const Estimator& estimator : this->Estimators)
  {
    if (estimator.Value == this->Pass->GetEstimator())
    {
      return estimator;
    }
  }
  return this->Estimators.front();
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeSamples() const
{
  return this->CurrentEstimator().HasDirections
    ? std::to_string(this->Pass->GetDirections()) + " directions x " +
      std::to_string(this->Pass->GetSteps()) + " steps"
    : std::to_string(this->Pass->GetKernelSize()) + " points";
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeRadius() const
{
  return this->Pass->GetRadius() > 0.0 ? Text(this->Pass->GetRadius())
                                       : Text(this->Pass->GetEffectiveRadius()) + " (automatic)";
}

//------------------------------------------------------------------------------
std::string Viewer::GetState() const
{
  return std::string("output: ") + ModeOf(this->Pass->GetOutputMode()).Name +
    "\nestimator: " + this->CurrentEstimator().Name + "\nsamples: " + this->DescribeSamples() +
    "\nradius: " + this->DescribeRadius() + "\nintensity: " + Text(this->Pass->GetIntensity()) +
    "\n";
}

//------------------------------------------------------------------------------
void Viewer::BeforeFrame()
{
  char time[32] = "-";
  if (this->FrameTime > 0.0)
  {
    std::snprintf(time, sizeof(time), "%.1f ms", 1000.0 * this->FrameTime);
  }
  this->Controls->SetStatus(std::string(ModeOf(this->Pass->GetOutputMode()).Text) + "\n" +
    this->CurrentEstimator().Name + ", " + this->DescribeSamples() + "\nradius " +
    this->DescribeRadius() + "\nlast frame " + time);
  this->FrameStart = rendermesh::Seconds();
}

//------------------------------------------------------------------------------
void Viewer::AfterFrame()
{
  this->Window->WaitForCompletion(); // else only the time to hand it to the graphics card is known
  this->FrameTime = rendermesh::Seconds() - this->FrameStart;
}
}
