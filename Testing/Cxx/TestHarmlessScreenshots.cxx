// SPDX-License-Identifier: BSD-3-Clause

// Screenshots by every means of VTK: magnified in tiles, with alpha, of the depth, in stereo. With
// V 1 they are those without the pass; with occlusion the tiles join without a seam.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"

#include "vtkRenderLargeImage.h"
#include "vtkWindowToImageFilter.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
Picture FromImage(vtkImageData* image)
{
  Picture picture;
  const int* size = image->GetDimensions();
  picture.Width = size[0];
  picture.Height = size[1];
  const int components = image->GetNumberOfScalarComponents();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int i = 0; i < 3; ++i)
      {
        // One component: depth; four: alpha in place of blue.
        const int component = components == 1 ? 0 : (components == 4 && i == 2 ? 3 : i);
        picture.Values.push_back(static_cast<float>(
          image->GetScalarComponentAsDouble(x, y, 0, component) / (components == 1 ? 1.0 : 255.0)));
      }
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
// The window by vtkWindowToImageFilter, magnified.
Picture Shoot(Stage& stage, vtkRenderPass* pass, int scale, int type)
{
  stage.Renderer->SetPass(pass);
  stage.Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(stage.Window);
  filter->SetScale(scale);
  filter->SetInputBufferType(type);
  filter->ReadFrontBufferOff();
  filter->Update();
  return FromImage(filter->GetOutput());
}

//------------------------------------------------------------------------------
Picture ShootLarge(Stage& stage, vtkRenderPass* pass)
{
  stage.Renderer->SetPass(pass);
  stage.Render();
  vtkNew<vtkRenderLargeImage> filter;
  filter->SetInput(stage.Renderer);
  filter->SetMagnification(3);
  filter->Update();
  return FromImage(filter->GetOutput());
}

//------------------------------------------------------------------------------
void CheckStereo(Report& report)
{
  const struct
  {
    const char* Name;
    int Type;
  } types[] = { { "red and blue", VTK_STEREO_RED_BLUE }, { "anaglyph", VTK_STEREO_ANAGLYPH },
    { "interlaced", VTK_STEREO_INTERLACED }, { "left", VTK_STEREO_LEFT },
    { "right", VTK_STEREO_RIGHT }, { "checkerboard", VTK_STEREO_CHECKERBOARD },
    { "side by side", VTK_STEREO_SPLITVIEWPORT_HORIZONTAL } };
  for (const auto& type : types)
  {
    HarmlessOptions options;
    // Colours mix, or eyes show different pixels of the surfaces.
    options.OnlySurfaces = false;
    options.Changed = type.Type == VTK_STEREO_LEFT || type.Type == VTK_STEREO_RIGHT ? 0 : 20;
    CheckHarmless(
      report, std::string("stereo, ") + type.Name,
      [&](Stage& stage)
      {
        stage.Window->SetStereoCapableWindow(1);
        stage.Window->SetStereoType(type.Type);
        stage.Window->StereoRenderOn();
      },
      options);
  }
}

//------------------------------------------------------------------------------
// Both eyes are drawn in one frame, by one pass: each has the occlusion that it has alone.
void CheckEyes(Report& report)
{
  Stage stage(report, 120, 90);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 9, 0.5);
  stage.Window->SetStereoCapableWindow(1);
  stage.Window->StereoRenderOn();
  vtkNew<AOPass> pass;
  pass->SetRadius(0.8);
  const auto draw = [&](int type)
  {
    stage.Window->SetStereoType(type);
    return stage.Draw(pass);
  };
  const Picture left = draw(VTK_STEREO_LEFT);
  const Picture right = draw(VTK_STEREO_RIGHT);
  report.Differ("eyes, there is occlusion", left, stage.Draw(nullptr), 0.1, 100);
  report.Differ("eyes see different pictures", left, right, 0.1, 50);
  const Picture both = draw(VTK_STEREO_INTERLACED); // a row for each in turn
  int rows = 0;
  for (int y = 0; y < both.Height; ++y)
  {
    const Picture& eye = y % 2 ? right : left;
    rows += std::equal(both.At(0, y), both.At(0, y) + std::ptrdiff_t(3) * both.Width, eye.At(0, y));
  }
  report.Equal("rows as their eye sees them alone", both.Height, rows);
  stage.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Occlusion in a magnified picture is that in a window of the size, seams included.
