// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAORenderSteps.h"

#include "vtkHiddenLineRemovalPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <algorithm>

vtkStandardNewMacro(vtkSSAORenderSteps);

//------------------------------------------------------------------------------
vtkSSAORenderSteps::vtkSSAORenderSteps() = default;

//------------------------------------------------------------------------------
vtkSSAORenderSteps::~vtkSSAORenderSteps() = default;

//------------------------------------------------------------------------------
void vtkSSAORenderSteps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OpaquePass: " << (this->OpaquePass ? "set" : "(none)") << "\n";
}

//------------------------------------------------------------------------------
void vtkSSAORenderSteps::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
  vtkProp** props = s->GetPropArray();
  vtkProp** end = props + s->GetPropArrayCount();

  this->RenderOpaque(s);
  if (props == end)
  {
    return; // as VTK does, so that FXAA leaves a background alone
  }

  // VTK draws no translucent props if there are shadows.
  const bool translucent = !renderer->GetUseShadows() &&
    std::any_of(
      props, end, [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  if (translucent && s->GetFrameBuffer() && !renderer->GetUseDepthPeeling())
  {
    // VTK's order-independent translucency suits the renderer's own framebuffer only.
    for (vtkProp** prop = props; prop != end; ++prop)
    {
      this->NumberOfRenderedProps += (*prop)->RenderTranslucentPolygonalGeometry(renderer);
    }
  }
  else if (translucent)
  {
    renderer->DeviceRenderTranslucentPolygonalGeometry(s->GetFrameBuffer());
  }
  if (renderer->GetUseFXAA())
  {
    this->RenderFXAA(renderer);
  }
  // With depth peeling of volumes the translucent step has drawn them.
  if (!translucent || !renderer->GetUseDepthPeeling() || !renderer->GetUseDepthPeelingForVolumes())
  {
    for (vtkProp** prop = props; prop != end; ++prop)
    {
      this->NumberOfRenderedProps += (*prop)->RenderVolumetricGeometry(renderer);
    }
  }
  for (vtkProp** prop = props; prop != end; ++prop)
  {
    this->NumberOfRenderedProps += (*prop)->RenderOverlay(renderer);
  }
}

//------------------------------------------------------------------------------
const char* vtkSSAORenderSteps::WhyOtherPass(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetUseShadows())
  {
    return "the renderer has shadows, which VTK draws by a pass of its own";
  }
  if (renderer->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(s->GetPropArray(), s->GetPropArrayCount()))
  {
    return "hidden lines are removed, which VTK does by a pass of its own";
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkSSAORenderSteps::RenderOpaque(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (renderer->GetUseShadows())
  {
    this->ShadowMapPass->GetShadowMapBakerPass()->Render(s);
    this->ShadowMapPass->Render(s);
    this->NumberOfRenderedProps += this->ShadowMapPass->GetNumberOfRenderedProps();
    return;
  }
  if (WhyOtherPass(s))
  {
    renderer->DeviceRenderOpaqueGeometry(s->GetFrameBuffer());
    return;
  }
  this->OpaquePass->Render(s);
  this->NumberOfRenderedProps += this->OpaquePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkSSAORenderSteps::RenderFXAA(vtkOpenGLRenderer* renderer)
{
  if (renderer->GetFXAAOptions())
  {
    this->FXAAFilter->UpdateConfiguration(renderer->GetFXAAOptions());
  }
  this->FXAAFilter->Execute(renderer);
}

//------------------------------------------------------------------------------
void vtkSSAORenderSteps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ShadowMapPass->ReleaseGraphicsResources(window);
  this->ShadowMapPass->GetShadowMapBakerPass()->ReleaseGraphicsResources(window);
  this->FXAAFilter->ReleaseGraphicsResources();
}
