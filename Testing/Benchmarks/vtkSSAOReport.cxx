// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOReport.cxx
 * @brief  Speed against error: every method on every scene, against ray-traced truth.
 */

#include "vtkSSAOReportMethods.h"
#include "vtkSSAOReportPictures.h"
#include "vtkSSAOReportTable.h"
#include "vtkSSAOReportView.h"
#include "vtkSSAOScenes.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVersion.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
const char* const Help =
  "usage: vtkSSAOReport [quick] [options]\n"
  "\n"
  "Measures ambient occlusion methods on scenes: error against ray-traced truth, cost above plain\n"
  "rendering. Writes report.csv, report.json and PNG plots and sheets.\n"
  "\n"
  "  quick             one view of four scenes, fewer methods: under three minutes\n"
  "  --output DIR      where the files go (default: report)\n"
  "  --data DIR        the project's data directory\n"
  "  --cache DIR       where ray-traced images are kept (default: OUTPUT/truth)\n"
  "  --scenes A,B      only these scenes (--list names them)\n"
  "  --methods A,B     only methods whose name contains one of these; VTK's own are always there\n"
  "  --views N         views per scene, 1 or 2 (default: 1)\n"
  "  --size WxH        pixels, 16 to 4096 each way (default: 800x600, quick: 400x300)\n"
  "  --rays N          rays per pixel of the truth, 8 to 65536 (default: 256, quick: 64)\n"
  "  --rounds N        pairs of frames timed per method, 1 to 1000 (default: 3)\n"
  "  --commit TEXT     what is measured, for the report's facts\n"
  "  --fresh           measure everything again; without it an interrupted report is resumed\n"
  "  --list            list scenes and methods and stop\n"
  "  --help            this text\n";

//------------------------------------------------------------------------------
struct Options
{
  bool Quick = false;
  bool Fresh = false;
  bool List = false;
  bool Help = false;
  int Views = 1;
  std::string Output = "report";
  std::string Commit = "unknown";
  std::vector<std::string> Scenes;
  std::vector<std::string> Methods;
  vtkSSAOReportView::Settings View;
};

//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

//------------------------------------------------------------------------------
bool ParseInteger(const std::string& text, int low, int high, int& value)
{
  char* end = nullptr;
  const long parsed = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || parsed < low || parsed > high)
  {
    return false;
  }
  value = static_cast<int>(parsed);
  return true;
}

//------------------------------------------------------------------------------
bool ParseSize(const std::string& text, int& width, int& height)
{
  const std::size_t cross = text.find('x');
  return cross != std::string::npos && ParseInteger(text.substr(0, cross), 16, 4096, width) &&
    ParseInteger(text.substr(cross + 1), 16, 4096, height);
}

