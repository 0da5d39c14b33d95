// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer.h"

#include "../RenderMesh/Messages.h"

#include <vtkCommand.h>
#include <vtkInteractorEventRecorder.h>
#include <vtkMath.h>
#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
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
                             "n normals   d depth   m modulation\n"
                             "1 fast   2 balanced   3 accurate\n"
                             "e, shift-e estimator   0 automatic radius\n"
                             "t error against the truth   g grab picture\n"
                             "h hide this   q quit";
const char* const ModulationNames[] = { "ambient", "ambient and diffuse", "all" };
const char* const StageNames[] = { "capture", "layers", "occlusion", "denoise", "modulate" };
const unsigned long ProgressPeriod = 250; // milliseconds

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
Viewer::Viewer(vtkRenderWindow* window, vtkRenderer* renderer, int preset, double frameRate)
  : Window(window)
  , Renderer(renderer)
{
  this->SetPreset(preset);
  this->Pass->StageTimingOn();
  this->Renderer->SetPass(this->Pass);
  this->Interactor->SetRenderWindow(window);
  this->Interactor->SetInteractorStyle(this->Style);
  this->Interactor->SetDesiredUpdateRate(frameRate);
  this->Style->SetKeyFunction([this](char key) { return this->UseKey(key); });
  this->Controls = std::make_unique<Panel>(window, this->Interactor, this->MakeControls());
  this->Controls->SetHelp(HelpText);
  // Of the scene's renderer, so that the panel, which is drawn after it, tells of the same frame.
  this->Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &Viewer::BeforeFrame);
  this->Observers[1] = renderer->AddObserver(vtkCommand::EndEvent, this, &Viewer::AfterFrame);
  // Passive: while the mouse button is held, others get no events.
  this->TimerCommand->SetClientData(this);
  this->TimerCommand->SetCallback([](vtkObject*, unsigned long, void* viewer, void* timer)
    { static_cast<Viewer*>(viewer)->FollowTracing(static_cast<int*>(timer)); });
  this->TimerCommand->PassiveObserverOn();
  this->Interactor->AddObserver(vtkCommand::TimerEvent, this->TimerCommand);
}

//------------------------------------------------------------------------------
Viewer::~Viewer()
{
  for (unsigned long observer : this->Observers)
  {
    this->Renderer->RemoveObserver(observer);
  }
  this->Renderer->SetPass(nullptr);
  this->Pass->ReleaseGraphicsResources(this->Window);
  this->Budget.GetMovingPass()->ReleaseGraphicsResources(this->Window);
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
  this->Truth.Wait();
  this->Window->Render();
}

//------------------------------------------------------------------------------
void Viewer::WritePicture(const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  rendermesh::CheckMessages("cannot write " + rendermesh::Quoted(file));
}

//------------------------------------------------------------------------------
bool Viewer::UseKey(char key)
{
  const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(key)));
  const int outputMode = this->Pass->GetOutputMode();
  this->Message.clear();
  switch (lower)
  {
    case '1':
    case '2':
    case '3':
      this->SetPreset(lower - '1');
      break;
    case 'm':
      this->StepModulation();
      break;
    case 't':
      this->ToggleTruth();
      break;
    case 'g':
      this->GrabPicture();
      break;
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
  this->WatchTracing(this->Truth.IsTracing());
  return true;
}

//------------------------------------------------------------------------------
void Viewer::SetPreset(int preset)
{
  this->CurrentPreset = preset;
  (this->Pass->*GetPresets()[preset].Set)();
}

//------------------------------------------------------------------------------
void Viewer::StepEstimator(int step)
{
  const int count = static_cast<int>(this->Estimators.size());
  const int place = static_cast<int>(&this->CurrentEstimator() - this->Estimators.data());
  // From a source's system back to ours: with what the preset sets besides.
  this->SetPreset(this->CurrentPreset);
  this->Pass->SetEstimator(this->Estimators[(place + step + count) % count].Value);
}

//------------------------------------------------------------------------------
void Viewer::StepModulation()
{
  const int count = static_cast<int>(std::size(ModulationNames));
  this->Pass->SetModulation((this->Pass->GetModulation() + 1) % count);
  this->Message = std::string("takes away: ") + ModulationNames[this->Pass->GetModulation()];
}

//------------------------------------------------------------------------------
void Viewer::GrabPicture()
{
  std::string file;
  for (int number = 1; file.empty() || std::ifstream(file); ++number)
  {
    file = "InteractiveViewer-" + std::to_string(number) + ".png";
  }
  try
  {
    this->WritePicture(file);
    this->Message = "wrote " + file;
  }
  catch (const rendermesh::Failure& failure)
  {
    this->Message = failure.what();
  }
}

