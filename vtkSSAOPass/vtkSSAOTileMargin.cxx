// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTileMargin.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSSAOFullScreenStage.h"
#include "vtkSSAOOpenGL.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// The largest that a length may appear, in pixels: at the nearest point of the props' bounds.
double PixelsOf(double length, const vtkSSAOView& tile, const std::vector<vtkProp*>& props)
{
  vtkCamera* camera = tile.Renderer->GetActiveCamera();
  vtkMatrix4x4* clipOfView =
    camera->GetProjectionTransformMatrix(tile.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  double pixels = length * 0.5 *
    std::max(std::abs(clipOfView->GetElement(0, 0)) * tile.Viewport.z,
      std::abs(clipOfView->GetElement(1, 1)) * tile.Viewport.w);
  if (!camera->GetParallelProjection())
  {
    double nearest = camera->GetClippingRange()[1];
    vtkMatrix4x4* viewOfWorld = camera->GetModelViewTransformMatrix();
    for (vtkProp* prop : props)
    {
      const double* bounds = prop->GetBounds();
      for (int i = 0; i < 8 && bounds; ++i)
      {
        const double point[4] = { bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)],
          1.0 };
        nearest = std::min(nearest, -viewOfWorld->MultiplyDoublePoint(point)[2]);
      }
    }
    pixels /= std::max(nearest, camera->GetClippingRange()[0]);
  }
  return pixels;
}
}

//------------------------------------------------------------------------------
bool vtkSSAOTileMargin::IsNeeded(const vtkSSAOView& view)
{
  const int* tiles = view.Window->GetTileScale();
  return tiles[0] > 1 || tiles[1] > 1;
}

//------------------------------------------------------------------------------
vtkSSAOTileMargin::vtkSSAOTileMargin(const vtkSSAOView& tile, double radius, int period)
  : Tile(tile)
  , ViewportSaver(tile.Window->GetState())
  , ScissorSaver(tile.Window->GetState())
  , CameraOfTile(tile.Renderer->GetActiveCamera())
  , State(tile.Renderer)
{
  vtkCollectionSimpleIterator it;
  vtkPropCollection* all = tile.Renderer->GetViewProps();
  all->InitTraversal(it);
  while (vtkProp* prop = all->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      this->Props.push_back(prop);
    }
  }
  this->State.SetPropArrayAndCount(this->Props.data(), static_cast<int>(this->Props.size()));

  // As far as occluders and noise reach, but no more than a tile to each side.
  const glm::ivec2 size(tile.Viewport.z, tile.Viewport.w);
  const double reach = std::min(PixelsOf(radius, tile, this->Props), 1.0e6) + 2.0 * period;
  const int* tiles = tile.Window->GetTileScale();
  const double* viewport = tile.Window->GetTileViewport();
  const int* windowSize = tile.Window->GetActualSize();
  const int largest = vtkTextureObject::GetMaximumTextureSize(tile.Window);
  glm::ivec2 wide;
  for (int i = 0; i < 2; ++i)
  {
    const int most = std::min(size[i], (largest - size[i]) / 2 - period);
    const int margin = std::max(0, std::min(static_cast<int>(std::ceil(reach)), most));
    // The view starts where the pattern does.
    const int corner =
      static_cast<int>(std::lround(viewport[i] * tiles[i] * windowSize[i])) - margin;
    this->Offset[i] = margin + ((corner % period) + period) % period;
    wide[i] = this->Offset[i] + size[i] + margin;
  }

  // The same camera, to which the wider picture is the whole.
  vtkNew<vtkMatrix4x4> clipOfView;
  clipOfView->DeepCopy(this->CameraOfTile->GetProjectionTransformMatrix(
    tile.Renderer->GetTiledAspectRatio(), -1.0, 1.0));
  for (int row = 0; row < 2; ++row)
  {
    const double scale = static_cast<double>(size[row]) / wide[row];
    const double shift = static_cast<double>(size[row] + 2 * this->Offset[row]) / wide[row] - 1.0;
    for (int column = 0; column < 4; ++column)
    {
      clipOfView->SetElement(row, column,
        scale * clipOfView->GetElement(row, column) + shift * clipOfView->GetElement(3, column));
    }
  }
  auto camera = vtkSmartPointer<vtkCamera>::Take(this->CameraOfTile->NewInstance());
  camera->DeepCopy(this->CameraOfTile);
  camera->SetExplicitProjectionTransformMatrix(clipOfView);
  camera->UseExplicitProjectionTransformMatrixOn();
  tile.Renderer->SetActiveCamera(camera);

  vtkOpenGLState* state = tile.Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(tile.Window);
  this->Framebuffer->PopulateFramebuffer(wide.x, wide.y, true, 1, VTK_UNSIGNED_CHAR, true, 32, 0);
  this->Framebuffer->ActivateDrawBuffers(1);
  state->vtkglViewport(0, 0, wide.x, wide.y);
  state->vtkglScissor(0, 0, wide.x, wide.y);
  state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  this->State.SetFrameBuffer(this->Framebuffer);
  this->View = std::make_unique<vtkSSAOView>(&this->State);
}

//------------------------------------------------------------------------------
vtkSSAOTileMargin::~vtkSSAOTileMargin()
{
  this->Tile.Window->GetState()->PopFramebufferBindings();
  this->Framebuffer->ReleaseGraphicsResources(this->Tile.Window);
  this->Tile.Renderer->SetActiveCamera(this->CameraOfTile);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextureObject> vtkSSAOTileMargin::CutTile(vtkTextureObject* texture)
{
  vtkOpenGLRenderWindow* window = this->Tile.Window;
  const glm::ivec4 to = this->Tile.Viewport;
  vtkSmartPointer<vtkTextureObject> cut = vtkSSAOFullScreenStage::NewTexture(
    window, this->Tile.TextureSize.x, this->Tile.TextureSize.y, texture->GetComponents(), 0);
  vtkNew<vtkOpenGLFramebufferObject> framebuffers[2]; // read, draw
  vtkTextureObject* textures[2] = { texture, cut };
  const unsigned int targets[2] = { GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER };
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  for (int i = 0; i < 2; ++i)
  {
    framebuffers[i]->SetContext(window);
    framebuffers[i]->Bind();
    framebuffers[i]->AddColorAttachment(0, textures[i]);
    framebuffers[i]->ActivateDrawBuffers(1);
    framebuffers[i]->ActivateReadBuffer(0);
  }
  for (int i = 0; i < 2; ++i)
  {
    framebuffers[i]->Bind(targets[i]);
  }
  const int source[4] = { this->Offset.x, this->Offset.x + to.z, this->Offset.y,
    this->Offset.y + to.w };
  const int target[4] = { to.x, to.x + to.z, to.y, to.y + to.w };
  {
    vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
    state->vtkglDisable(GL_SCISSOR_TEST);
    vtkOpenGLFramebufferObject::Blit(source, target, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  state->PopFramebufferBindings();
  for (auto& framebuffer : framebuffers)
  {
    framebuffer->RemoveColorAttachment(0);
    framebuffer->ReleaseGraphicsResources(window);
  }
  return cut;
}
