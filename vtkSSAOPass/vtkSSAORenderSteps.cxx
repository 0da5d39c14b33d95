// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAORenderSteps.h"

#include "vtkHiddenLineRemovalPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

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

  const bool translucent = std::any_of(
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
void vtkSSAORenderSteps::RenderOpaque(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  // Hidden lines are removed by a pass of VTK's that draws all opaque props in its own order.
  if (renderer->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(s->GetPropArray(), s->GetPropArrayCount()))
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
void vtkSSAORenderSteps::ReleaseGraphicsResources(vtkWindow* /*window*/)
{
  this->FXAAFilter->ReleaseGraphicsResources();
}
