// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOLayerStage.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSSAOCapturePass.h"
#include "vtkSSAOOpenGL.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass0SliceFunctions.h"
#include "vtkSSAOPass1GapsFS.h"
#include "vtkSSAOPass1SolidsFS.h"
#include "vtkSSAOPassViewFS.h"
#include "vtkSSAOScopedBlendEquation.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// How far behind the first surface the farthest layers are looked for, world units. With one round
// they are of more use near the first surface: of 0.5 to 100 radii, 2 had the least error.
double Reach(const vtkSSAOLayerSettings& settings)
{
  return settings.Layers > 5 ? 1.0e30 : 2.0 * settings.Radius;
}
}

//------------------------------------------------------------------------------
vtkSSAOLayerStage::vtkSSAOLayerStage() = default;

//------------------------------------------------------------------------------
vtkSSAOLayerStage::~vtkSSAOLayerStage() = default;

//------------------------------------------------------------------------------
void vtkSSAOLayerStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->vtkSSAOFullScreenStage::ReleaseGraphicsResources(window);
  this->LayerFramebuffer->ReleaseGraphicsResources(window);
  for (auto& layers : this->Layers)
  {
    Release(layers, window);
  }
  Release(this->Gaps, window);
  Release(this->Solids, window);
  Release(this->MoreSolids, window);
}

//------------------------------------------------------------------------------
unsigned long vtkSSAOLayerStage::GetTextureMemory() const
{
  unsigned long bytes = GetBytes(this->Gaps) + GetBytes(this->Solids) + GetBytes(this->MoreSolids);
  for (const auto& layers : this->Layers)
  {
    bytes += GetBytes(layers);
  }
  return bytes;
}

//------------------------------------------------------------------------------
bool vtkSSAOLayerStage::Render(const vtkRenderState* s, const vtkSSAOView& scene,
  vtkSSAOCapturePass* capture, const vtkSSAOLayerSettings& settings, vtkTextureObject* geometry)
{
  int rounds = (settings.Layers + 2) / 4;
  // Only what is estimated needs layers as well; but the size of point sprites is a number of
  // pixels, and without layers nothing would tell the depth at the place of a larger one.
  const bool reduces = rounds > 0 && !capture->DrawsPointSprites();
  const vtkSSAOView view = scene.Coarse(reduces ? settings.Downsampling : 1);
  this->PixelOfTexel = view.PixelOfTexel;
  this->Viewport = view.Viewport;
  // Sprites are not seen at other pixels' places, and of several samples per pixel one is known.
  if (!reduces || scene.Samples > 0 || settings.SheetsOnly)
  {
    this->Gaps = nullptr;
  }
  else
  {
    bool gaps = true;
    if (!this->FindGaps(scene, view, geometry, gaps))
    {
      return false;
    }
    rounds = gaps ? rounds : 0;
  }
  vtkTextureObject* before = geometry;
  for (this->Rounds = 0; this->Rounds < rounds; ++this->Rounds)
  {
    if (!this->DrawRound(s, view, capture, settings, this->Rounds, before))
    {
      return false;
    }
    before = this->Layers[this->Rounds];
  }
  for (int i = rounds; i < MostRounds; ++i)
  {
    this->Layers[i] = nullptr;
  }
  return this->FindSolids(view, settings, geometry);
}

