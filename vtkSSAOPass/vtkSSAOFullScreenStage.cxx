// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOFullScreenStage.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkSSAOOpenGL.h"
#include "vtkSSAOPassFullScreenVS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
vtkSSAOFullScreenStage::vtkSSAOFullScreenStage() = default;

//------------------------------------------------------------------------------
vtkSSAOFullScreenStage::~vtkSSAOFullScreenStage() = default;

//------------------------------------------------------------------------------
void vtkSSAOFullScreenStage::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& quad : this->Quads)
  {
    quad.second->ReleaseGraphicsResources(window);
  }
  this->Quads.clear();
  this->Quad = nullptr;
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->Output)
  {
    this->Output->ReleaseGraphicsResources(window);
    this->Output = nullptr;
  }
}

//------------------------------------------------------------------------------
unsigned long vtkSSAOFullScreenStage::GetBytes(vtkTextureObject* texture)
{
  return texture ? 4UL * texture->GetComponents() * texture->GetWidth() * texture->GetHeight() *
      std::max(1U, texture->GetSamples())
                 : 0UL;
}

//------------------------------------------------------------------------------
void vtkSSAOFullScreenStage::ForgetDrawBuffers(vtkOpenGLRenderWindow* window, unsigned int count)
{
  std::vector<unsigned int> none(count, GL_NONE);
  window->GetState()->vtkglDrawBuffers(count, none.data());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> vtkSSAOFullScreenStage::NewTexture(
  vtkOpenGLRenderWindow* window, int width, int height, int components, int samples)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  const unsigned int formats[] = { GL_RED, GL_RG, GL_RGBA };
  const unsigned int internalFormats[] = { GL_R32F, GL_RG32F, GL_RGBA32F };
  const int format = std::min(components, 3) - 1;
  texture->SetFormat(formats[format]);
  texture->SetInternalFormat(internalFormats[format]);
  texture->SetDataType(GL_FLOAT);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetSamples(samples);
  texture->Allocate2D(width, height, components, VTK_FLOAT);
  return texture;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkSSAOFullScreenStage::UseProgram(
  vtkOpenGLRenderWindow* window, const std::string& fragmentShader)
{
  // The helper does not look whether it has got a program, so it is only made if there is one; VTK
  // finds it again.
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (this->Quads.count(fragmentShader) == 0 &&
    !cache->ReadyShaderProgram(vtkSSAOPassFullScreenVS, fragmentShader.c_str(), ""))
  {
    return nullptr;
  }
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[fragmentShader];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(
      window, vtkSSAOPassFullScreenVS, fragmentShader.c_str(), "");
    ++this->ProgramBuilds;
  }
  else
  {
    cache->ReadyShaderProgram(quad->Program);
  }
  this->Quad = quad.get();
  vtkShaderProgram* program = this->Quad->Program;
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
void vtkSSAOFullScreenStage::Draw(const vtkSSAOView& view)
{
  vtkOpenGLState* state = view.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable depthTestSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  state->vtkglViewport(view.Viewport.x, view.Viewport.y, view.Viewport.z, view.Viewport.w);
  state->vtkglScissor(view.Drawn.x, view.Drawn.y, view.Drawn.z, view.Drawn.w);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  this->Quad->Render();
}

//------------------------------------------------------------------------------
bool vtkSSAOFullScreenStage::DrawToOutput(const vtkSSAOView& view, int components)
{
  if (this->OutputComponents != components)
  {
    this->Output = nullptr;
    this->OutputComponents = components;
  }
  return this->DrawToTexture(view, components, this->Output);
}

//------------------------------------------------------------------------------
bool vtkSSAOFullScreenStage::DrawToTexture(
  const vtkSSAOView& view, int components, vtkSmartPointer<vtkTextureObject>& texture)
{
  return this->DrawToTextures(view, components, { &texture });
}

//------------------------------------------------------------------------------
bool vtkSSAOFullScreenStage::DrawToTextures(const vtkSSAOView& view, int components,
  const std::vector<vtkSmartPointer<vtkTextureObject>*>& textures)
{
  const glm::ivec2 size = view.TextureSize;
  for (vtkSmartPointer<vtkTextureObject>* texture : textures)
  {
    if (!*texture)
    {
      *texture = NewTexture(view.Window, size.x, size.y, components, 0);
    }
    (*texture)->Resize(size.x, size.y);
  }

  vtkOpenGLState* state = view.Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(view.Window);
  this->Framebuffer->Bind();
  const auto count = static_cast<unsigned int>(textures.size());
  for (unsigned int i = 0; i < count; ++i)
  {
    this->Framebuffer->AddColorAttachment(i, *textures[i]);
  }
  this->Framebuffer->ActivateDrawBuffers(count);
  const char* description = nullptr;
  const bool complete =
    vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, description) != 0;
  if (complete)
  {
    vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
    state->vtkglDisable(GL_BLEND);
    this->Draw(view);
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    this->Framebuffer->RemoveColorAttachment(i);
  }
  ForgetDrawBuffers(view.Window, count);
  state->PopFramebufferBindings();
  return complete;
}

//------------------------------------------------------------------------------
void vtkSSAOFullScreenStage::Release(vtkSmartPointer<vtkTextureObject>& texture, vtkWindow* window)
{
  if (texture)
  {
    texture->ReleaseGraphicsResources(window);
    texture = nullptr;
  }
}

//------------------------------------------------------------------------------
std::vector<float> vtkSSAOFullScreenStage::Download(
  vtkTextureObject* texture, const glm::ivec4& rectangle)
{
  std::vector<float> values;
  if (!texture || !texture->GetHandle())
  {
    return values;
  }
  texture->GetContext()->MakeCurrent();
  const int components = texture->GetComponents();
  const int width = static_cast<int>(texture->GetWidth());
  const int height = static_cast<int>(texture->GetHeight());
  std::vector<float> whole(std::size_t(width) * height * components);
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  vtkIdType increments[2] = { 0, 0 };
  vtkSmartPointer<vtkPixelBufferObject> buffer;
  buffer.TakeReference(texture->Download());
  if (!buffer->Download2D(VTK_FLOAT, whole.data(), size, components, increments))
  {
    return values;
  }
  const glm::ivec2 first = glm::max(glm::ivec2(rectangle), glm::ivec2(0));
  const glm::ivec2 end = glm::min(
    glm::ivec2(rectangle) + glm::ivec2(rectangle.z, rectangle.w), glm::ivec2(width, height));
  for (int row = first.y; row < end.y && first.x < end.x; ++row)
  {
    const auto begin = whole.begin() + (std::ptrdiff_t(row) * width + first.x) * components;
    values.insert(values.end(), begin, begin + std::ptrdiff_t(end.x - first.x) * components);
  }
  return values;
}
