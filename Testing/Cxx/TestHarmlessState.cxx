// SPDX-License-Identifier: BSD-3-Clause

// The pass leaves OpenGL as it found it, comes and goes without a trace, and keeps antialiasing.

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestOpenGL.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSequencePass.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <iostream>

namespace
{
using namespace vtkSSAOTest;

struct Value
{
  const char* Name;
  GLenum Id;
  int Size;
};

const Value Values[] = { { "blend", GL_BLEND, 1 }, { "depth test", GL_DEPTH_TEST, 1 },
  { "scissor test", GL_SCISSOR_TEST, 1 }, { "cull face", GL_CULL_FACE, 1 },
  { "stencil test", GL_STENCIL_TEST, 1 }, { "multisample", GL_MULTISAMPLE, 1 },
  { "polygon offset", GL_POLYGON_OFFSET_FILL, 1 }, { "viewport", GL_VIEWPORT, 4 },
  { "scissor box", GL_SCISSOR_BOX, 4 }, { "depth mask", GL_DEPTH_WRITEMASK, 1 },
  { "depth function", GL_DEPTH_FUNC, 1 }, { "colour mask", GL_COLOR_WRITEMASK, 4 },
  { "source blend", GL_BLEND_SRC_RGB, 1 }, { "destination blend", GL_BLEND_DST_RGB, 1 },
  { "source alpha blend", GL_BLEND_SRC_ALPHA, 1 },
  { "destination alpha blend", GL_BLEND_DST_ALPHA, 1 },
  { "blend equation", GL_BLEND_EQUATION_RGB, 1 },
  { "alpha blend equation", GL_BLEND_EQUATION_ALPHA, 1 },
  { "draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1 },
  { "read framebuffer", GL_READ_FRAMEBUFFER_BINDING, 1 }, { "draw buffer 0", GL_DRAW_BUFFER0, 1 },
  { "draw buffer 1", GL_DRAW_BUFFER1, 1 }, { "draw buffer 2", GL_DRAW_BUFFER2, 1 },
  { "draw buffer 3", GL_DRAW_BUFFER3, 1 }, { "read buffer", GL_READ_BUFFER, 1 },
  { "unpack alignment", GL_UNPACK_ALIGNMENT, 1 } };
constexpr std::size_t NumberOfValues = sizeof(Values) / sizeof(Values[0]);

using State = std::array<std::array<int, 4>, NumberOfValues>;

//------------------------------------------------------------------------------
// Notes the state of OpenGL itself after its delegate has drawn.
class StatePass : public vtkImageProcessingPass
{
public:
  static StatePass* New() { VTK_STANDARD_NEW_BODY(StatePass); }
  vtkTypeMacro(StatePass, vtkImageProcessingPass);
  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    window->GetState()->vtkglBlendEquation(this->BlendEquation);
    this->DelegatePass->Render(s);
    using GetFunction = void (*)(GLenum, GLint*);
    const auto get = reinterpret_cast<GetFunction>(vtkSSAOFindOpenGL("glGetIntegerv"));
    for (std::size_t i = 0; i < NumberOfValues; ++i)
    {
      this->After[i] = {};
      get(Values[i].Id, this->After[i].data());
    }
    this->Attachments =
      static_cast<int>(window->GetRenderFramebuffer()->GetNumberOfColorAttachments());
    this->CachedBlend = window->GetState()->GetEnumState(GL_BLEND);
    this->CachedDepthTest = window->GetState()->GetEnumState(GL_DEPTH_TEST);
    window->GetState()->vtkglBlendEquation(GL_FUNC_ADD);
  }
  GLenum BlendEquation = GL_FUNC_ADD;
  State After = {};
  int Attachments = 0;
  int CachedBlend = 0;
  int CachedDepthTest = 0;

protected:
  StatePass() = default;
  ~StatePass() override = default;

private:
  StatePass(const StatePass&) = delete;
  void operator=(const StatePass&) = delete;
};

//------------------------------------------------------------------------------
void CheckOpenGL(Report& report, int multiSamples, GLenum blendEquation)
{
  Stage stage(report, 80, 60, multiSamples);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 9, 0.5);
  const auto draw = [&](vtkRenderPass* inner)
  {
    auto probe = vtkSmartPointer<StatePass>::New();
    probe->SetDelegatePass(inner);
    probe->BlendEquation = blendEquation;
    vtkNew<vtkLightsPass> lights;
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(lights);
    passes->AddItem(probe);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    stage.Draw(camera);
    stage.Renderer->SetPass(nullptr);
    return probe;
  };
  const auto compare =
    [&](const std::string& name, const StatePass* expected, const StatePass* actual)
  {
    for (std::size_t i = 0; i < NumberOfValues; ++i)
    {
      for (int j = 0; j < Values[i].Size; ++j)
      {
        if (expected->After[i][j] != actual->After[i][j])
        {
          report.Equal(name + Values[i].Name, expected->After[i][j], actual->After[i][j]);
        }
      }
    }
    report.Expect(expected->After == actual->After, name + "the state of OpenGL is left alone");
    report.Equal(name + "attachments", expected->Attachments, actual->Attachments);
    report.Equal(name + "VTK's idea of blending", actual->After[0][0], actual->CachedBlend);
    report.Equal(name + "VTK's idea of depth tests", actual->After[1][0], actual->CachedDepthTest);
  };
  const std::string samples = std::to_string(multiSamples) + " samples, blend equation " +
    std::to_string(blendEquation) + ", ";
  vtkNew<vtkOpaquePass> opaque;
  const vtkSmartPointer<StatePass> plain = draw(opaque);
  report.Expect(plain->After[7][2] > 0, samples + "OpenGL tells its viewport");
  for (const int mode : { AOPass::Composite, AOPass::Occlusion, AOPass::Unoccluded, AOPass::Depth })
  {
    vtkNew<AOPass> pass;
    pass->SetDelegatePass(opaque);
    pass->SetOutputMode(mode);
    compare(samples + "mode " + std::to_string(mode) + ", ", plain, draw(pass));
  }
  vtkNew<vtkRenderStepsPass> steps;
  const vtkSmartPointer<StatePass> plainSteps = draw(steps);
  vtkNew<AOPass> overSteps;
  overSteps->SetDelegatePass(steps);
  compare(samples + "over render steps, ", plainSteps, draw(overSteps));
}

