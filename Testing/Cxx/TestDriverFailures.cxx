// SPDX-License-Identifier: BSD-3-Clause

// A driver that refuses a shader, lacks an extension or has no complete framebuffer: one error of
// the pass, and the plain scene. With resources released the pass tries again.

#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestOpenGL.h"
#include "vtkSSAOTestShapes.h"

#include <iostream>

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// OpenGL's functions as VTK calls them: through the pointers of its loader, GLEW or glad.
using ShaderSource = void (*)(unsigned int, int, const char* const*, const int*);
using CheckStatus = unsigned int (*)(unsigned int);

ShaderSource RealShaderSource = nullptr;
CheckStatus RealCheckStatus = nullptr;
std::string Broken;     // shaders with this text do not compile
int CompleteChecks = 0; // so many framebuffers are complete, then none

void BreakShaderSource(unsigned int shader, int count, const char* const* texts, const int* lengths)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += lengths ? std::string(texts[i], lengths[i]) : std::string(texts[i]);
  }
  // An extension is missing; other text becomes an error.
  const std::size_t at = text.find(Broken);
  if (at != std::string::npos)
  {
    Broken.find("GL_") == 0 ? text.replace(at, Broken.size(), "GL_ARB_none")
                            : text.append("\nthis is no shader\n");
  }
  const char* whole = text.c_str();
  RealShaderSource(shader, 1, &whole, nullptr);
}

unsigned int BreakCheckStatus(unsigned int target)
{
  constexpr unsigned int unsupported = 0x8CDD;
  return CompleteChecks-- > 0 ? RealCheckStatus(target) : unsupported;
}

//------------------------------------------------------------------------------
// Draws with something broken, and then with everything in order again.
void Check(Report& report, const std::string& name, int multiSamples,
  const std::function<void(AOPass*)>& set, const std::function<void(bool)>& breakIt)
{
  Stage stage(report, 80, 60, multiSamples);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
  const Picture plain = stage.Draw(nullptr);
  vtkNew<AOPass> pass;
  set(pass);
  const Picture occluded = [&]
  {
    vtkNew<AOPass> sound;
    set(sound);
    return stage.Draw(sound);
  }();
  report.Differ(name + ", there is occlusion", plain, occluded, 0.1, 50);

  // VTK keeps shaders that compiled: a new window has none.
  Stage broken(report, 80, 60, multiSamples);
  vtkSSAOAddFloorAndSpheres(broken.Renderer, 6, 0.45);
  broken.Draw(nullptr);
  {
    vtkSSAOErrorObserver observer(pass);
    report.SetListening(false); // VTK prints the shader
    breakIt(true);
    const Picture first = broken.Draw(pass);
    const Picture second = broken.Draw(pass);
    const Picture third = broken.Draw(pass);
    breakIt(false);
    report.SetListening(true);
    report.Same(name + ", first frame", plain, first, 0.0);
    report.Same(name + ", second frame", plain, second, 0.0);
    report.Same(name + ", third frame", plain, third, 0.0);
    report.Equal(name + ", errors", 1, observer.GetErrors());
    report.Equal(name + ", warnings", 0, observer.GetWarnings());
    report.Expect(observer.GetText().find("could not be built") != std::string::npos,
      name + ", the error says what is wrong");
  }
  broken.Renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(broken.Window);
  broken.Window->Finalize(); // with the shaders that did not compile
  report.Same(name + ", in order again", occluded, broken.Draw(pass), 0.0);
}
}

//------------------------------------------------------------------------------
int TestDriverFailures(int, char*[])
{
  Report report;
  {
    // The pointers are there once a window has rendered.
    Stage stage(report, 20, 20);
    stage.Draw(nullptr);
  }
  auto* shaderSource = reinterpret_cast<ShaderSource*>(vtkSSAOFindOpenGLPointer("glShaderSource"));
  auto* checkStatus =
    reinterpret_cast<CheckStatus*>(vtkSSAOFindOpenGLPointer("glCheckFramebufferStatus"));
  if (shaderSource && *shaderSource && checkStatus && *checkStatus)
  {
    RealShaderSource = *shaderSource;
    RealCheckStatus = *checkStatus;
    const auto breakShaders = [&](const char* text)
    {
      return [=](bool broken)
      {
        Broken = text;
        *shaderSource = broken ? BreakShaderSource : RealShaderSource;
      };
    };
    const auto balanced = [](AOPass*) {};
    Check(report, "capture shader", 0, balanced, breakShaders("ssaoOccludableWeights"));
    Check(report, "gaps shader", 0, balanced, breakShaders("ssaoChange"));
    Check(report, "layers shader", 0, balanced, breakShaders("ssaoLayersBefore"));
    Check(report, "solids shader", 0, balanced, breakShaders("sheetsOnly"));
    Check(
      report, "estimator shader", 0, [](AOPass* pass) { pass->SetQualityToFast(); },
      breakShaders("ssaoSlice"));
    Check(report, "denoiser shader", 0, balanced, breakShaders("uniform int noiseSize"));
    Check(
      report, "interpolation shader", 0, [](AOPass* pass) { pass->SetNoiseSize(1); },
      breakShaders("coarseTexelSize"));
    Check(
      report, "interpolation shader of an output mode", 0,
      [](AOPass* pass)
      {
        pass->SetNoiseSize(1);
        pass->SetOutputModeToOcclusion();
      },
      breakShaders("coarseTexelSize"));
    Check(
      report, "Gaussian shader", 0, [](AOPass* pass) { pass->SetDenoiserToSeparableGaussian(); },
      breakShaders("uniform vec2 axis"));
    Check(
      report, "shader of the output mode", 0,
      [](AOPass* pass) { pass->SetOutputModeToOcclusion(); },
      breakShaders("uniform vec2 clippingRange"));
    Check(report, "modulation shader", 0, balanced, breakShaders("uniform vec4 strength"));
    Check(report, "resolve shader", 4, balanced, breakShaders("uniform sampler2DMS geometry"));
    Check(report, "missing extension", 4, balanced, breakShaders("GL_ARB_sample_shading"));
    // The first framebuffer of the pass is that of the capture, then come the stages.
    const auto accurate = [](AOPass* pass) { pass->SetQualityToAccurate(); };
    for (const int samples : { 0, 4 })
    {
      const int framebuffers = [&]
      {
        Stage stage(report, 80, 60, samples);
        vtkSSAOAddFloorAndSpheres(stage.Renderer, 6, 0.45);
        stage.Draw(nullptr);
        vtkNew<AOPass> pass;
        accurate(pass);
        constexpr int many = 1000;
        CompleteChecks = many;
        *checkStatus = BreakCheckStatus;
        stage.Draw(pass);
        const int left = CompleteChecks;
        stage.Draw(nullptr); // what VTK 9.6 looks at itself, afterwards
        *checkStatus = RealCheckStatus;
        return (many - left) - (left - CompleteChecks);
      }();
      report.ExpectAtLeast(framebuffers, 5, "framebuffers that the pass looks at");
      for (int complete = 0; complete < framebuffers; ++complete)
      {
        Check(report,
          "framebuffer " + std::to_string(complete) + " of " + std::to_string(framebuffers) + ", " +
            std::to_string(samples) + " samples",
          samples, accurate,
          [&](bool broken)
          {
            CompleteChecks = complete;
            *checkStatus = broken ? BreakCheckStatus : RealCheckStatus;
          });
      }
    }
  }
  else
  {
    std::cout
      << "The functions of this VTK's OpenGL loader were not found: shaders and framebuffers "
         "are not broken."
      << std::endl;
  }
  return report.GetResult();
}