//------------------------------------------------------------------------------
void Viewer::ToggleTruth()
{
  if (this->Truth.IsWanted())
  {
    this->Truth.Cancel();
  }
  else if (TruthError::IsAvailable())
  {
    this->Truth.Start(this->Renderer, this->Pass);
  }
  else
  {
    this->Message = "the truth needs a build with tests and Embree";
  }
}

//------------------------------------------------------------------------------
void Viewer::WatchTracing(bool tracing)
{
  if (tracing && this->Timer == 0)
  {
    this->Timer = this->Interactor->CreateOneShotTimer(ProgressPeriod);
  }
}

//------------------------------------------------------------------------------
void Viewer::FollowTracing(const int* timer)
{
  if (timer && *timer == this->Timer)
  {
    // One after the other: the interactor for X crashes if a repeating one is destroyed while it
    // fires.
    this->Timer = 0;
    const bool tracing = this->Truth.IsTracing();
    this->Interactor->Render();
    this->WatchTracing(tracing);
  }
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
std::string Viewer::DescribeSamples(AmbientOcclusion* pass) const
{
  return this->CurrentEstimator().HasDirections ? std::to_string(pass->GetDirections()) +
      " directions x " + std::to_string(pass->GetSteps()) + " steps"
                                                : std::to_string(pass->GetKernelSize()) + " points";
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeRadius() const
{
  return this->Pass->GetRadius() > 0.0 ? Text(this->Pass->GetRadius())
                                       : Text(this->Pass->GetEffectiveRadius()) + " (automatic)";
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeCost(AmbientOcclusion* pass, double seconds) const
{
  char text[64];
  std::snprintf(text, sizeof(text), "frame %.1f ms", 1000.0 * seconds);
  std::string cost = text;
  for (int stage = 0; stage < AmbientOcclusion::NumberOfStages; ++stage)
  {
    const double time = 1000.0 * pass->GetStageTime(stage);
    if (time > 0.0)
    {
      std::snprintf(text, sizeof(text), "\n  %s %.1f", StageNames[stage], time);
      cost += text;
    }
  }
  return cost;
}

//------------------------------------------------------------------------------
std::string Viewer::GetState() const
{
  return std::string("output: ") + ModeOf(this->Pass->GetOutputMode()).Name +
    "\npreset: " + NameOfPreset(this->Pass) + "\nestimator: " + this->CurrentEstimator().Name +
    "\nsamples: " + this->DescribeSamples(this->Pass) + "\nradius: " + this->DescribeRadius() +
    "\nintensity: " + Text(this->Pass->GetIntensity()) +
    "\nmodulation: " + ModulationNames[this->Pass->GetModulation()] +
    "\nmovements: " + this->Budget.GetName() + "\nerror: " + this->Truth.Describe() + "\n";
}

//------------------------------------------------------------------------------
void Viewer::BeforeFrame()
{
  this->Renderer->SetPass(this->Budget.Choose(this->Pass, this->Style->IsMoving()));
  this->FrameStart = rendermesh::Seconds();
}

//------------------------------------------------------------------------------
void Viewer::AfterFrame()
{
  this->Window->WaitForCompletion(); // else only the time to hand it to the graphics card is known
  const double seconds = rendermesh::Seconds() - this->FrameStart;
  auto* drawn = AmbientOcclusion::SafeDownCast(this->Renderer->GetPass());
  std::string status = std::string(ModeOf(drawn->GetOutputMode()).Text) + "\n";
  if (drawn == this->Pass)
  {
    status += NameOfPreset(drawn) + ": " + this->CurrentEstimator().Name + "\n" +
      this->DescribeSamples(drawn);
  }
  else
  {
    status += std::string("moving: ") + this->Budget.GetName();
  }
  this->Budget.Judge(seconds, 1.0 / this->Interactor->GetDesiredUpdateRate());
  this->Truth.Follow(this->Renderer, this->Pass);
  this->Truth.Compare(this->Pass);
  // A frame that takes its visibility from the last one tells nothing of what that costs.
  const bool needsVisibility = drawn->GetIntensity() > 0.0 &&
    (drawn->GetOutputMode() == AmbientOcclusion::Composite ||
      drawn->GetOutputMode() == AmbientOcclusion::Occlusion);
  if (!needsVisibility || drawn->GetNumberOfEstimatedPixels() > 0)
  {
    this->Cost = this->DescribeCost(drawn, seconds);
  }
  status += "\nradius " + this->DescribeRadius() + "\n" + this->Cost;
  if (this->Truth.IsWanted())
  {
    status += "\nerror: " + this->Truth.Describe();
  }
  this->Controls->SetStatus(status + (this->Message.empty() ? "" : "\n" + this->Message));
}
}
