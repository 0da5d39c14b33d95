// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOView.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSSAOOpenGL.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace
{
//------------------------------------------------------------------------------
void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec4& value)
{
  const float values[4] = { static_cast<float>(value.x), static_cast<float>(value.y),
    static_cast<float>(value.z), static_cast<float>(value.w) };
  program->SetUniform4f(name, values);
}

//------------------------------------------------------------------------------
void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec2& value)
{
  const float values[2] = { static_cast<float>(value.x), static_cast<float>(value.y) };
  program->SetUniform2f(name, values);
}

}

//------------------------------------------------------------------------------
vtkSSAOView::vtkSSAOView(const vtkRenderState* state)
  : Renderer(state->GetRenderer())
  , Window(vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow()))
  , Framebuffer(vtkOpenGLFramebufferObject::SafeDownCast(state->GetFrameBuffer()))
  , Viewport(0)
  , Drawn(0)
  , TextureSize(0)
  , PixelOfTexel(1.0, 1.0, 0.0, 0.0)
  , DeviceOfScene(1.0, 1.0, 0.0, 0.0)
  , Samples(0)
  , Clamped(true)
  , DepthOrigin(0.0)
  , DepthOfClip(0.0)
  , ClipOfView(1.0)
{
  if (!this->Window)
  {
    this->Reason = "the render window is not an OpenGL window";
    return;
  }
  if (this->Framebuffer)
  {
    this->Framebuffer->GetLastSize(this->Viewport.z, this->Viewport.w);
  }
  else
  {
    this->Framebuffer = this->Window->GetRenderFramebuffer();
    this->Renderer->GetTiledSizeAndOrigin(
      &this->Viewport.z, &this->Viewport.w, &this->Viewport.x, &this->Viewport.y);
  }
  if (this->Viewport.z <= 0 || this->Viewport.w <= 0)
  {
    this->Reason = "the viewport has no pixels";
    return;
  }
  this->TextureSize = glm::ivec2(this->Viewport) + glm::ivec2(this->Viewport.z, this->Viewport.w);

  int bound = 0;
  this->Window->GetState()->vtkglGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (static_cast<unsigned int>(bound) != this->Framebuffer->GetFBOIndex())
  {
    this->Reason = "something else than the renderer's framebuffer is drawn into";
    return;
  }
  if (this->Framebuffer->GetNumberOfColorAttachments() > 1)
  {
    this->Reason = "the framebuffer has several color attachments already";
    return;
  }
  this->Drawn = this->Viewport;
  this->Samples = this->Framebuffer->GetMultiSamples();
  if (vtkTextureObject* color = this->Framebuffer->GetColorAttachmentAsTextureObject(0))
  {
    const int type = color->GetVTKDataType();
    this->Clamped = type != VTK_FLOAT && type != VTK_DOUBLE;
  }

  auto* camera = vtkOpenGLCamera::SafeDownCast(this->Renderer->GetActiveCamera());
  if (!camera)
  {
    this->Reason = "the camera is not an OpenGL camera";
    return;
  }
  // The very matrix that the mappers draw with; VTK keeps it transposed.
  vtkMatrix4x4* viewOfWorld = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkMatrix4x4* clipOfView = nullptr;
  vtkMatrix4x4* clipOfWorld = nullptr;
  camera->GetKeyMatrices(this->Renderer, viewOfWorld, normals, clipOfView, clipOfWorld);
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      this->ClipOfView[column][row] = clipOfView->GetElement(column, row);
    }
  }
  const double* range = camera->GetClippingRange();
  const double thickness = range[1] - range[0];
  const bool narrow = range[0] > thickness;
  // Depths from once to twice the thickness: positive, and none much finer than another.
  this->CountDepthsFrom(narrow && camera->GetParallelProjection() ? range[0] - thickness : 0.0);
  if (narrow)
  {
    const glm::dvec2 row(this->Projection.DepthOfWindow);
    this->DepthOfClip = glm::dvec2(-1.0, row.y) / row.x;
  }
}

//------------------------------------------------------------------------------
void vtkSSAOView::CountDepthsFrom(double origin)
{
  this->DepthOfClip.y += this->DepthOrigin - origin;
  this->DepthOrigin = origin;
  glm::dmat4 matrix(this->ClipOfView);
  matrix[3] -= matrix[2] * origin;
  this->Projection = vtkSSAOProjection::FromMatrix(matrix, this->Viewport);
}

//------------------------------------------------------------------------------
vtkSSAOView vtkSSAOView::Coarse(int edge) const
{
  vtkSSAOView coarse(*this);
  if (edge > 1)
  {
    coarse.TextureSize = (this->TextureSize + edge - 1) / edge;
    coarse.Viewport =
      glm::ivec4(0, 0, (this->Viewport.z + edge - 1) / edge, (this->Viewport.w + edge - 1) / edge);
    const glm::dvec2 size(this->Viewport.z, this->Viewport.w);
    const glm::dvec2 coarseSize(coarse.Viewport.z, coarse.Viewport.w);
    const glm::dvec2 place = glm::dvec2(this->Viewport) + 0.5 - 0.5 * edge;
    coarse.PixelOfTexel = glm::dvec4(edge, edge, place.x, place.y);
    const glm::dvec2 scale = size / (double(edge) * coarseSize);
    coarse.DeviceOfScene = glm::dvec4(scale, scale + (1.0 - 1.0 / edge) / coarseSize - 1.0);
    // With the squares that are cut: their first pixels are estimated.
    const glm::ivec2 corner(this->Viewport);
    const glm::ivec2 first = (glm::ivec2(this->Drawn) - corner) / edge;
    const glm::ivec2 end =
      (glm::ivec2(this->Drawn) + glm::ivec2(this->Drawn.z, this->Drawn.w) - corner + edge - 1) /
      edge;
    coarse.Drawn = glm::ivec4(first, end - first);
  }
  return coarse;
}

//------------------------------------------------------------------------------
void vtkSSAOView::SetUniforms(vtkShaderProgram* program) const
{
  SetVector(program, "texelSize", glm::dvec2(1.0) / glm::dvec2(this->TextureSize));
  SetVector(program, "viewport", glm::dvec4(this->Viewport));
  SetVector(program, "drawn", glm::dvec4(this->Drawn));
  SetVector(program, "pixelToRay", this->Projection.PixelToRay);
  SetVector(program, "rayToPixel", this->Projection.RayToPixel);
  SetVector(program, "rayOffset", this->Projection.RayOffset);
  SetVector(program, "depthSlope", this->Projection.DepthSlope);
  SetVector(program, "depthOfWindow", this->Projection.DepthOfWindow);
  program->SetUniformf("perspective", static_cast<float>(this->Projection.Perspective));
}