//------------------------------------------------------------------------------
// False with a message in error if the command line is wrong.
bool Parse(int argc, char* argv[], Options& options, std::string& error)
{
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "quick")
  {
    words.erase(words.begin());
    options.Quick = true;
    options.View.RaysPerPixel = 64;
    options.View.Width = 400;
    options.View.Height = 300;
    options.Scenes = { "long_wall", "sphere_pack", "living_room", "brain" };
  }
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const std::string& word = words[i];
    if (word == "--fresh" || word == "--list" || word == "--help")
    {
      options.Fresh = options.Fresh || word == "--fresh";
      options.List = options.List || word == "--list";
      options.Help = options.Help || word == "--help";
      continue;
    }
    const bool known = word == "--output" || word == "--data" || word == "--cache" ||
      word == "--scenes" || word == "--methods" || word == "--views" || word == "--size" ||
      word == "--rays" || word == "--rounds" || word == "--commit";
    if (!known || i + 1 == words.size())
    {
      error = known ? word + " needs a value" : "unknown option " + word;
      return false;
    }
    const std::string& value = words[++i];
    bool good = !value.empty();
    if (word == "--output")
    {
      options.Output = value;
    }
    else if (word == "--data")
    {
      options.View.DataDirectory = value;
    }
    else if (word == "--cache")
    {
      options.View.CacheDirectory = value;
    }
    else if (word == "--commit")
    {
      options.Commit = value;
    }
    else if (word == "--scenes")
    {
      options.Scenes = Split(value);
    }
    else if (word == "--methods")
    {
      options.Methods = Split(value);
    }
    else if (word == "--views")
    {
      good = ParseInteger(value, 1, 2, options.Views);
    }
    else if (word == "--size")
    {
      good = ParseSize(value, options.View.Width, options.View.Height);
    }
    else if (word == "--rays")
    {
      good = ParseInteger(value, 8, 65536, options.View.RaysPerPixel);
    }
    else
    {
      good = ParseInteger(value, 1, 1000, options.View.Rounds);
    }
    if (!good)
    {
      error = word + ": bad value " + value;
      return false;
    }
  }
  const std::vector<std::string> names = vtkSSAOScenes::Names();
  for (const std::string& scene : options.Scenes)
  {
    if (std::find(names.begin(), names.end(), scene) == names.end())
    {
      error = "--scenes: unknown scene " + scene;
      return false;
    }
  }
  if (options.Scenes.empty())
  {
    options.Scenes = names;
  }
  if (options.View.CacheDirectory.empty())
  {
    options.View.CacheDirectory = options.Output + "/truth";
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkSSAOReportMethod> ChooseMethods(const Options& options)
{
  std::vector<vtkSSAOReportMethod> methods = vtkSSAOReportMethods(options.Quick);
  const auto unwanted = [&options](const vtkSSAOReportMethod& method)
  {
    return !method.IsVTK && !options.Methods.empty() &&
      std::none_of(options.Methods.begin(), options.Methods.end(),
        [&method](const std::string& part) { return method.Name.find(part) != std::string::npos; });
  };
  methods.erase(std::remove_if(methods.begin(), methods.end(), unwanted), methods.end());
  return methods;
}

//------------------------------------------------------------------------------
void List()
{
  std::cout << "scenes:\n";
  for (const std::string& name : vtkSSAOScenes::Names())
  {
    const vtkSSAOScenes::Info& info = vtkSSAOScenes::GetInfo(name);
    std::cout << "  " << name << " (" << vtkSSAOScenes::KindName(info.SceneKind) << ", radius "
              << info.Radius << "): " << info.Description << "\n";
  }
  std::cout << "methods:\n";
  for (const vtkSSAOReportMethod& method : vtkSSAOReportMethods(false))
  {
    std::cout << "  " << method.Name << "\n";
  }
}

//------------------------------------------------------------------------------
// What the numbers were measured on.
std::vector<std::pair<std::string, std::string>> Facts(const Options& options)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  window->SetSize(16, 16);
  window->Render();
  std::istringstream report(window->ReportCapabilities());
  std::string driver = "unknown";
  for (std::string line; std::getline(report, line);)
  {
    const std::string key = "OpenGL renderer string:";
    if (line.compare(0, key.size(), key) == 0)
    {
      driver = line.substr(line.find_first_not_of(' ', key.size()));
    }
  }
  return { { "commit", options.Commit }, { "vtk", vtkVersion::GetVTKVersion() },
    { "opengl", driver }, { "processors", std::to_string(std::thread::hardware_concurrency()) },
    { "rays per pixel", std::to_string(options.View.RaysPerPixel) },
    { "frames per method", std::to_string(options.View.Rounds) } };
}

//------------------------------------------------------------------------------
bool WriteSheet(const vtkSSAOReportView& view, const Options& options, const std::string& name)
{
  std::vector<vtkSSAOReportPanel> panels;
  for (const char* method : { "VTK K=64", "Balanced", "Accurate" })
  {
    const std::vector<float> visibility = view.GetVisibility(method);
    if (!visibility.empty())
    {
      panels.push_back({ method, visibility });
    }
  }
  return vtkSSAOWriteSheet(name, options.View.Width, options.View.Height,
    view.GetTruth().Visibility, view.GetTruth().Hit, panels,
    options.Output + "/sheet_" + name + ".png");
}

//------------------------------------------------------------------------------
void PrintMeans(const std::vector<vtkSSAOReportRow>& means)
{
  std::printf("\n%-28s %8s %8s %8s %10s %10s %10s\n", "mean over all views", "RMSE", "bias", "p99",
    "cost/K=32", "cost/K=64", "cost/K=256");
  for (const vtkSSAOReportRow& row : means)
  {
    std::printf("%-28s %8.4f %+8.4f %8.4f %10.3f %10.3f %10.3f\n", row.Method.c_str(),
      row.RootMeanSquare, row.Bias, row.Percentile99, row.RatioToVTK32, row.RatioToVTK64,
      row.RatioToVTK256);
  }
  std::printf("\nCost: frame with the pass minus plain frame, median, as a ratio to VTK's pass.\n"
              "arithmetic_error and twin_error in the CSV are of raw V, before any denoiser.\n");
}

