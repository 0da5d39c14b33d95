// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a mesh, molecule, point cloud, set of lines, height field or volume contour from a file,
 * without ambient occlusion, with it, and the occlusion alone, and writes the pictures as PNGs.
 *
 * Run() is the program; RenderMesh/ has what it needs to read options and files.
 */
#include "RenderMesh/CommandLine.h"
#include "RenderMesh/Framing.h"
#include "RenderMesh/MeshFile.h"
#include "RenderMesh/Messages.h"
#include "RenderMesh/Scene.h"
#include "RenderMesh/Settings.h"

#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScreenSpaceAmbientOcclusionPass.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace rendermesh
{
namespace
{
namespace fs = std::filesystem;
using Pass = vtkScreenSpaceAmbientOcclusionPass;

const Choices Qualities = { { "fast", 0 }, { "balanced", 1 }, { "accurate", 2 } };
const Choices Estimators = { { "crytek-sphere", Pass::CrytekSphere },
  { "position-sphere", Pass::PositionSphere }, { "depth-sphere", Pass::DepthSphere },
  { "hemisphere", Pass::Hemisphere }, { "hemisphere-linear-depth", Pass::HemisphereLinearDepth },
  { "reflected-hemisphere", Pass::ReflectedHemisphere }, { "horizon-angle", Pass::HorizonAngle },
  { "exact-horizon", Pass::ExactHorizon }, { "layered-bitmask", Pass::LayeredBitmask } };
const Choices Denoisers = { { "none", Pass::None }, { "box", Pass::Box },
  { "box-centered", Pass::BoxCentered }, { "separable-gaussian", Pass::SeparableGaussian },
  { "edge-aware", Pass::EdgeAware } };
const Choices Falloffs = { { "power", Pass::PowerFalloff },
  { "null-square", Pass::NullSquareFalloff }, { "inverse-square", Pass::InverseSquareFalloff } };
const Choices Switches = { { "off", 0 }, { "on", 1 } };
const Choices Modulations = { { "ambient", Pass::Ambient },
  { "ambient-and-diffuse", Pass::AmbientAndDiffuse }, { "all", Pass::All } };
const Choices OutputModes = { { "composite", Pass::Composite }, { "occlusion", Pass::Occlusion },
  { "unoccluded", Pass::Unoccluded }, { "normal", Pass::Normal }, { "depth", Pass::Depth } };

//------------------------------------------------------------------------------ options

std::vector<Option> PictureOptions(Settings& s)
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
  const auto setMode = [&s](int mode) { s.OutputMode = mode; };
  return {
    { "Pictures", "", {}, "", "" },
    { "--folder", "DIR", String(s.Folder), "Where they go; made if missing.", "this folder" },
    { "--prefix", "NAME", String(s.Prefix), "What their names begin with.", "the file's name" },
    { "--output", "MODE", Choice(OutputModes, setMode),
      "Write this picture only, as NAME_MODE.png.",
      "NAME_without, NAME_with, NAME_ao and NAME_sheet, which shows the three side by side" },
    { "--size", "WxH", { "each 16 to 8192", setSize }, "Size of a picture, pixels.", "800x600" },
    { "--multisamples", "N", Whole(0, 16, s.MultiSamples),
      "Samples per pixel of OpenGL's antialiasing; 0 is off.", "0" },
    { "--supersample", "N", Whole(1, 4, s.Supersample),
      "Draw N times as wide and high, and average.", "1" },
    { "--frames", "N", Whole(0, 1000, s.Frames),
      "Draw N more frames without and N with ambient occlusion, and print the median times.", "0" },
    { "--quiet", "", Switch(s.Quiet), "Print only warnings, errors and the times of --frames.",
      "" },
    { "--help", "", Switch(s.Help), "Print this text.", "" },
  };
}

std::vector<Option> ViewOptions(Settings& s)
{
  const auto setLook = [&s](const vtkVector3d& v) { s.Look = v; };
  const auto setUp = [&s](const vtkVector3d& v) { s.Up = v; };
  const auto setPosition = [&s](const vtkVector3d& v) { s.Position = v; };
  const auto setBackground = [&s](const vtkVector3d& v) { s.Background = v; };
  return {
    { "View", "", {}, "", "" },
    { "--look", "X,Y,Z", Direction(setLook), "Direction in which the camera looks.",
      "-0.5,0.8,-0.5; glTF -0.5,-0.5,-0.8" },
    { "--up", "X,Y,Z", Direction(setUp), "Direction that is up in the picture.",
      "0,0,1; glTF 0,1,0" },
    { "--position", "X,Y,Z", Vector(-Infinity, Infinity, setPosition),
      "Where the camera is, world units.", "so that all is in the picture" },
    { "--zoom", "F", Number(0.01, 100.0, s.Zoom), "Magnifies the middle of the picture.", "1" },
    { "--view-angle", "DEG", Number(1.0, 150.0, s.ViewAngle),
      "Angle from the picture's bottom to its top, degrees.", "30" },
    { "--parallel", "", Switch(s.Parallel), "Parallel instead of perspective projection.", "" },
    { "--background", "R,G,B", Vector(0.0, 1.0, setBackground), "Colour behind the mesh.",
      "1,1,1" },
  };
}

std::vector<Option> MeshOptions(Settings& s)
{
  const auto setColor = [&s](const vtkVector3d& v) { s.Color = v; };
  const auto setContour = [&s](double v) { s.Contour = v; };
  return {
    { "Mesh", "", {}, "", "" },
    { "--color", "R,G,B", Vector(0.0, 1.0, setColor), "Colour of the mesh.",
      "the file's own or the chemical elements', else 0.85,0.83,0.8" },
    { "--color-by", "ARRAY", String(s.ColorBy), "Colour by this point or cell array.", "" },
    { "--scalars", "ARRAY", String(s.Scalars), "Array for --contour and for height fields.",
      "the file's active or first one" },
    { "--contour", "V", Number(-Infinity, Infinity, setContour),
      "Draw the surface where the scalars are V.",
      "for a 3D image the middle of their range, else no contour" },
    { "--warp-scale", "F", Number(-Infinity, Infinity, s.WarpScale),
      "Height of a 2D image: world units per unit of its scalars; 0 is automatic, a relief of "
      "0.15 of the longer side.",
      "0" },
    { "--point-radius", "R", Number(0.0, Infinity, s.PointRadius),
      "Radius of points, world units; 0 is automatic, for atoms the van der Waals radius.", "0" },
    { "--tube-radius", "R", Number(0.0, Infinity, s.TubeRadius),
      "Radius of lines, world units; 0 is automatic, 0.004 of the diagonal.", "0" },
    { "--feature-angle", "DEG", Number(0.0, 180.0, s.FeatureAngle),
      "Edges sharper than this stay sharp in files without normals, degrees; 0 shows all facets.",
      "30" },
    { "--ambient", "F", Number(0.0, 1.0, s.Ambient), "Ambient part of the material.", "0.3" },
    { "--diffuse", "F", Number(0.0, 1.0, s.Diffuse), "Diffuse part of the material.", "0.7" },
    { "--specular", "F", Number(0.0, 1.0, s.Specular), "Specular part of the material.", "0" },
  };
}

/// One for each parameter of the pass. The preset is first, because it sets others.
std::vector<Option> PassOptions(Pass* pass)
{
  const auto setQuality = [=](int level)
  {
    level == 0     ? pass->SetQualityToFast()
      : level == 1 ? pass->SetQualityToBalanced()
                   : pass->SetQualityToAccurate();
  };
  const auto setBias = [=](const std::string& text) {
    text == "auto" ? pass->SetBiasToAutomatic() : pass->SetBias(ParseNumber(text, 0.0, Infinity));
  };
  const std::string preset = "by --quality";
  return {
    { "Ambient occlusion", "", {}, "", "" },
    { "--quality", "NAME", Choice(Qualities, setQuality),
      "Preset of estimator, samples, layers and denoiser; each may be changed.", "balanced" },
    { "--estimator", "NAME", Choice(Estimators, [=](int e) { pass->SetEstimator(e); }),
      "How ambient visibility is estimated.", preset },
    { "--radius", "R", Number(0.0, Infinity, [=](double r) { pass->SetRadius(r); }),
      "Distance within which geometry occludes, world units; 0 is automatic, a tenth of the "
      "diagonal.",
      Text(pass->GetRadius()) },
    { "--kernel-size", "N", Whole(1, 1024, [=](int n) { pass->SetKernelSize(n); }),
      "Samples per pixel; where there are directions, as directions and steps.",
      Text(pass->GetKernelSize()) },
    { "--directions", "N", Whole(1, 64, [=](int n) { pass->SetDirections(n); }),
      "Directions about a pixel, with horizon-angle, or slices, with exact-horizon and "
      "layered-bitmask.",
      preset },
    { "--steps", "N", Whole(1, 64, [=](int n) { pass->SetSteps(n); }),
      "Samples in each direction or to either side of a slice.", preset },
    { "--layers", "N", Whole(1, 9, [=](int n) { pass->SetLayers(n); }),
      "Surfaces behind each other that are known, with layered-bitmask.", preset },
    { "--thickness", "T", Number(0.0, Infinity, [=](double t) { pass->SetThickness(t); }),
      "Thickness of every surface, world units, with layered-bitmask; 0: from the layers.",
      Text(pass->GetThickness()) },
    { "--angle-bias", "DEG", Number(0.0, 89.0, [=](double a) { pass->SetAngleBias(a); }),
      "Elevation below which nothing occludes, degrees, with horizon-angle.",
      Text(pass->GetAngleBias()) },
    { "--half-rule", "NAME", Choice(Switches, [=](int on) { pass->SetHalfRule(on != 0); }),
      "Whether only what is hidden beyond one half counts, with crytek-sphere.", "on" },
    { "--range-check", "NAME", Choice(Switches, [=](int on) { pass->SetRangeCheck(on != 0); }),
      "Whether surfaces farther in front than the radius count less.", "on" },
    { "--minimum-difference", "F",
      Number(0.0, 1.0, [=](double f) { pass->SetMinimumDifference(f); }),
      "Depth by which an occluder lies in front, radii, with reflected-hemisphere.",
      Text(pass->GetMinimumDifference()) },
    { "--attenuation", "F", Number(0.01, 100.0, [=](double f) { pass->SetAttenuation(f); }),
      "Above 1 far occluders count more, with reflected-hemisphere.",
      Text(pass->GetAttenuation()) },
    { "--falloff", "NAME", Choice(Falloffs, [=](int f) { pass->SetFalloff(f); }),
      "How the weight falls with distance, with reflected-hemisphere.",
      NameOf(Falloffs, pass->GetFalloff()) },
    { "--noise-size", "N", Whole(1, 64, [=](int n) { pass->SetNoiseSize(n); }),
      "Edge of the tile of random rotations, pixels.", preset },
    { "--downsampling", "N", Whole(1, 4, [=](int n) { pass->SetDownsampling(n); }),
      "One pixel of N x N is estimated, the others interpolated, with edge-aware.", preset },
    { "--layer-downsampling", "N", Whole(1, 4, [=](int n) { pass->SetLayerDownsampling(n); }),
      "Layers are looked for at one pixel of N x N.", preset },
    { "--bias", "B", { "0 or more, or auto", setBias },
      "How far a surface lies in front of a sample that it hides, world units; auto is 0.05 of "
      "the radius for hemisphere, else 0.",
      "auto" },
    { "--denoiser", "NAME", Choice(Denoisers, [=](int d) { pass->SetDenoiser(d); }),
      "How the noise of the estimate is removed.", preset },
    { "--modulation", "NAME", Choice(Modulations, [=](int m) { pass->SetModulation(m); }),
      "Which part of the light is taken away.", NameOf(Modulations, pass->GetModulation()) },
    { "--intensity", "F", Number(0.0, 10.0, [=](double f) { pass->SetIntensity(f); }),
      "Strength of the effect; 0 is none.", Text(pass->GetIntensity()) },
    { "--power", "F", Number(0.01, 16.0, [=](double f) { pass->SetPower(f); }),
      "Exponent of the visibility, for contrast.", Text(pass->GetPower()) },
    { "--intensity-scale", "F", Number(0.0, 10.0, [=](double f) { pass->SetIntensityScale(f); }),
      "Multiplies the occlusion, as in vtkSSAOPass.", Text(pass->GetIntensityScale()) },
    { "--intensity-shift", "F", Number(-1.0, 1.0, [=](double f) { pass->SetIntensityShift(f); }),
      "Is taken from the occlusion before it is scaled, as in vtkSSAOPass.",
      Text(pass->GetIntensityShift()) },
  };
}

void PrintHelp(const std::vector<Option>& options)
{
  std::cout << "Usage: RenderMesh [options] FILE\n\n";
  PrintWrapped("Draws FILE without ambient occlusion, with it, and the occlusion alone, and "
               "writes the pictures as PNGs. World units are the units of the file. An error is "
               "one line on stderr and exit code 1, and then no picture is written.",
    0);
  std::cout << "\n";
  PrintWrapped("FILE is one of " + KnownExtensions() +
      ". Polygons and the surfaces of grids are drawn as they are, lines as tubes, points and "
      "atoms "
      "as spheres, 2D images as height fields, 3D images as contours.",
    0);
  PrintOptions(options);
}

//------------------------------------------------------------------------------ render

/// A finished picture, and what its file name ends with.
struct Picture
{
  std::string Suffix;
  vtkSmartPointer<vtkImageData> Image;
};

void OpenWindow(const Settings& settings, Scene& scene)
{
  if (std::strcmp(scene.Window->GetClassName(), "vtkXOpenGLRenderWindow") == 0 &&
    !std::getenv("DISPLAY"))
  {
    throw Failure("this VTK draws through an X server only, and DISPLAY is not set: use xvfb-run, "
                  "or build the target vtkSSAOPass::OSMesa");
  }
  scene.Window->SetOffScreenRendering(1);
  scene.Window->SetMultiSamples(settings.MultiSamples);
  scene.Window->SetSize(
    settings.Size[0] * settings.Supersample, settings.Size[1] * settings.Supersample);
  scene.Renderer->SetBackground(
    settings.Background[0], settings.Background[1], settings.Background[2]);
  scene.Window->AddRenderer(scene.Renderer);
}

Picture TakePicture(const std::string& suffix, const Settings& settings, Scene& scene)
{
  scene.Window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.Window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(grab->GetOutputPort());
  average->SetShrinkFactors(settings.Supersample, settings.Supersample, 1);
  average->MeanOn();
  average->Update();
  CheckMessages("drawing failed");
  return { suffix, average->GetOutput() };
}

/// The median time of a frame, in milliseconds, after a first one that is not counted.
double TimeFrames(int frames, vtkRenderWindow* window)
{
  std::vector<double> times;
  for (int i = 0; i <= frames; ++i)
  {
    const double start = Seconds();
    window->Render();
    window->WaitForCompletion();
    times.push_back(1000.0 * (Seconds() - start));
  }
  times.erase(times.begin());
  std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
  return times[frames / 2];
}

/// Three pictures side by side, with a caption below each.
Picture MakeSheet(const std::vector<Picture>& pictures)
{
  const char* captions[3] = { "without", "with ambient occlusion", "ambient visibility" };
  const int* size = pictures.front().Image->GetDimensions();
  const int gap = std::max(2, size[0] / 200);
  const int strip = std::max(14, size[1] / 18);
  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(3 * size[0] + 2 * gap, size[1] + strip, 1);
  sheet->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memset(sheet->GetScalarPointer(), 255, sheet->GetNumberOfPoints() * 3);
  vtkNew<vtkTextProperty> font;
  font->SetColor(0.0, 0.0, 0.0);
  font->SetFontSize(strip * 6 / 10);
  for (int i = 0; i < 3; ++i)
  {
    const int left = i * (size[0] + gap);
    for (int y = 0; y < size[1]; ++y)
    {
      std::memcpy(sheet->GetScalarPointer(left, strip + y, 0),
        pictures[i].Image->GetScalarPointer(0, y, 0), 3 * size[0]);
    }
    vtkNew<vtkImageData> text;
    int extent[2] = { 0, 0 };
    if (!vtkTextRenderer::GetInstance() ||
      !vtkTextRenderer::GetInstance()->RenderString(font, captions[i], text, extent, 72))
    {
      throw Failure("cannot draw the captions");
    }
    const int x0 = left + std::max(0, (size[0] - extent[0]) / 2);
    const int y0 = std::max(0, (strip - extent[1]) / 2);
    for (int y = 0; y < std::min(extent[1], strip); ++y)
    {
      for (int x = 0; x < std::min(extent[0], size[0]); ++x)
      {
        const double cover = text->GetScalarComponentAsDouble(
          text->GetExtent()[0] + x, text->GetExtent()[2] + y, 0, 3);
        auto pixel = static_cast<unsigned char*>(sheet->GetScalarPointer(x0 + x, y0 + y, 0));
        std::fill_n(pixel, 3, static_cast<unsigned char>(255.0 - cover));
      }
    }
  }
  return { "sheet", sheet.Get() };
}

std::vector<Picture> RenderPictures(const Settings& settings, Scene& scene, Pass* pass)
{
  std::vector<Picture> pictures;
  if (settings.OutputMode)
  {
    pass->SetOutputMode(*settings.OutputMode);
    scene.Renderer->SetPass(pass);
    pictures.push_back(TakePicture(NameOf(OutputModes, *settings.OutputMode), settings, scene));
  }
  else
  {
    pictures.push_back(TakePicture("without", settings, scene));
    scene.Renderer->SetPass(pass);
    pictures.push_back(TakePicture("with", settings, scene));
    pass->SetOutputModeToOcclusion();
    pictures.push_back(TakePicture("ao", settings, scene));
    pictures.push_back(MakeSheet(pictures));
  }
  if (settings.Frames > 0)
  {
    pass->SetOutputModeToComposite();
    scene.Renderer->SetPass(nullptr);
    const double without = TimeFrames(settings.Frames, scene.Window);
    scene.Renderer->SetPass(pass);
    const double with = TimeFrames(settings.Frames, scene.Window);
    CheckMessages("drawing failed");
    std::cout << "median of " << settings.Frames << " frames: " << Text(without) << " ms without, "
              << Text(with) << " ms with ambient occlusion\n";
  }
  return pictures;
}

//------------------------------------------------------------------------------ write

/// Fails early where the pictures could not be written later.
void CheckFolder(const Settings& settings)
{
  const std::string failed = "cannot write to folder " + Quoted(settings.Folder) + ": ";
  if (settings.Prefix.find_first_of("/\\") != std::string::npos)
  {
    throw Failure("option --prefix: " + Quoted(settings.Prefix) + " is not a plain name");
  }
  std::error_code error;
  fs::path existing = fs::absolute(settings.Folder, error);
  while (!fs::exists(existing, error) && existing.has_parent_path() &&
    existing != existing.parent_path())
  {
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing, error))
  {
    throw Failure(failed + Quoted(existing.string()) + " is not a folder");
  }
  if (!vtksys::SystemTools::TestFileAccess(existing.string(), vtksys::TEST_FILE_WRITE))
  {
    throw Failure(failed + "no permission");
  }
}

