// SPDX-License-Identifier: BSD-3-Clause

// The pass over every kind of delegate, and inside the chains of passes that applications build.

#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkEDLShading.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOTestEverything.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

namespace
{
using namespace vtkSSAOTest;
using PassPointer = vtkSmartPointer<vtkRenderPass>;

//------------------------------------------------------------------------------
template <typename Pass>
vtkSmartPointer<Pass> Make()
{
  return vtkSmartPointer<Pass>::New();
}

template <typename Pass>
PassPointer Over(vtkRenderPass* delegate)
{
  auto pass = Make<Pass>();
  pass->SetDelegatePass(delegate);
  return pass;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkSequencePass> Sequence(const std::vector<PassPointer>& passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  auto sequence = Make<vtkSequencePass>();
  sequence->SetPasses(collection);
  return sequence;
}

// As F3D and vedo build their chains, around the pass that draws opaque props.
PassPointer Chain(vtkRenderPass* opaque)
{
  return Over<vtkCameraPass>(Sequence({ Make<vtkLightsPass>(), opaque, Make<vtkTranslucentPass>(),
    Make<vtkVolumetricPass>(), Make<vtkOverlayPass>() }));
}

//------------------------------------------------------------------------------
enum Extras
{
  Nothing,
  Glass,
  GlassFogAndText
};

// Spheres on a floor, and more.
void BuildScene(Stage& stage, Extras extras)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-1.0, -1.0, -0.4);
  floor->SetPoint1(5.0, -1.0, -0.4);
  floor->SetPoint2(-1.0, 4.0, -0.4);
  floor->Update();
  stage.Renderer->AddActor(MakeActor(floor->GetOutput()));
  for (int i = 0; i < 8; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.45));
    sphere->SetPosition(i % 4, i / 4, 0.0);
    sphere->GetProperty()->SetColor(0.9, 0.5 + 0.05 * i, 0.3);
    stage.Renderer->AddActor(sphere);
  }
  Grid grid(4);
  if (extras >= Glass)
  {
    AddTranslucentProps(stage.Renderer, grid);
  }
  if (extras == GlassFogAndText)
  {
    AddVolume(stage.Renderer, grid);
    AddAnnotations(stage.Renderer, grid);
  }
  SetHeadlight(stage.Renderer);
  stage.Camera()->SetFocalPoint(1.5, 1.0, 0.0);
  stage.Camera()->SetPosition(1.7, -2.5, 8.0);
  stage.Camera()->SetClippingRange(3.0, 16.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<AOPass> NewPass(vtkRenderPass* delegate)
{
  auto pass = Make<AOPass>();
  pass->SetDelegatePass(delegate);
  pass->SetRadius(0.5);
  return pass;
}

//------------------------------------------------------------------------------
// Every delegate that only draws in another order gives the same picture, real occlusion included.
void CheckSamePicture(Report& report)
{
  Stage stage(report, 160, 120);
  BuildScene(stage, Nothing);
  const Picture plain = stage.Draw(nullptr);
  const vtkSmartPointer<AOPass> own = NewPass(nullptr);
  const Picture expected = stage.Draw(own);
  report.Differ("there is occlusion", plain, expected, 0.1, 500);

  const auto opaque = Make<vtkOpaquePass>();
  const auto inner = NewPass(Over<vtkCameraPass>(opaque));
  const auto bare = NewPass(Make<vtkOpaquePass>());
  const std::vector<std::pair<const char*, PassPointer>> passes = {
    { "render steps", NewPass(Make<vtkRenderStepsPass>()) },
    { "camera and opaque", NewPass(Over<vtkCameraPass>(Make<vtkOpaquePass>())) },
    { "camera, sequence", NewPass(Chain(Make<vtkOpaquePass>())) },
    { "camera, sequence of sequence",
      NewPass(Over<vtkCameraPass>(
        Sequence({ Make<vtkLightsPass>(), Sequence({ Make<vtkOpaquePass>() }) }))) },
    { "bare opaque", NewPass(Make<vtkOpaquePass>()) },
    { "inside a sequence, over camera and opaque", Chain(inner) },
    { "inside a sequence, over bare opaque", Chain(bare) },
    { "camera over steps", NewPass(Over<vtkCameraPass>(Sequence({ Make<vtkRenderStepsPass>() }))) },
  };
  for (const auto& pass : passes)
  {
    // The same shaders draw the same triangles.
    report.Same(pass.first, expected, stage.Draw(pass.second), 0.0);
    pass.second->ReleaseGraphicsResources(stage.Window);
  }
  report.Same("own steps again", expected, stage.Draw(own), 0.0);
}

//------------------------------------------------------------------------------
// With visibility 1 a delegate draws what it draws alone, and so does a chain around the pass.
void CheckIdentity(Report& report, Extras extras)
{
  Stage stage(report, 160, 120);
  BuildScene(stage, extras);
  const auto check = [&](const char* name, vtkRenderPass* without, vtkRenderPass* with)
  {
    const Picture expected = stage.Draw(without);
    report.Same(std::string("V 1, ") + name, expected, stage.Draw(with), 1.0 * Step);
    without->ReleaseGraphicsResources(stage.Window);
    with->ReleaseGraphicsResources(stage.Window);
  };
  const auto open = [](vtkRenderPass* delegate)
  {
    const vtkSmartPointer<AOPass> pass = NewPass(delegate);
    ForceVisibility(pass, 1.0);
    return pass;
  };
  check("render steps", Make<vtkRenderStepsPass>(), open(Make<vtkRenderStepsPass>()));
  check("camera, sequence", Chain(Make<vtkOpaquePass>()), open(Chain(Make<vtkOpaquePass>())));
  check("inside a sequence", Chain(Make<vtkOpaquePass>()), Chain(open(Make<vtkOpaquePass>())));
  if (extras == GlassFogAndText)
  {
    // Under image passes VTK itself cannot draw volumes.
    return;
  }
  check("EDL over", Over<vtkEDLShading>(Make<vtkRenderStepsPass>()),
    Over<vtkEDLShading>(open(Make<vtkRenderStepsPass>())));
  check("EDL under", Over<vtkEDLShading>(Make<vtkRenderStepsPass>()),
    open(Over<vtkEDLShading>(Make<vtkRenderStepsPass>())));
  check("depth of field over", Over<vtkDepthOfFieldPass>(Make<vtkRenderStepsPass>()),
    Over<vtkDepthOfFieldPass>(open(nullptr)));
  check("depth of field under", Over<vtkDepthOfFieldPass>(Make<vtkRenderStepsPass>()),
    open(Over<vtkDepthOfFieldPass>(Make<vtkRenderStepsPass>())));
  check("tone mapping over, no delegate", Over<vtkToneMappingPass>(Make<vtkRenderStepsPass>()),
    Over<vtkToneMappingPass>(open(nullptr)));
}

//------------------------------------------------------------------------------
// A pass that draws translucent props in some order, and so needs more than the picture.
template <typename Pass>
PassPointer Ordered()
{
  auto pass = Make<Pass>();
  pass->SetTranslucentPass(Make<vtkTranslucentPass>());
  return pass;
}
template <typename Pass> // vtkDepthPeelingPass or vtkDualDepthPeelingPass, which derives from it
PassPointer Peeled(int peels)
{
  const PassPointer kept = Ordered<Pass>();
  auto* pass = vtkDepthPeelingPass::SafeDownCast(kept);
  pass->SetMaximumNumberOfPeels(peels);
  pass->SetOcclusionRatio(0.0);
  return kept;
}

// Three spheres of glass through each other: their order matters.
void AddNestedGlass(Stage& stage)
{
  for (int i = 0; i < 3; ++i)
  {
    vtkSmartPointer<vtkActor> glass = MakeActor(MakeSphere(0.7));
    glass->SetPosition(0.5 * i + 1.0, 0.4 * i + 0.3, 0.4);
    glass->GetProperty()->SetOpacity(0.5);
    glass->GetProperty()->SetColor(0.3 * i, 0.5, 1.0 - 0.3 * i);
    stage.Renderer->AddActor(glass);
  }
  stage.Window->AlphaBitPlanesOn();
}

//------------------------------------------------------------------------------
// Chains whose translucent props are drawn by depth peeling, simple and dual, and independently of
// their order; into a framebuffer of their own, too.
void CheckTranslucentPasses(Report& report)
{
  const struct
  {
    const char* Name;
    std::function<PassPointer()> New;
  } kinds[] = { { "as they come", [] { return PassPointer(Make<vtkTranslucentPass>()); } },
    { "depth peeling", [] { return Peeled<vtkDepthPeelingPass>(8); } },
    { "dual depth peeling", [] { return Peeled<vtkDualDepthPeelingPass>(8); } },
    { "order-independent", [] { return Ordered<vtkOrderIndependentTranslucentPass>(); } } };
  const auto chain = [](vtkRenderPass* opaque, vtkRenderPass* translucent)
  {
    return Over<vtkCameraPass>(
      Sequence({ Make<vtkLightsPass>(), opaque, translucent, Make<vtkOverlayPass>() }));
  };
  const auto framed = [](vtkRenderPass* pass)
  {
    auto frame = Make<vtkFramebufferPass>();
    frame->SetDelegatePass(pass);
    frame->SetColorFormat(vtkTextureObject::Float32);
    frame->SetDepthFormat(vtkTextureObject::Fixed32);
    return frame;
  };
  for (const auto& kind : kinds)
  {
    for (const bool framebuffer : { false, true })
    {
      Stage stage(report, 160, 120);
      BuildScene(stage, Nothing);
      const auto draw = [&](vtkRenderPass* pass)
      {
        PassPointer outer = pass;
        if (framebuffer)
        {
          outer = framed(pass);
        }
        const Picture picture = stage.Draw(outer);
        stage.Renderer->SetPass(nullptr);
        outer->ReleaseGraphicsResources(stage.Window);
        return picture;
      };
      const std::string name = std::string("translucent ") + kind.Name +
        (framebuffer ? ", in a framebuffer of its own" : "");
      const Picture bare = draw(chain(Make<vtkOpaquePass>(), kind.New()));
      AddNestedGlass(stage);
      const Picture plain = draw(chain(Make<vtkOpaquePass>(), kind.New()));
      report.Differ(name + ", there is glass", bare, plain, 0.05, 500);
      const auto check = [&](
                           const std::string& what, const std::function<PassPointer(AOPass*)>& make)
      {
        const vtkSmartPointer<AOPass> pass = NewPass(nullptr);
        ForceVisibility(pass, 1.0);
        report.Same(name + what + ", V 1", plain, draw(make(pass)), 1.0 * Step);
        // Nothing but the surfaces: beside them, and where only glass is, all stays.
        ForceVisibility(pass, 0.0);
        pass->SetModulationToAll();
        const Picture dark = draw(make(pass));
        report.Differ(name + what + ", V 0", plain, dark, 0.1, 3000);
        // The glass does not darken: its light stays on the black surfaces.
        report.Differ(name + what + ", V 0, glass", Picture::Of([](float) { return 0.0; }, dark),
          dark, 0.1, 500, ChangedPixels(bare, plain));
      };
      check(" over the opaque pass",
        [&](AOPass* pass)
        {
          pass->SetDelegatePass(Make<vtkOpaquePass>());
          return chain(pass, kind.New());
        });
      check(" over all",
        [&](AOPass* pass)
        {
          pass->SetDelegatePass(chain(Make<vtkOpaquePass>(), kind.New()));
          return PassPointer(pass);
        });
    }
  }
}

//------------------------------------------------------------------------------
// Image passes over and under. Modulation All with V 1/2 is a headlight of half the intensity.
void CheckImagePasses(Report& report)
{
  Stage stage(report, 160, 120);
  BuildScene(stage, Nothing);
  // A step for rounding before the filter, a step after; FXAA decides by thresholds whether and how
  // far it blends, and rounding may tip it over.
  const double rounding = 2.0 * Step;
  const double decisions = 10.0 * Step;
  const struct
  {
    const char* Name;
    PassPointer (*Over)(vtkRenderPass*);
    double Tolerance;
  } filters[] = {
    { "EDL", Over<vtkEDLShading>, rounding },
    { "FXAA", Over<vtkOpenGLFXAAPass>, decisions },
    { "SSAA", Over<vtkSSAAPass>, rounding },
    { "Gaussian blur", Over<vtkGaussianBlurPass>, rounding },
    { "tone mapping", Over<vtkToneMappingPass>, rounding },
    { "blur over tone mapping",
      [](vtkRenderPass* pass) { return Over<vtkGaussianBlurPass>(Over<vtkToneMappingPass>(pass)); },
      rounding },
  };
  const auto half = [](vtkRenderPass* delegate)
  {
    const vtkSmartPointer<AOPass> pass = NewPass(delegate);
    pass->SetModulationToAll();
    ForceVisibility(pass, 0.5);
    return pass;
  };
  for (const auto& filter : filters)
  {
    SetHeadlight(stage.Renderer, 0.5);
    const PassPointer plain = filter.Over(Make<vtkRenderStepsPass>());
    const Picture expected = stage.Draw(plain);
    SetHeadlight(stage.Renderer, 1.0);
    report.Differ(
      std::string(filter.Name) + ", full light", expected, stage.Draw(plain), 0.1, 3000);
    const PassPointer over = filter.Over(half(nullptr));
    const PassPointer overSteps = filter.Over(half(Make<vtkRenderStepsPass>()));
    const PassPointer under = half(filter.Over(Make<vtkRenderStepsPass>()));
    const std::string name = filter.Name;
    report.Same(name + " over the pass", expected, stage.Draw(over), filter.Tolerance);
    report.Same(
      name + " over the pass with delegate", expected, stage.Draw(overSteps), filter.Tolerance);
    report.Same(name + " under the pass", expected, stage.Draw(under), filter.Tolerance);
    for (vtkRenderPass* pass : { plain.Get(), over.Get(), overSteps.Get(), under.Get() })
    {
      pass->ReleaseGraphicsResources(stage.Window);
    }
  }
}

//------------------------------------------------------------------------------
// The delegate is what it was before.
void CheckUnchanged(Report& report)
{
  Stage stage(report, 80, 60);
  BuildScene(stage, Nothing);
  const auto steps = Make<vtkRenderStepsPass>();
  vtkRenderPass* opaqueOfSteps = steps->GetOpaquePass();
  const auto opaque = Make<vtkOpaquePass>();
  const auto lights = Make<vtkLightsPass>();
  const vtkSmartPointer<vtkSequencePass> sequence = Sequence({ lights, opaque });
  const auto camera = Make<vtkCameraPass>();
  camera->SetDelegatePass(sequence);
  const auto direct = Make<vtkOpaquePass>();
  const auto second = Make<vtkCameraPass>();
  second->SetDelegatePass(direct);

  const Picture plain = stage.Draw(camera);
  const int references = opaque->GetReferenceCount();
  for (vtkRenderPass* delegate :
    { static_cast<vtkRenderPass*>(steps), static_cast<vtkRenderPass*>(camera),
      static_cast<vtkRenderPass*>(second), static_cast<vtkRenderPass*>(direct) })
  {
    const vtkSmartPointer<AOPass> pass = NewPass(delegate);
    stage.Draw(pass);
    report.Expect(pass->GetDelegatePass() == delegate, "the pass keeps its delegate");
    pass->ReleaseGraphicsResources(stage.Window);
  }
  report.Expect(steps->GetOpaquePass() == opaqueOfSteps, "the render steps keep their opaque pass");
  report.Expect(camera->GetDelegatePass() == sequence, "the camera keeps its sequence");
  report.Expect(second->GetDelegatePass() == direct, "the camera keeps its opaque pass");
  report.Equal("items of the sequence", 2, sequence->GetPasses()->GetNumberOfItems());
  report.Expect(sequence->GetPasses()->GetItemAsObject(0) == lights &&
      sequence->GetPasses()->GetItemAsObject(1) == opaque,
    "the sequence keeps its items");
  report.Equal("references to the opaque pass", references, opaque->GetReferenceCount());
  report.Same("the delegate alone", plain, stage.Draw(camera), 0.0);
}

//------------------------------------------------------------------------------
// Nothing to wrap: one warning, and the picture of the delegate.
void CheckNoOpaquePass(Report& report)
{
  Stage stage(report, 80, 60);
  BuildScene(stage, Glass);
  const auto steps = Make<vtkRenderStepsPass>();
  steps->SetOpaquePass(nullptr);
  const auto shadows = Make<vtkShadowMapPass>();
  const std::vector<std::pair<const char*, PassPointer>> delegates = {
    { "no opaque pass in the sequence",
      Over<vtkCameraPass>(
        Sequence({ Make<vtkLightsPass>(), Make<vtkTranslucentPass>(), Make<vtkOverlayPass>() })) },
    { "an empty sequence", Over<vtkCameraPass>(Sequence({})) },
    { "render steps without opaque pass", steps },
    { "a camera without delegate", Over<vtkCameraPass>(Make<vtkLightsPass>()) },
    { "a default pass, which draws everything by itself",
      Over<vtkCameraPass>(Sequence({ Make<vtkLightsPass>(), Make<vtkDefaultPass>() })) },
    { "shadow maps", Over<vtkCameraPass>(Sequence({ shadows->GetShadowMapBakerPass(), shadows })) },
  };
  for (const auto& delegate : delegates)
  {
    const Picture expected = stage.Draw(delegate.second);
    const vtkSmartPointer<AOPass> pass = NewPass(delegate.second);
    vtkSSAOErrorObserver observer(pass);
    report.Same(delegate.first, expected, stage.Draw(pass), 0.0);
    stage.Draw(pass);
    stage.Draw(pass);
    report.Equal(std::string(delegate.first) + ", warnings", 1, observer.GetWarnings());
    report.Equal(std::string(delegate.first) + ", errors", 0, observer.GetErrors());
    pass->ReleaseGraphicsResources(stage.Window);
  }
}
}

//------------------------------------------------------------------------------
int TestDelegates(int, char*[])
{
  Report report;
  CheckSamePicture(report);
  CheckIdentity(report, Glass);
  CheckIdentity(report, GlassFogAndText);
  CheckTranslucentPasses(report);
  CheckImagePasses(report);
  CheckUnchanged(report);
  CheckNoOpaquePass(report);
  return report.GetResult();
}
