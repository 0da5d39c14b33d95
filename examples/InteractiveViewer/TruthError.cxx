// SPDX-License-Identifier: BSD-3-Clause
#include "TruthError.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSSAOImageError.h>
#include <vtkSSAOTruthCamera.h>
#include <vtkSSAOTruthImage.h>
#include <vtkSSAOTruthScene.h>
#include <vtkSSAOTruthTracer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

namespace viewer
{
namespace
{
const int Rays = 64; // per pixel

vtkSSAOTruthCamera CameraOf(vtkRenderer* renderer, const double origin[3])
{
  const int* size = renderer->GetSize();
  return { renderer->GetActiveCamera(), size[0], size[1], origin };
}

/// When what is drawn was last changed, not counting the camera.
vtkMTimeType TimeOf(vtkRenderer* renderer)
{
  vtkMTimeType time = 0;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    time = std::max(time, actor->GetRedrawMTime());
  }
  return time;
}
}

/// A view and the threads that trace it. They use nothing of VTK's.
struct TruthError::Job
{
  enum OutcomeType
  {
    Tracing,
    Traced,
    Failed
  };

  vtkSSAOTruthScene Scene;
  vtkSSAOTruthTracer Tracer;
  std::string CameraDigest;
  double Radius = 0.0;
  vtkMTimeType SceneTime = 0;

  vtkSSAOTruthImage Image;
  std::atomic<double> Share{ 0.0 };
  std::atomic<bool> Cancelled{ false };
  std::atomic<OutcomeType> Outcome{ Tracing };
  std::thread Thread;

  std::vector<float> Visibility; // that was compared last
  vtkSSAOImageError Error;

  ~Job()
  {
    this->Cancelled = true;
    this->Join();
  }

  void Join()
  {
    if (this->Thread.joinable())
    {
      this->Thread.join();
    }
  }
};

//------------------------------------------------------------------------------
TruthError::TruthError() = default;
TruthError::~TruthError() = default;

//------------------------------------------------------------------------------
bool TruthError::IsAvailable()
{
  return true;
}

//------------------------------------------------------------------------------
void TruthError::Start(vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass)
{
  this->Current = std::make_unique<Job>();
  Job* job = this->Current.get();
  job->Scene.Gather(renderer);
  const vtkSSAOTruthCamera camera = CameraOf(renderer, job->Scene.GetOrigin());
  job->CameraDigest = camera.GetDigest();
  job->Radius = pass->GetEffectiveRadius();
  job->SceneTime = TimeOf(renderer);
  job->Tracer.SetRadius(job->Radius);
  job->Tracer.SetRaysPerPixel(Rays);
  // One processor goes on drawing.
  job->Tracer.SetThreads(std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1));
  job->Tracer.SetProgress(
    [job](double share)
    {
      job->Share = share;
      return !job->Cancelled;
    });
  job->Thread = std::thread(
    [job, camera] {
      job->Outcome = job->Tracer.Trace(job->Scene, camera, job->Image) ? Job::Traced : Job::Failed;
    });
}

//------------------------------------------------------------------------------
void TruthError::Cancel()
{
  this->Current.reset();
}

//------------------------------------------------------------------------------
void TruthError::Follow(vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass)
{
  if (this->Current &&
    (CameraOf(renderer, this->Current->Scene.GetOrigin()).GetDigest() !=
        this->Current->CameraDigest ||
      pass->GetEffectiveRadius() != this->Current->Radius ||
      TimeOf(renderer) != this->Current->SceneTime))
  {
    this->Cancel();
  }
}

//------------------------------------------------------------------------------
void TruthError::Wait()
{
  if (this->Current)
  {
    this->Current->Join();
  }
}

//------------------------------------------------------------------------------
bool TruthError::IsTracing() const
{
  return this->Current && this->Current->Outcome == Job::Tracing;
}

//------------------------------------------------------------------------------
void TruthError::Compare(vtkScreenSpaceAmbientOcclusionPass* pass)
{
  if (!this->Current || this->Current->Outcome != Job::Traced)
  {
    return;
  }
  vtkNew<vtkImageData> image;
  std::vector<float> visibility;
  if (pass->GetVisibility(image) &&
    image->GetNumberOfPoints() == static_cast<vtkIdType>(this->Current->Image.Visibility.size()))
  {
    const auto* first = static_cast<const float*>(image->GetScalarPointer());
    visibility.assign(first, first + image->GetNumberOfPoints());
  }
  if (visibility != this->Current->Visibility)
  {
    this->Current->Visibility = visibility;
    if (!visibility.empty())
    {
      this->Current->Error.Compare(visibility, this->Current->Image);
    }
  }
}

//------------------------------------------------------------------------------
std::string TruthError::Describe() const
{
  if (!this->Current)
  {
    return "not asked for";
  }
  char text[80] = "it could not be traced";
  if (this->Current->Outcome == Job::Tracing)
  {
    std::snprintf(text, sizeof(text), "tracing, %.0f %%", 100.0 * this->Current->Share);
  }
  else if (this->Current->Outcome == Job::Traced && this->Current->Visibility.empty())
  {
    std::snprintf(text, sizeof(text), "there is no visibility here");
  }
  else if (this->Current->Outcome == Job::Traced)
  {
    std::snprintf(text, sizeof(text), "RMSE %.4f, bias %+.4f",
      this->Current->Error.GetRootMeanSquare(), this->Current->Error.GetBias());
  }
  return text;
}
}