void CheckSeams(Report& report, bool parallel, int preset)
{
  constexpr int scale = 3;
  const auto build = [&](Stage& stage)
  {
    vtkSSAOAddFloorAndSpheres(stage.Renderer, 9, 0.5);
    stage.Camera()->SetParallelProjection(parallel);
    stage.Camera()->SetParallelScale(2.2);
  };
  vtkNew<AOPass> pass;
  const auto choose = [&]
  {
    preset == 0 ? pass->SetQualityToFast()
                : (preset == 1 ? pass->SetQualityToBalanced() : pass->SetQualityToAccurate());
    pass->SetRadius(0.8);
    pass->SetIntensity(2.0);
  };
  choose();
  Stage tiled(report, 100, 80);
  build(tiled);
  const Picture tiles = Shoot(tiled, pass, scale, VTK_RGB);
  const Picture plain = Shoot(tiled, nullptr, scale, VTK_RGB);
  Stage whole(report, 100 * scale, 80 * scale);
  build(whole);
  const Picture expected = whole.Draw(pass);
  const Picture plainWhole = whole.Draw(nullptr);
  const std::string name =
    std::string(parallel ? "parallel, preset " : "preset ") + std::to_string(preset);
  report.Differ(name + ", there is occlusion", plain, tiles, 0.1, 1000);

  // The difference from the whole picture beside the seams, and elsewhere, away from the border.
  double sums[2] = {};
  int counts[2] = {};
  int worst = 0;
  for (int y = 12; y < expected.Height - 12; ++y)
  {
    for (int x = 12; x < expected.Width - 12; ++x)
    {
      const int toSeam =
        std::min({ std::abs(x - 100), std::abs(x - 200), std::abs(y - 80), std::abs(y - 160) });
      const double difference = DifferenceAt(expected, tiles, x, y);
      sums[toSeam < 10] += difference;
      ++counts[toSeam < 10];
      // VTK itself draws some silhouettes otherwise in tiles.
      if (DifferenceAt(plainWhole, plain, x, y) == 0.0)
      {
        worst = std::max(worst, static_cast<int>(std::lround(255.0 * difference)));
      }
    }
  }
  const double away = sums[0] / counts[0] * 255.0;
  const double beside = sums[1] / counts[1] * 255.0;
  std::cout << name << ": mean difference away from seams " << away << "/255, beside them "
            << beside << "/255, largest " << worst << "/255" << std::endl;
  // Noise starts anew in each tile, so that V differs by what of it the denoiser leaves.
  report.ExpectAtMost(away, 1.0, name + ", mean difference away from the seams, in 1/255");
  // The same, at Intensity 2.
  report.ExpectAtMost(worst, 8, name + ", largest difference in 1/255");
  report.ExpectAtMost(beside, away + 0.25, name + ", mean difference beside the seams, in 1/255");
}
}

//------------------------------------------------------------------------------
int TestHarmlessScreenshots(int, char*[])
{
  Report report;
  HarmlessOptions options;
  options.Width = 100;
  options.Height = 80;
  const auto build = [](Stage& stage)
  {
    Grid grid(3);
    AddTranslucentProps(stage.Renderer, grid);
    AddAnnotations(stage.Renderer, grid);
  };
  options.Draw = [](Stage& stage, vtkRenderPass* pass) { return Shoot(stage, pass, 3, VTK_RGB); };
  CheckHarmless(report, "screenshot of 3 x 3 tiles", build, options);
  options.Draw = ShootLarge;
  CheckHarmless(report, "vtkRenderLargeImage, 3 x 3 tiles", build, options);
  options.Draw = [](Stage& stage, vtkRenderPass* pass) { return Shoot(stage, pass, 1, VTK_RGBA); };
  CheckHarmless(report, "screenshot with alpha", build, options);
  options.OnlySurfaces = false; // surfaces have a depth of any colour
  options.Changed = 0;          // and what is there draws none
  options.Draw = [](Stage& stage, vtkRenderPass* pass)
  { return Shoot(stage, pass, 1, VTK_ZBUFFER); };
  CheckHarmless(report, "depth buffer", build, options);
  CheckStereo(report);
  CheckEyes(report);
  CheckSeams(report, false, 0);
  CheckSeams(report, false, 1);
  CheckSeams(report, false, 2);
  CheckSeams(report, true, 1);
  return report.GetResult();
}
