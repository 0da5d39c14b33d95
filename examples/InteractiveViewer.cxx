// SPDX-License-Identifier: BSD-3-Clause
/**
 * A window with a mesh, or a scene of its own, in which keys and sliders change what the pass does.
 * With --script the events come from a file; with --picture the window is written as a PNG.
 *
 * InteractiveViewer/ has what is seen and done in the window; files are read as RenderMesh reads
 * them.
 */
#include "InteractiveViewer/Viewer.h"
#include "RenderMesh/CommandLine.h"
#include "RenderMesh/Framing.h"
#include "RenderMesh/MeshFile.h"
#include "RenderMesh/Messages.h"
#include "RenderMesh/Scene.h"
#include "RenderMesh/Settings.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace rendermesh;

struct Replay
{
  std::string Script;  // empty: the user's events
  std::string Picture; // empty: none
};

struct Quality
{
  int Preset = 2; // of viewer::GetPresets()
  double FrameRate = 15.0;
};

std::vector<Option> MakeOptions(Settings& s, Quality& quality, Replay& replay)
{
  const auto setSize = [&s](const std::string& text)
  {
    const size_t cross = text.find('x');
    if (cross == std::string::npos)
    {
      throw Failure("not WIDTHxHEIGHT");
    }
    s.Size[0] = ParseWhole(text.substr(0, cross), 16, 8192);
    s.Size[1] = ParseWhole(text.substr(cross + 1), 16, 8192);
  };
  const auto setLook = [&s](const vtkVector3d& v) { s.Look = v; };
  const auto setColor = [&s](const vtkVector3d& v) { s.Color = v; };
  Choices presets;
  for (const viewer::Preset& preset : viewer::GetPresets())
  {
    presets.emplace_back(
      vtksys::SystemTools::LowerCase(preset.Name), static_cast<int>(presets.size()));
  }
  return {
    { "Options", "", {}, "", "" },
    { "--size", "WxH", { "each 16 to 8192", setSize }, "Size of the window, pixels.", "800x600" },
    { "--look", "X,Y,Z", Direction(setLook), "Direction in which the camera looks at first.",
      "-0.5,0.8,-0.5; glTF -0.5,-0.5,-0.8" },
    { "--color", "R,G,B", Vector(0.0, 1.0, setColor), "Colour of the mesh.",
      "the file's own, else 0.85,0.83,0.8" },
    { "--quality", "NAME", Choice(presets, [&quality](int preset) { quality.Preset = preset; }),
      "Preset at first, while the camera stands still.", "accurate" },
    { "--frame-rate", "F", Number(0.001, 1e6, quality.FrameRate),
      "Frames per second to keep while the camera moves: by the preset fast, and by less where "
      "that "
      "takes too long.",
      "15" },
    { "--script", "FILE", String(replay.Script),
      "Play the events in FILE, which is as vtkInteractorEventRecorder writes it, and end.", "" },
    { "--picture", "FILE", String(replay.Picture),
      "Write the window as a PNG, after the script if there is one, and end.", "" },
    { "--help", "", Switch(s.Help), "Print this text.", "" },
  };
}

void AddShape(vtkRenderer* renderer, vtkAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  mapper->Update(); // to be framed
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->SetAmbient(0.3);
  actor->GetProperty()->SetDiffuse(0.7);
  renderer->AddActor(actor);
}

/// Columns of a staircase around a corner, with balls in front.
void AddStillLife(vtkRenderer* renderer)
{
  for (int i = 0; i < 10; ++i)
  {
    vtkNew<vtkCubeSource> step;
    const double x = i < 5 ? 0.0 : i - 4.0;
    const double y = i < 5 ? i : 5.0;
    step->SetBounds(x, x + 1.0, y, y + 1.0, 0.0, 0.3 * (i + 1));
    AddShape(renderer, step, 0.8, 0.75, 0.68);
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(48);
    ball->SetRadius(0.25 + 0.05 * i);
    ball->SetCenter(1.8 + 1.5 * (i % 3), 4.3 - 1.4 * (i / 3), 0.25 + 0.05 * i);
    AddShape(renderer, ball, 0.6, 0.7, 0.8);
  }
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(0.0, 6.0, -0.5, 6.0, -0.2, 0.0);
  AddShape(renderer, floor, 0.85, 0.83, 0.8);
}

void Run(const std::vector<std::string>& words)
{
  Settings settings;
  settings.Quiet = true;
  Quality quality;
  Replay replay;
  const std::vector<Option> options = MakeOptions(settings, quality, replay);
  const std::vector<std::string> files = ParseCommandLine(words, options);
  if (settings.Help)
  {
    std::cout << "Usage: InteractiveViewer [options] [FILE]\n\n";
    PrintWrapped("Shows FILE, or a scene of its own, with ambient occlusion. The window tells "
                 "which keys change what. FILE is one of " +
        KnownExtensions() + ".",
      0);
    PrintOptions(options);
    return;
  }
  if (files.size() > 1)
  {
    throw Failure("more than one file: " + Quoted(files[0]) + " and " + Quoted(files[1]));
  }
  if (!replay.Script.empty() && !std::ifstream(replay.Script))
  {
    throw Failure("cannot read " + Quoted(replay.Script));
  }

  Scene scene;
  if (std::strcmp(scene.Window->GetClassName(), "vtkXOpenGLRenderWindow") == 0 &&
    !std::getenv("DISPLAY"))
  {
    throw Failure("it needs an X server, and DISPLAY is not set");
  }
  scene.Window->SetWindowName("vtkSSAOPass");
  scene.Window->SetMultiSamples(0);
  scene.Window->SetSize(settings.Size[0], settings.Size[1]);
  scene.Renderer->SetBackground(1.0, 1.0, 1.0);
  scene.Window->AddRenderer(scene.Renderer);
  if (files.empty())
  {
    AddStillLife(scene.Renderer);
  }
  else
  {
    settings.Input = files[0];
    CheckInput(settings.Input);
    LoadScene(settings, scene);
  }
  FrameScene(settings, scene);

  viewer::Viewer viewer(scene.Window, scene.Renderer, quality.Preset, quality.FrameRate);
  viewer.Open();
  CheckMessages("drawing failed");
  if (!replay.Script.empty())
  {
    viewer.Play(replay.Script);
  }
  else if (replay.Picture.empty())
  {
    viewer.Interact();
  }
  CheckMessages("drawing failed");
  if (!replay.Picture.empty())
  {
    viewer.WritePicture(replay.Picture);
  }
  std::cout << viewer.GetState();
}
}

int main(int argc, char* argv[])
{
  rendermesh::CollectMessages("InteractiveViewer");
  try
  {
    Run(std::vector<std::string>(argv + 1, argv + argc));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& exception)
  {
    std::cerr << "InteractiveViewer: error: " << exception.what() << "\n";
  }
  return EXIT_FAILURE;
}