//------------------------------------------------------------------------------
bool vtkSSAOLayerStage::FindGaps(
  const vtkSSAOView& scene, const vtkSSAOView& view, vtkTextureObject* geometry, bool& gaps)
{
  std::string source = vtkSSAOPass1GapsFS;
  vtkShaderProgram::Substitute(source, "//SSAO::Functions", vtkSSAOPass0Functions);
  vtkShaderProgram::Substitute(source, "//SSAO::View", vtkSSAOPassViewFS);
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  geometry->Activate();
  scene.SetUniforms(program);
  const glm::vec4 layerPlace(view.PixelOfTexel);
  program->SetUniform4f("layerPlace", &layerPlace[0]);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  const bool drawn = this->DrawToTexture(view, 1, this->Gaps);
  geometry->Deactivate();
  const std::vector<float> values = Download(drawn ? this->Gaps.Get() : nullptr, view.Drawn);
  // Where that is not known there may be some.
  gaps = values.empty() ||
    std::any_of(values.begin(), values.end(), [](float value) { return value > 0.5F; });
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkSSAOLayerStage::DrawRound(const vtkRenderState* s, const vtkSSAOView& view,
  vtkSSAOCapturePass* capture, const vtkSSAOLayerSettings& settings, int round,
  vtkTextureObject* before)
{
  vtkSmartPointer<vtkTextureObject>& layers = this->Layers[round];
  const glm::ivec2 size = view.TextureSize;
  if (!layers)
  {
    layers = NewTexture(view.Window, size.x, size.y, 4, 0);
  }
  layers->Resize(size.x, size.y);

  vtkOpenGLState* state = view.Window->GetState();
  state->PushFramebufferBindings();
  this->LayerFramebuffer->SetContext(view.Window);
  this->LayerFramebuffer->Bind();
  this->LayerFramebuffer->AddColorAttachment(0, layers);
  this->LayerFramebuffer->ActivateDrawBuffers(1);
  const char* description = nullptr;
  const bool complete =
    vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_FRAMEBUFFER, description) != 0;
  if (complete)
  {
    constexpr float none = -1.0e30F;
    vtkOpenGLState::ScopedglClearColor clearColorSaver(state);
    vtkOpenGLState::ScopedglColorMask colorMaskSaver(state);
    vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
    vtkOpenGLState::ScopedglViewport viewportSaver(state);
    vtkOpenGLState::ScopedglScissor scissorSaver(state);
    state->vtkglViewport(view.Viewport.x, view.Viewport.y, view.Viewport.z, view.Viewport.w);
    state->vtkglScissor(view.Drawn.x, view.Drawn.y, view.Drawn.z, view.Drawn.w);
    const vtkSSAOScopedBlendEquation blendEquationSaver(state);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(none, none, none, none);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendEquation(GL_MAX);
    capture->DrawLayers(s, view, before, round == 0, settings.Sheet, Reach(settings));
  }
  this->LayerFramebuffer->RemoveColorAttachment(0);
  state->PopFramebufferBindings();
  return complete;
}

//------------------------------------------------------------------------------
bool vtkSSAOLayerStage::FindSolids(
  const vtkSSAOView& view, const vtkSSAOLayerSettings& settings, vtkTextureObject* geometry)
{
  std::string source = vtkSSAOPass1SolidsFS;
  vtkShaderProgram::Substitute(
    source, "//SSAO::Functions", std::string(vtkSSAOPass0Functions) + vtkSSAOPass0SliceFunctions);
  vtkShaderProgram::Substitute(source, "SSAO_LAYERS", this->Rounds > 1 ? "9" : "5");
  vtkShaderProgram* program = this->UseProgram(view.Window, source);
  if (!program)
  {
    return false;
  }
  // A sampler that is not used still needs a texture of its type.
  vtkTextureObject* outer = this->Rounds > 0 ? this->Layers[0].Get() : geometry;
  vtkTextureObject* inner = this->Rounds > 1 ? this->Layers[1].Get() : outer;
  vtkTextureObject* inputs[] = { geometry, outer, inner };
  for (vtkTextureObject* input : inputs)
  {
    input->Activate();
  }
  const float texelSize[2] = { 1.0F / view.TextureSize.x, 1.0F / view.TextureSize.y };
  const glm::dvec2 size(geometry->GetWidth(), geometry->GetHeight());
  const glm::vec4 geometryPlace = view.PixelOfTexel / glm::dvec4(size, size);
  program->SetUniform4f("geometryPlace", &geometryPlace[0]);
  program->SetUniformi("geometry", geometry->GetTextureUnit());
  program->SetUniformi("layers", outer->GetTextureUnit());
  program->SetUniformi("inner", inner->GetTextureUnit());
  program->SetUniform2f("texelSize", texelSize);
  program->SetUniformi("firstKnown", view.Samples > 0 && this->Rounds > 0 ? 0 : 1);
  program->SetUniformi("rounds", this->Rounds);
  program->SetUniformf("reach", static_cast<float>(Reach(settings)));
  program->SetUniformf("sheet", static_cast<float>(settings.Sheet));
  program->SetUniformi("sheetsOnly", settings.SheetsOnly ? 1 : 0);

  const bool drawn = this->DrawToTextures(view, 4, { &this->Solids, &this->MoreSolids });
  for (vtkTextureObject* input : inputs)
  {
    input->Deactivate();
  }
  return drawn;
}
