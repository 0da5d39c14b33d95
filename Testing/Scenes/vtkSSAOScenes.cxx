// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOScenes.h"

#include "vtkSSAOSceneHelpers.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <iterator>

namespace vtkSSAOScenes
{
namespace
{
//------------------------------------------------------------------------------
const std::vector<Scene>& AllScenes()
{
  static const std::vector<Scene> scenes = []
  {
    std::vector<Scene> all;
    for (std::vector<Scene> (*list)() : { AnalyticScenes, ProceduralScenes, RealScenes })
    {
      for (Scene& scene : list())
      {
        scene.About.NumberOfViews = static_cast<int>(scene.Views.size());
        all.push_back(scene);
      }
    }
    return all;
  }();
  return scenes;
}

//------------------------------------------------------------------------------
const Scene* FindScene(const std::string& name)
{
  const auto& scenes = AllScenes();
  const auto found = std::find_if(
    scenes.begin(), scenes.end(), [&name](const Scene& scene) { return scene.About.Name == name; });
  return found == scenes.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
// Hand a message to the caller, or to VTK's output where the caller does not want it.
bool Fail(const std::string& message, std::string* error)
{
  if (error)
  {
    *error = message;
  }
  else
  {
    vtkGenericWarningMacro(<< message);
  }
  return false;
}

//------------------------------------------------------------------------------
// The scene, or nullptr after an error.
const Scene* CheckArguments(
  const std::string& name, int view, vtkRenderer* renderer, std::string* error)
{
  const Scene* scene = FindScene(name);
  if (!scene)
  {
    Fail("There is no scene named '" + name + "'.", error);
    return nullptr;
  }
  if (view < 0 || view >= scene->About.NumberOfViews)
  {
    Fail("Scene '" + name + "' has no view " + std::to_string(view) + ".", error);
    return nullptr;
  }
  if (!renderer)
  {
    Fail("Scene '" + name + "' was given no renderer.", error);
    return nullptr;
  }
  return scene;
}

//------------------------------------------------------------------------------
void PlaceCamera(const View& view, vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(view.Position.x, view.Position.y, view.Position.z);
  camera->SetFocalPoint(view.FocalPoint.x, view.FocalPoint.y, view.FocalPoint.z);
  camera->SetViewUp(view.ViewUp.x, view.ViewUp.y, view.ViewUp.z);
  camera->SetViewAngle(view.ViewAngle);
  camera->SetParallelProjection(view.ParallelHeight > 0.0);
  camera->SetParallelScale(0.5 * view.ParallelHeight);
  // Set here because the automatic value depends on whether the window exists already.
  renderer->SetNearClippingPlaneTolerance(0.001);
  renderer->ResetCameraClippingRange();
}
}

//------------------------------------------------------------------------------
std::vector<std::string> Names()
{
  std::vector<std::string> names;
  std::transform(AllScenes().begin(), AllScenes().end(), std::back_inserter(names),
    [](const Scene& scene) { return scene.About.Name; });
  return names;
}

//------------------------------------------------------------------------------
const char* KindName(Kind kind)
{
  switch (kind)
  {
    case Kind::Analytic:
      return "analytic";
    case Kind::Procedural:
      return "procedural";
    default:
      return "real";
  }
}

//------------------------------------------------------------------------------
const char* SphereRadiusArray()
{
  return "sphere_radius";
}

//------------------------------------------------------------------------------
const Info& GetInfo(const std::string& name)
{
  static const Info unknown;
  const Scene* scene = FindScene(name);
  if (!scene)
  {
    Fail("There is no scene named '" + name + "'.", nullptr);
    return unknown;
  }
  return scene->About;
}

//------------------------------------------------------------------------------
bool Build(const std::string& name, int view, vtkRenderer* renderer,
  const std::string& dataDirectory, std::string* error, SphereStyle spheres)
{
  const Scene* scene = CheckArguments(name, view, renderer, error);
  if (!scene)
  {
    return false;
  }
  Context context{ renderer, dataDirectory, spheres, {} };
  if (!scene->Add(context))
  {
    return Fail("Scene '" + name + "': " + context.Error, error);
  }
  renderer->SetBackground(0.88, 0.90, 0.92);
  PlaceCamera(scene->Views[view], renderer);
  return true;
}

//------------------------------------------------------------------------------
bool SetView(const std::string& name, int view, vtkRenderer* renderer, std::string* error)
{
  const Scene* scene = CheckArguments(name, view, renderer, error);
  if (!scene)
  {
    return false;
  }
  PlaceCamera(scene->Views[view], renderer);
  return true;
}
}
