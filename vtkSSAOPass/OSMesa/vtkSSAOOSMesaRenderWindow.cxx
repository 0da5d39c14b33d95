// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOOSMesaRenderWindow.h"

#include "vtk_glew.h" // before any other OpenGL header

#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextureObject.h"

// GLEW undefines the macros with which OSMesa declares its functions.
#ifndef GLAPI
#define GLAPI extern
#endif
#ifndef APIENTRY
#define APIENTRY
#endif
#ifndef GLAPIENTRY
#define GLAPIENTRY
#endif
#include <GL/osmesa.h>

namespace
{
// The default framebuffer of all contexts. OSMesa copies into it on a flush, nobody reads it, and
// being static it outlives every context.
constexpr int UnusedBufferSize = 4;
unsigned char UnusedBuffer[4 * UnusedBufferSize * UnusedBufferSize];

constexpr const char* LoadOrderHint = "Is libGL loaded before libOSMesa? Link the executable with "
                                      "the CMake target vtkSSAOPass::OSMesa, "
                                      "or preload this library.";
}

vtkStandardNewMacro(vtkSSAOOSMesaRenderWindow);

//------------------------------------------------------------------------------
vtkSSAOOSMesaRenderWindow::vtkSSAOOSMesaRenderWindow()
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->DoubleBuffer = 0;
}

//------------------------------------------------------------------------------
vtkSSAOOSMesaRenderWindow::~vtkSSAOOSMesaRenderWindow()
{
  this->Finalize();

  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::CreateAWindow()
{
  // VTK asks for 3.2; Mesa answers with the highest core version it has.
  const int attributes[] = { OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS,
    8, OSMESA_ACCUM_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 3,
    OSMESA_CONTEXT_MINOR_VERSION, 2, 0 };
  this->Context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!this->Context)
  {
    vtkErrorMacro("OSMesa cannot create an OpenGL 3.2 core context.");
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::DestroyWindow()
{
  if (!this->Context)
  {
    return;
  }

  // The resources have to go while their context is current; then the caller's is current again.
  this->PushContext();
  this->ReleaseGraphicsResources(this);
  this->PopContext();

  // The caller had none, or this one.
  if (this->IsCurrent())
  {
    this->ReleaseCurrent();
  }
  OSMesaDestroyContext(static_cast<OSMesaContext>(this->Context));
  this->Context = nullptr;
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::Initialize()
{
  if (!this->Context)
  {
    this->CreateAWindow();
  }
  if (!this->Context || this->Initialized)
  {
    return;
  }

  this->MakeCurrent();
  this->OpenGLInit();

  // This asks through the functions that VTK itself is bound to.
  if (this->Initialized && this->GetState()->GetVersion().empty())
  {
    vtkErrorMacro("VTK's OpenGL functions are not those of libOSMesa. " << LoadOrderHint);
    this->Initialized = false;
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }

  // GLEW loads OpenGL first and GLX afterwards; of the second only the absence can be reported.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY ||
    result == GLEW_ERROR_GLX_VERSION_11_ONLY;
  if (!this->GlewInitValid)
  {
    vtkErrorMacro("GLEW could not be initialized from libOSMesa: "
      << reinterpret_cast<const char*>(glewGetErrorString(result)) << ". " << LoadOrderHint);
    return;
  }
  if (!GLEW_VERSION_3_2)
  {
    this->GlewInitValid = false;
    vtkErrorMacro("This libOSMesa does not provide OpenGL 3.2, which VTK needs.");
    return;
  }
  this->Initialized = true;

  float range[2] = { 1.0f, 1.0f };
  glGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::Finalize()
{
  this->DestroyWindow();
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::WindowRemap()
{
  this->Finalize();
  this->Initialize();
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::Render()
{
  this->Initialize();
  if (this->Initialized)
  {
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::Start()
{
  if (this->StencilCapable != this->FramebufferStencil)
  {
    for (auto framebuffer :
      { this->RenderFramebuffer, this->DisplayFramebuffer, this->ResolveFramebuffer })
    {
      framebuffer->ReleaseGraphicsResources(this);
    }
    this->FramebufferStencil = this->StencilCapable;
  }

  this->Superclass::Start(); // binds RenderFramebuffer

  vtkTextureObject* depth = this->RenderFramebuffer->GetDepthAttachmentAsTextureObject();
  if (this->StencilCapable && depth)
  {
    glFramebufferTexture2D(
      GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, depth->GetTarget(), depth->GetHandle(), 0);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::MakeCurrent()
{
  if (!this->Context || this->IsCurrent())
  {
    return;
  }
  if (!OSMesaMakeCurrent(static_cast<OSMesaContext>(this->Context), UnusedBuffer, GL_UNSIGNED_BYTE,
        UnusedBufferSize, UnusedBufferSize))
  {
    vtkErrorMacro("OSMesa cannot make the context of this window current.");
  }
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::ReleaseCurrent()
{
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

//------------------------------------------------------------------------------
bool vtkSSAOOSMesaRenderWindow::IsCurrent()
{
  return this->Context && this->Context == OSMesaGetCurrentContext();
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::PushContext()
{
  CurrentContext current;
  current.Context = OSMesaGetCurrentContext();
  if (current.Context && current.Context != this->Context)
  {
    int format = 0;
    OSMesaGetIntegerv(OSMESA_TYPE, &current.Type);
    OSMesaGetColorBuffer(static_cast<OSMesaContext>(current.Context), &current.Width,
      &current.Height, &format, &current.Buffer);
  }
  this->ContextStack.push_back(current);
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::PopContext()
{
  if (this->ContextStack.empty())
  {
    return;
  }
  const CurrentContext previous = this->ContextStack.back();
  this->ContextStack.pop_back();
  if (previous.Context && previous.Context != OSMesaGetCurrentContext())
  {
    OSMesaMakeCurrent(static_cast<OSMesaContext>(previous.Context), previous.Buffer,
      static_cast<GLenum>(previous.Type), previous.Width, previous.Height);
  }
}

//------------------------------------------------------------------------------
int* vtkSSAOOSMesaRenderWindow::GetScreenSize()
{
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  return this->ScreenSize;
}

//------------------------------------------------------------------------------
void vtkSSAOOSMesaRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << this->Context << "\n";
}