/// Writes all pictures under temporary names, and renames them only when all are complete.
std::vector<std::string> WritePictures(
  const Settings& settings, const std::vector<Picture>& pictures)
{
  const std::string failed = "cannot write to folder " + Quoted(settings.Folder) + ": ";
  std::vector<std::string> names;
  try
  {
    fs::create_directories(settings.Folder);
    for (const Picture& picture : pictures)
    {
      const fs::path name =
        fs::path(settings.Folder) / (settings.Prefix + "_" + picture.Suffix + ".png");
      if (fs::is_directory(name))
      {
        throw Failure(failed + Quoted(name.string()) + " is a folder");
      }
      vtkNew<vtkPNGWriter> writer;
      writer->SetInputData(picture.Image);
      writer->WriteToMemoryOn();
      writer->Write();
      vtkUnsignedCharArray* bytes = writer->GetResult();
      names.push_back(name.string());
      std::ofstream file(name.string() + ".part", std::ios::binary);
      file.write(reinterpret_cast<char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
      file.close();
      if (!file)
      {
        throw Failure(failed + std::strerror(errno));
      }
    }
    for (const std::string& name : names)
    {
      fs::rename(name + ".part", name);
    }
  }
  catch (const std::exception& exception)
  {
    for (const std::string& name : names)
    {
      std::error_code ignored;
      fs::remove(name + ".part", ignored);
    }
    const auto system = dynamic_cast<const fs::filesystem_error*>(&exception);
    throw Failure(system ? failed + system->code().message() : exception.what());
  }
  return names;
}

//------------------------------------------------------------------------------ main

void Run(const std::vector<std::string>& words)
{
  Settings settings;
  vtkNew<Pass> pass;
  std::vector<Option> options;
  for (const auto& group :
    { PictureOptions(settings), ViewOptions(settings), MeshOptions(settings), PassOptions(pass) })
  {
    options.insert(options.end(), group.begin(), group.end());
  }
  const std::vector<std::string> files = ParseCommandLine(words, options);
  if (settings.Help)
  {
    PrintHelp(options);
    return;
  }
  if (files.size() != 1)
  {
    throw Failure(files.empty()
        ? "no file given; --help lists the options"
        : "more than one file: " + Quoted(files[0]) + " and " + Quoted(files[1]));
  }
  settings.Input = files[0];
  CheckInput(settings.Input);
  if (settings.Prefix.empty())
  {
    settings.Prefix = fs::path(settings.Input).stem().string();
  }
  CheckFolder(settings);

  Scene scene;
  OpenWindow(settings, scene);
  LoadScene(settings, scene);
  FrameScene(settings, scene);
  const std::vector<Picture> pictures = RenderPictures(settings, scene, pass);
  const std::vector<std::string> names = WritePictures(settings, pictures);
  if (!settings.Quiet)
  {
    std::cout << settings.Input << ": " << scene.Summary << "\n"
              << "radius: " << Text(pass->GetEffectiveRadius()) << " world units"
              << (pass->GetRadius() == 0.0 ? " (automatic)" : "") << "\n";
    for (const std::string& name : names)
    {
      std::cout << "wrote " << name << "\n";
    }
  }
}
}
}

int main(int argc, char* argv[])
{
  rendermesh::CollectMessages("RenderMesh");
  try
  {
    rendermesh::Run(std::vector<std::string>(argv + 1, argv + argc));
    return EXIT_SUCCESS;
  }
  catch (const std::bad_alloc&)
  {
    std::cerr << "RenderMesh: error: not enough memory\n";
  }
  catch (const std::exception& exception)
  {
    std::cerr << "RenderMesh: error: " << exception.what() << "\n";
  }
  return EXIT_FAILURE;
}
