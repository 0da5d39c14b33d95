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
#include "vtkSSAOShaderFunctions.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

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
  Release(this->Changes, window);
  Release(this->Solids, window);
  Release(this->MoreSolids, window);
}

//------------------------------------------------------------------------------
unsigned long vtkSSAOLayerStage::GetTextureMemory() const
{
  unsigned long bytes =
    GetBytes(this->Changes) + GetBytes(this->Solids) + GetBytes(this->MoreSolids);
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
  this->EvenFacet = 0.0F;
  // Sprites are not seen at other pixels' places, and of several samples per pixel one is known.
  if (!reduces || scene.Samples > 0 || settings.SheetsOnly)
  {
    this->Changes = nullptr;
  }
  else
  {
    bool gaps = true;
    if (!this->FindGaps(scene, view, settings.Radius, geometry, gaps))
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
bool vtkSSAOLayerStage::FindGaps(const vtkSSAOView& scene, const vtkSSAOView& view, double radius,
  vtkTextureObject* geometry, bool& gaps)
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
  program->SetUniformf("radius", static_cast<float>(radius));
  const bool drawn = this->DrawToTexture(view, 2, this->Changes);
  geometry->Deactivate();
  const std::vector<float> changes = Download(drawn ? this->Changes.Get() : nullptr, view.Drawn);
  // Where that is not known there may be some.
  gaps = changes.empty();
  for (std::size_t i = 0; i < changes.size() && !gaps; i += 2)
  {
    gaps = changes[i] > 1.5F;
  }
  this->FindUneven(view, changes);
  return drawn;
}

//------------------------------------------------------------------------------
void vtkSSAOLayerStage::FindUneven(const vtkSSAOView& view, const std::vector<float>& changes)
{
  const std::size_t texels = std::size_t(view.Drawn.z) * view.Drawn.w;
  if (changes.size() != 2 * texels)
  {
    return;
  }
  // The facet that more than a half of the surfaces' texels show (after Boyer, Moore, "MJRTY",
  // 1981), if there is one: in scenes without such a plane there is little to save.
  float facet = 0.0F;
  int votes = 0;
  std::size_t surfaces = 0;
  for (std::size_t i = 1; i < changes.size(); i += 2)
  {
    const float shown = changes[i];
    facet = votes == 0 && shown != 0.0F ? shown : facet;
    votes += shown == 0.0F ? 0 : (shown == facet ? 1 : -1);
    surfaces += shown == 0.0F ? 0 : 1;
  }
  std::size_t equal = 0;
  for (std::size_t i = 1; i < changes.size(); i += 2)
  {
    equal += changes[i] == facet ? 1 : 0;
  }
  if (surfaces == 0 || 2 * equal <= surfaces)
  {
    return;
  }
  const glm::vec3 normal = shader::ssaoUnpackFacet(facet);
  constexpr int nowhere = 1000000000;
  glm::ivec2 first(nowhere);
  glm::ivec2 end(-nowhere);
  for (int y = 0; y < view.Drawn.w; ++y)
  {
    for (int x = 0; x < view.Drawn.z; ++x)
    {
      const float* change = &changes[2 * (std::size_t(y) * view.Drawn.z + x)];
      // What a facet is packed to differs by 0.0007 at most on one plane.
      const bool even = change[0] < 0.5F &&
        (change[1] == facet ||
          (change[1] * facet > 0.0F &&
            glm::length(shader::ssaoUnpackFacet(change[1]) - normal) < 0.002F));
      if (!even)
      {
        first = glm::min(first, glm::ivec2(x, y));
        end = glm::max(end, glm::ivec2(x, y) + 1);
      }
    }
  }
  this->EvenFacet = facet;
  const glm::dvec2 corner = glm::dvec2(view.Drawn) + 0.5;
  const glm::dvec2 edge(view.PixelOfTexel);
  const glm::dvec2 place(view.PixelOfTexel.z, view.PixelOfTexel.w);
  this->Uneven = glm::vec4(
    edge * (corner + glm::dvec2(first)) + place, edge * (corner + glm::dvec2(end)) + place);
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