//------------------------------------------------------------------------------
void CheckToggling(Report& report)
{
  Stage stage(report, 80, 60);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 9, 0.5);
  Grid grid(3);
  AddTranslucentProps(stage.Renderer, grid);
  vtkNew<AOPass> pass;
  const Picture plain = stage.Draw(nullptr);
  const Picture occluded = stage.Draw(pass);
  report.Differ("there is occlusion", plain, occluded, 0.1, 100);
  int plainChanges = 0;
  int occludedChanges = 0;
  for (int i = 0; i < 50; ++i)
  {
    plainChanges += stage.Draw(nullptr).Values == plain.Values ? 0 : 1;
    occludedChanges += stage.Draw(pass).Values == occluded.Values ? 0 : 1;
  }
  report.Equal("changes of the plain picture", 0, plainChanges);
  report.Equal("changes of the picture with occlusion", 0, occludedChanges);
  report.Equal("builds of programs after the first render", pass->GetNumberOfProgramBuilds(),
    [&]
    {
      stage.Draw(pass);
      return pass->GetNumberOfProgramBuilds();
    }());

  // Another pass each time.
  for (int i = 0; i < 5; ++i)
  {
    vtkNew<AOPass> other;
    report.Same("another pass", occluded, stage.Draw(other), 0.0);
    stage.Renderer->SetPass(nullptr);
    other->ReleaseGraphicsResources(stage.Window);
  }
}

//------------------------------------------------------------------------------
// Colour at silhouettes lies between surface and background, as without the pass.
void CheckAntialiasing(Report& report, int samples)
{
  // The window asks for so many samples; the driver may have fewer.
  Stage stage(report, 120, 120, samples);
  vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.5, 40));
  sphere->GetProperty()->SetAmbient(1.0);
  sphere->GetProperty()->SetDiffuse(0.0);
  stage.Renderer->AddActor(sphere);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  stage.Camera()->SetPosition(0.0, 0.0, 2.5);
  stage.Camera()->SetClippingRange(1.0, 4.0);
  const Picture plain = stage.Draw(nullptr);
  const std::string asked = std::to_string(samples) + " samples asked for, ";
  std::cout
    << asked << "the driver gives "
    << vtkOpenGLRenderWindow::SafeDownCast(stage.Window)->GetRenderFramebuffer()->GetMultiSamples()
    << std::endl;
  const Picture half = Picture::Of([](float value) { return 0.5 * value; }, plain);
  vtkNew<AOPass> pass;
  pass->SetModulationToAmbient();
  ForceVisibility(pass, 0.5);
  const Picture actual = stage.Draw(pass);
  int soft = 0;
  for (std::size_t i = 0; i < plain.Values.size(); i += 3)
  {
    soft += plain.Values[i] > 0.1F && plain.Values[i] < 0.9F ? 1 : 0;
  }
  report.ExpectAtLeast(soft, 100, asked + "antialiased pixels without the pass");
  // Half a step for either picture.
  report.Same(asked + "silhouettes at V 1/2", half, actual, 1.0 * Step);
  ForceVisibility(pass, 1.0);
  report.Same(asked + "V 1", plain, stage.Draw(pass), 0.0);
}
}

//------------------------------------------------------------------------------
int TestHarmlessState(int, char*[])
{
  Report report;
  CheckOpenGL(report, 0, GL_FUNC_ADD);
  CheckOpenGL(report, 4, GL_FUNC_ADD);
  CheckOpenGL(report, 0, GL_MAX);
  CheckToggling(report);
  for (const int samples : { 2, 4, 8, 16 })
  {
    CheckAntialiasing(report, samples);
  }
  return report.GetResult();
}