//------------------------------------------------------------------------------
// Plots from the rows there are. False if one cannot be written.
bool WriteSummary(const vtkSSAOReportTable& table, const Options& options)
{
  const std::vector<vtkSSAOReportRow> means = table.GetMeans();
  bool written = table.WriteJSON(options.Output + "/report.json", Facts(options)) &&
    vtkSSAOWriteErrorAgainstCost(
      means, "Mean over all scenes", options.Output + "/error_cost.png") &&
    vtkSSAOWriteErrorAgainstSamples(
      means, "Mean over all scenes", options.Output + "/error_samples.png");
  for (const std::string& scene : options.Scenes)
  {
    std::vector<vtkSSAOReportRow> rows;
    std::copy_if(table.GetRows().begin(), table.GetRows().end(), std::back_inserter(rows),
      [&scene](const vtkSSAOReportRow& row) { return row.Scene == scene && row.View == 0; });
    written = written &&
      vtkSSAOWriteErrorAgainstCost(rows, scene, options.Output + "/error_cost_" + scene + ".png");
  }
  PrintMeans(means);
  return written;
}

//------------------------------------------------------------------------------
int Run(const Options& options)
{
  if (!vtksys::SystemTools::MakeDirectory(options.Output))
  {
    std::cerr << "vtkSSAOReport: cannot make the folder " << options.Output << "\n";
    return EXIT_FAILURE;
  }
  const std::string csv = options.Output + "/report.csv";
  vtkSSAOReportTable table;
  if (!options.Fresh && vtksys::SystemTools::FileExists(csv) && !table.ReadCSV(csv))
  {
    std::cerr << "vtkSSAOReport: " << csv << " is damaged; --fresh starts anew\n";
    return EXIT_FAILURE;
  }
  const std::vector<vtkSSAOReportMethod> methods = ChooseMethods(options);

  std::vector<std::pair<std::string, int>> views;
  for (const std::string& scene : options.Scenes)
  {
    const int all = vtkSSAOScenes::GetInfo(scene).NumberOfViews;
    for (int view = 0; view < std::min(options.Views, all); ++view)
    {
      views.emplace_back(scene, view);
    }
  }

  const auto start = std::chrono::steady_clock::now();
  int measured = 0;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    const std::string& scene = views[i].first;
    const int view = views[i].second;
    const std::string name = scene + "_" + std::to_string(view);
    if (table.HasView(scene, view, options.View.Width, options.View.Height))
    {
      std::printf("[%zu/%zu] %s: measured before\n", i + 1, views.size(), name.c_str());
      continue;
    }
    vtkSSAOReportView report(scene, view, options.View);
    std::vector<vtkSSAOReportRow> rows;
    std::string error;
    if (!report.Prepare(error) || !report.Measure(methods, rows, error))
    {
      std::cerr << "vtkSSAOReport: " << name << ": " << error << "\n";
      return EXIT_FAILURE;
    }
    table.AddView(rows);
    if (!table.WriteCSV(csv) || !WriteSheet(report, options, name))
    {
      std::cerr << "vtkSSAOReport: cannot write into " << options.Output << "\n";
      return EXIT_FAILURE;
    }
    ++measured;
    const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("[%zu/%zu] %s done, %.0f s so far, about %.0f s left\n", i + 1, views.size(),
      name.c_str(), elapsed, elapsed / measured * (views.size() - i - 1));
    std::fflush(stdout);
  }
  if (!WriteSummary(table, options))
  {
    std::cerr << "vtkSSAOReport: cannot write into " << options.Output << "\n";
    return EXIT_FAILURE;
  }
  std::cout << "\nThe report is in " << options.Output << "\n";
  return EXIT_SUCCESS;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  Options options;
#ifdef SSAO_REPORT_DATA
  options.View.DataDirectory = SSAO_REPORT_DATA;
#endif
  std::string error;
  if (!Parse(argc, argv, options, error))
  {
    std::cerr << "vtkSSAOReport: " << error << " (--help lists the options)\n";
    return EXIT_FAILURE;
  }
  if (options.Help)
  {
    std::cout << Help;
    return EXIT_SUCCESS;
  }
  if (options.List)
  {
    List();
    return EXIT_SUCCESS;
  }
  return Run(options);
}
