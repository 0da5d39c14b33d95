// SPDX-License-Identifier: BSD-3-Clause

// Backgrounds of every kind stay as they are, alpha included.

#include "vtkSSAOTestHarmless.h"

#include "vtkSkybox.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// The alpha of the window and, for want of colour in it, the colours of the opaque pixels.
Picture DrawAlpha(Stage& stage, vtkRenderPass* pass)
{
  Picture picture = stage.Draw(pass);
  vtkNew<vtkUnsignedCharArray> rgba;
  stage.Window->GetRGBACharPixelData(0, 0, picture.Width - 1, picture.Height - 1, 1, rgba);
  for (vtkIdType i = 0; i < rgba->GetNumberOfTuples(); ++i)
  {
    picture.Values[3 * i] = rgba->GetValue(4 * i + 3) / 255.0F;
  }
  return picture;
}
}

//------------------------------------------------------------------------------
int TestHarmlessBackgrounds(int, char*[])
{
  Report report;
  HarmlessOptions bare;
  bare.Changed = 0;
  CheckHarmless(
    report, "background, one colour", [](Stage&) {}, bare);
  CheckHarmless(report, "background, gradient",
    [](Stage& stage)
    {
      stage.Renderer->GradientBackgroundOn();
      stage.Renderer->SetBackground2(0.9, 0.4, 0.2);
    });
  CheckHarmless(report, "background, texture",
    [](Stage& stage)
    {
      stage.Renderer->SetBackgroundTexture(MakeWavesTexture());
      stage.Renderer->TexturedBackgroundOn();
    });
  CheckHarmless(report, "background, skybox",
    [](Stage& stage)
    {
      SetEnvironment(stage.Renderer);
      vtkNew<vtkSkybox> sky;
      sky->SetTexture(stage.Renderer->GetEnvironmentTexture());
      sky->SetProjectionToSphere();
      stage.Renderer->AddActor(sky);
    });
  HarmlessOptions transparent;
  transparent.Draw = DrawAlpha;
  for (const int samples : { 0, 4 })
  {
    transparent.MultiSamples = samples;
    CheckHarmless(
      report, "background, transparent, " + std::to_string(samples) + " samples",
      [](Stage& stage)
      {
        stage.Window->AlphaBitPlanesOn();
        stage.Renderer->SetBackgroundAlpha(0.0);
        vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.6));
        glass->SetPosition(2.6, 1.0, 0.5);
        glass->GetProperty()->SetOpacity(0.4);
        stage.Renderer->AddActor(glass);
      },
      transparent);
  }
  return report.GetResult();
}
