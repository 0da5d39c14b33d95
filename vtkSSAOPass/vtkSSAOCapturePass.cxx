// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOCapturePass.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSSAOFullScreenStage.h"
#include "vtkSSAOOpenGL.h"
#include "vtkSSAOPass0Functions.h"
#include "vtkSSAOPass1CaptureDeclarationsFS.h"
#include "vtkSSAOPass1CaptureFacetFS.h"
#include "vtkSSAOPass1CaptureLayerFS.h"
#include "vtkSSAOPass1CaptureLightFS.h"
#include "vtkSSAOPass1CaptureOutputFS.h"
#include "vtkSSAOPass1LayerOutputFS.h"
#include "vtkSSAOPassFullScreenVS.h"
#include "vtkSSAOView.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

vtkStandardNewMacro(vtkSSAOCapturePass);

namespace
{
constexpr const char* LayerTag = "//SSAO::Capture::Layer";
constexpr const char* LightTag = "//SSAO::Capture::Light";
constexpr const char* OutputTag = "//SSAO::Capture::Output";

//------------------------------------------------------------------------------
// Calls visit with every actor that draws a prop, until it returns false.
// Returns false if it did, or if something else than an actor takes part.
template <typename Visitor>
bool VisitActors(vtkProp* prop, Visitor visit)
{
  bool all = true;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* last = path->GetLastNode()->GetViewProp();
    // A prop with levels of detail names the actors of all its levels.
    vtkNew<vtkPropCollection> drawn;
    last->GetActors(drawn);
    all = all && drawn->GetNumberOfItems() > 0;
    vtkCollectionSimpleIterator it;
    drawn->InitTraversal(it);
    while (vtkProp* item = all ? drawn->GetNextProp(it) : nullptr)
    {
      vtkActor* actor = vtkActor::SafeDownCast(item);
      all = actor && visit(actor);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
// Whether the shaders of all that a prop draws go through the hooks of a render pass.
bool CanBeCaptured(vtkProp* prop)
{
  // A sky is an actor that draws by another one, without these hooks.
  const bool known = (prop->IsA("vtkActor") && !prop->IsA("vtkSkybox")) ||
    prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly") || prop->IsA("vtkLODProp3D");
  return known &&
    VisitActors(prop,
      [](vtkActor* actor)
      {
        vtkMapper* mapper = actor->GetMapper();
        return mapper && !mapper->IsA("vtkOpenGLSurfaceProbeVolumeMapper");
      });
}

//------------------------------------------------------------------------------
// Whether an actor's colour may exceed 1, so that clamping hides part of it, or is drawn in linear
// light. An upper bound: vertex and texture colours count as white.
bool MayExceedPicture(vtkActor* actor, double light)
{
  vtkProperty* faces[2] = { actor->GetProperty(), actor->GetBackfaceProperty() };
  return std::any_of(faces, faces + 2,
    [light](vtkProperty* property)
    {
      return property &&
        (property->GetInterpolation() == VTK_PBR ||
          property->GetAmbient() + light * (property->GetDiffuse() + property->GetSpecular()) >
            1.0);
    });
}

//------------------------------------------------------------------------------
// Whether nothing that an actor draws needs to be told from the light that may be occluded: its
// faces have that alone, in opaque pixels, and whatever else it draws has none. withHighlights:
// highlights may be occluded.
bool HasOccludableLightOnly(vtkActor* actor, bool withHighlights)
{
  vtkShaderProperty* shader = actor->GetShaderProperty();
  vtkProperty* faces[2] = { actor->GetProperty(), actor->GetBackfaceProperty() };
  return !actor->GetForceOpaque() && !actor->GetTexture() &&
    !actor->GetMapper()->IsA("vtkPointGaussianMapper") &&
    !(shader && (shader->HasFragmentShaderCode() || shader->GetNumberOfShaderReplacements() > 0)) &&
    std::all_of(faces, faces + 2,
      [withHighlights](vtkProperty* property)
      {
        return !property ||
          (property->GetLighting() && property->GetInterpolation() != VTK_PBR &&
            property->GetNumberOfTextures() == 0 && !property->GetEdgeVisibility() &&
            (withHighlights || property->GetSpecular() == 0.0));
      });
}

//------------------------------------------------------------------------------
// The largest sum over the lights of one channel of their colour.
double TotalLight(vtkRenderer* renderer)
{
  double total[3] = { 0.0, 0.0, 0.0 };
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    for (int i = 0; i < 3 && light->GetSwitch(); ++i)
    {
      total[i] += light->GetIntensity() * light->GetDiffuseColor()[i];
    }
  }
  return std::max({ total[0], total[1], total[2] });
}

//------------------------------------------------------------------------------
// Whether an actor draws nothing outside its bounds. Impostors, glyphs, wide lines and shaders that
// move vertices may.
bool StaysWithinBounds(vtkActor* actor)
{
  const std::string mapper = actor->GetMapper()->GetClassName();
  // vtkCompositePolyDataMapper2 up to VTK 9.2.
  const bool isComposite =
    mapper == "vtkCompositePolyDataMapper" || mapper == "vtkCompositePolyDataMapper2";
  vtkProperty* property = actor->GetProperty();
  vtkShaderProperty* shader = actor->GetShaderProperty();
  return (mapper == "vtkOpenGLPolyDataMapper" || isComposite) &&
    property->GetRepresentation() == VTK_SURFACE && !property->GetEdgeVisibility() &&
    !property->GetVertexVisibility() && !property->GetRenderPointsAsSpheres() &&
    !property->GetRenderLinesAsTubes() && property->GetLineWidth() <= 1.0F &&
    property->GetPointSize() <= 1.0F &&
    !(shader &&
      (shader->HasVertexShaderCode() || shader->HasGeometryShaderCode() ||
        shader->GetNumberOfShaderReplacements() > 0));
}

//------------------------------------------------------------------------------
// What a mapper draws at the moment: it has one shader for each kind of primitive. This and the
// kinds are protected.
class PrimitiveOf : public vtkOpenGLPolyDataMapper
{
public:
  static bool IsFace(vtkOpenGLPolyDataMapper* mapper)
  {
    const vtkOpenGLHelper* drawn = mapper->*(&PrimitiveOf::LastBoundBO);
    return !drawn || drawn->PrimitiveType == PrimitiveTris ||
      drawn->PrimitiveType == PrimitiveTriStrips;
  }
};

//------------------------------------------------------------------------------
bool DrawsFaces(vtkAbstractMapper* mapper)
{
  if (auto* drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    return PrimitiveOf::IsFace(drawing);
  }
  vtkPolyDataMapper* polyDataMapper = vtkPolyDataMapper::SafeDownCast(mapper);
  vtkPolyData* data = polyDataMapper ? polyDataMapper->GetInput() : nullptr;
  return !data || data->GetNumberOfPolys() > 0 || data->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
bool Contains(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Weights: " << this->Weights.x << " " << this->Weights.y << " " << this->Weights.z
     << "\n";
  os << indent << "Surfaces: " << (this->Surfaces ? "yes" : "no") << "\n";
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkSSAOCapturePass::GetOccludable() const
{
  return this->Outputs > 2 ? this->Occludable.Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkTextureObject* vtkSSAOCapturePass::GetLit() const
{
  return this->Outputs > 3 ? this->Lit.Get() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::HasLostContext() const
{
  // The window releases what belongs to its context.
  return this->Geometry && !this->Geometry->GetHandle();
}

//------------------------------------------------------------------------------
unsigned long vtkSSAOCapturePass::GetTextureMemory() const
{
  return vtkSSAOFullScreenStage::GetBytes(this->Geometry) +
    vtkSSAOFullScreenStage::GetBytes(this->Occludable) +
    vtkSSAOFullScreenStage::GetBytes(this->Lit);
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::CanCompile(const vtkSSAOView& view, bool layers)
{
  if (!this->Compiles[layers])
  {
    // What the parts of the shaders expect of a mapper.
    std::string source = "//VTK::System::Dec\n//VTK::Output::Dec\nuniform vec4 mapper;\n";
    source += layers ? "#define SSAO_LAYERS\n" : "";
    source += "#define SSAO_LIT\n";
    source += vtkSSAOPass1CaptureDeclarationsFS;
    source += vtkSSAOPass0Functions;
    source += "\nvoid main()\n{\n  vec4 vertexVC = mapper;\n"
              "  vec3 normalVCVSOutput = mapper.xyz;\n  vec3 ambientColor = mapper.xyz;\n"
              "  vec3 diffuse = mapper.xyz;\n  gl_FragData[0] = mapper;\n";
    source += layers ? "" : vtkSSAOPass1CaptureFacetFS;
    source += vtkSSAOPass1CaptureLayerFS;
    source += vtkSSAOPass1CaptureLightFS;
    source += layers ? vtkSSAOPass1LayerOutputFS : vtkSSAOPass1CaptureOutputFS;
    source += "}\n";
    this->Compiles[layers] = view.Window->GetShaderCache()->ReadyShaderProgram(
                               vtkSSAOPassFullScreenVS, source.c_str(), "") != nullptr;
  }
  return this->Compiles[layers];
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::Prepare(const vtkRenderState* s, vtkSSAOView& view)
{
  this->Remainder.clear();
  this->Captured.clear();
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = s->GetPropArray()[i];
    (CanBeCaptured(prop) ? this->Captured : this->Remainder).push_back(prop);
  }
  if (view.DepthOrigin > 0.0)
  {
    this->CountDepthsFromProps(view);
  }
}

//------------------------------------------------------------------------------
// Whether the picture itself is the light that may be occluded, wherever a surface was captured.
bool vtkSSAOCapturePass::ShowsOccludableLightOnly(const vtkSSAOView& view) const
{
  vtkRenderWindow* window = view.Window;
  const bool withHighlights = this->Weights.z > 0.0F;
  return (this->Weights.y > 0.0F || withHighlights) && view.Samples == 0 &&
    !window->GetPointSmoothing() && !window->GetLineSmoothing() && !window->GetPolygonSmoothing() &&
    std::all_of(this->Captured.begin(), this->Captured.end(),
      [withHighlights](vtkProp* prop)
      {
        return VisitActors(prop,
          [withHighlights](vtkActor* actor)
          {
            // Translucent ones are drawn later.
            return !actor->HasOpaqueGeometry() || HasOccludableLightOnly(actor, withHighlights);
          });
      });
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::Capture(const vtkRenderState* s, const vtkSSAOView& view)
{
  this->NumberOfRenderedProps = 0;
  const double light = TotalLight(view.Renderer);
  const bool mayExceed = std::any_of(this->Captured.begin(), this->Captured.end(),
    [light](vtkProp* prop)
    {
      return !VisitActors(
        prop, [light](vtkActor* actor) { return !MayExceedPicture(actor, light); });
    });

  // Attachments: 0 the picture, 1 geometry, 2 occludable, 3 lit. Where the picture itself is the
  // light that may be occluded it is not captured once more.
  const bool hides = mayExceed && view.Clamped;
  const bool needsLight =
    this->Weights != glm::vec3(0.0F) && (hides || !this->ShowsOccludableLightOnly(view));
  this->Outputs = needsLight ? (hides ? 4 : 3) : 2;
  this->Perspective = static_cast<float>(view.Projection.Perspective);
  this->DepthOfWindow = view.Projection.DepthOfWindow;
  this->DepthOfClip = view.DepthOfClip;
  this->DepthOrigin = static_cast<float>(view.DepthOrigin);
  this->Surfaces = false;

  const bool attached = this->Attach(view, this->Outputs);
  if (attached)
  {
    this->RenderHooked(s, false);
  }
  this->Detach(view, this->Outputs);
  return attached;
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::CountDepthsFromProps(vtkSSAOView& view)
{
  // VTK's clipping range is much deeper than what a far camera sees.
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  vtkMatrix4x4* viewOfWorld = camera->GetModelViewTransformMatrix();
  double nearest = std::numeric_limits<double>::max();
  double farthest = -nearest;
  bool known = !this->Captured.empty();
  for (vtkProp* prop : this->Captured)
  {
    const double* bounds = prop->GetBounds();
    known = known && bounds && VisitActors(prop, StaysWithinBounds);
    for (int i = 0; i < 8 && known; ++i)
    {
      const double point[4] = { bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)],
        1.0 };
      double positionVC[4];
      viewOfWorld->MultiplyPoint(point, positionVC);
      known = std::isfinite(positionVC[2]);
      nearest = std::min(nearest, -positionVC[2]);
      farthest = std::max(farthest, -positionVC[2]);
    }
  }
  const double* range = camera->GetClippingRange();
  nearest = std::max(nearest, range[0]);
  farthest = std::min(farthest, range[1]);
  const double origin = nearest - std::max(farthest - nearest, 2.0 * camera->GetParallelScale());
  if (known && origin > view.DepthOrigin)
  {
    view.CountDepthsFrom(origin);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::DrawLayers(const vtkRenderState* s, const vtkSSAOView& view,
  vtkTextureObject* before, bool first, double sheet, double reach)
{
  this->LayersBefore = before;
  this->FirstRound = first;
  const glm::dvec2 size(before->GetWidth(), before->GetHeight());
  const glm::dvec4 place = first ? view.PixelOfTexel : glm::dvec4(1.0, 1.0, 0.0, 0.0);
  this->BeforePlace = place / glm::dvec4(size, size);
  this->DeviceOfScene = view.DeviceOfScene;
  this->Sheet = static_cast<float>(sheet);
  this->Reach = static_cast<float>(reach);
  // A few roundings of float32; where the picture is not the one that was captured, the vertices
  // are rounded to other fractions of a pixel.
  this->Margin = glm::vec2(1.0e-6F, view.PixelOfTexel.x > 1.0 ? 0.05F : 0.0F);
  // Of several samples per pixel one was taken, whose depth may be that at another place.
  this->FirstKnown = view.Samples > 0 ? 0.0F : 1.0F;
  const int rendered = this->NumberOfRenderedProps;
  before->Activate();
  this->RenderHooked(s, true);
  before->Deactivate();
  this->NumberOfRenderedProps = rendered;
  this->LayersBefore = nullptr;
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::RenderHooked(const vtkRenderState* s, bool layers)
{
  if (layers != this->Layers)
  {
    // Two shaders for each mapper, both cached by VTK: one with a switch would shade the layers too
    // on a rasteriser that runs both sides of a branch.
    this->Layers = layers;
    this->ShadersChanged.Modified();
  }
  vtkRenderState hooked(s->GetRenderer());
  hooked.SetPropArrayAndCount(this->Captured.data(), static_cast<int>(this->Captured.size()));
  this->PreRender(&hooked);
  this->RenderProps(s, this->Captured);
  this->PostRender(&hooked);
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::DrawsPointSprites() const
{
  return !std::all_of(this->Captured.begin(), this->Captured.end(),
    [](vtkProp* prop)
    {
      return VisitActors(
        prop, [](vtkActor* actor) { return !actor->GetProperty()->GetRenderPointsAsSpheres(); });
    });
}

//------------------------------------------------------------------------------
glm::ivec4 vtkSSAOCapturePass::RectangleOnScreen(const vtkSSAOView& view)
{
  // A pixel more on each side, for the rounding of the rasteriser.
  const glm::dvec2 corner(view.Viewport);
  const glm::dvec2 size(view.Viewport.z, view.Viewport.w);
  glm::dvec2 low(std::numeric_limits<double>::max());
  glm::dvec2 high(-std::numeric_limits<double>::max());
  vtkMatrix4x4* clipOfWorld =
    view.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      view.Renderer->GetTiledAspectRatio(), -1.0, 1.0);
  bool known = true;
  for (vtkProp* prop : this->Captured)
  {
    const double* bounds = prop->GetBounds();
    known = known && bounds && VisitActors(prop, StaysWithinBounds);
    for (int i = 0; i < 8 && known; ++i)
    {
      const double point[4] = { bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)],
        1.0 };
      double clip[4];
      clipOfWorld->MultiplyPoint(point, clip);
      const glm::dvec2 pixel = corner + size * (glm::dvec2(clip[0], clip[1]) / clip[3] * 0.5 + 0.5);
      // False for what is not finite as well.
      known = clip[3] > 0.0 && std::abs(pixel.x) < 1.0e6 && std::abs(pixel.y) < 1.0e6;
      low = glm::min(low, pixel);
      high = glm::max(high, pixel);
    }
  }
  if (!known)
  {
    return view.Viewport;
  }
  const glm::ivec2 first(glm::floor(glm::clamp(low - 1.0, corner, corner + size)));
  const glm::ivec2 end(glm::ceil(glm::clamp(high + 1.0, corner, corner + size)));
  return glm::ivec4(first, glm::max(end - first, glm::ivec2(1)));
}

//------------------------------------------------------------------------------
std::vector<double> vtkSSAOCapturePass::DescribeFrame(const vtkSSAOView& view)
{
  const auto identity = [](const void* object)
  { return static_cast<double>(reinterpret_cast<std::uintptr_t>(object)); };
  std::vector<double> frame = { identity(view.Renderer), identity(view.Window),
    double(view.TextureSize.x), double(view.TextureSize.y), double(view.Samples) };
  for (int i = 0; i < 4; ++i)
  {
    frame.push_back(view.Viewport[i]);
  }
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  vtkMatrix4x4* matrices[2] = { camera->GetModelViewTransformMatrix(),
    camera->GetProjectionTransformMatrix(view.Renderer->GetTiledAspectRatio(), -1.0, 1.0) };
  for (vtkMatrix4x4* matrix : matrices)
  {
    frame.insert(frame.end(), matrix->GetData(), matrix->GetData() + 16);
  }
  // Which of two surfaces in one place is in front may depend on settings of all mappers.
  double factor = 0.0;
  double units = 0.0;
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, units);
  frame.insert(frame.end(),
    { double(vtkMapper::GetResolveCoincidentTopology()), factor, units,
      double(vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces()),
      vtkMapper::GetResolveCoincidentTopologyZShift() });
  for (vtkProp* prop : this->Captured)
  {
    // A prop with levels of detail may choose another one next time, and a shader may move vertices
    // as it likes.
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || std::string(actor->GetClassName()) != "vtkOpenGLActor" ||
      !StaysWithinBounds(actor) ||
      std::string(actor->GetMapper()->GetClassName()) != "vtkOpenGLPolyDataMapper" ||
      (actor->GetShaderProperty() && actor->GetShaderProperty()->HasFragmentShaderCode()))
    {
      return {};
    }
    vtkMapper* mapper = actor->GetMapper();
    // A mapper does not notice that a clipping plane moves.
    vtkPlaneCollection* planes = mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      frame.push_back(double(planes->GetItem(i)->GetMTime()));
    }
    frame.insert(frame.end(),
      { identity(actor), double(actor->GetRedrawMTime()), identity(mapper),
        double(mapper->GetMTime()), double(actor->GetProperty()->GetMTime()) });
    frame.insert(frame.end(), actor->GetMatrix()->GetData(), actor->GetMatrix()->GetData() + 16);
  }
  return frame;
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::RenderRemainder(const vtkRenderState* s)
{
  this->RenderProps(s, this->Remainder);
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::Render(const vtkRenderState* s)
{
  this->OpaquePass->Render(s);
  this->NumberOfRenderedProps = this->OpaquePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::RenderProps(const vtkRenderState* s, std::vector<vtkProp*>& props)
{
  if (props.empty())
  {
    return;
  }
  vtkRenderState state(s->GetRenderer());
  state.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  state.SetFrameBuffer(s->GetFrameBuffer());
  this->OpaquePass->Render(&state);
  this->NumberOfRenderedProps += this->OpaquePass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::Attach(const vtkSSAOView& view, unsigned int outputs)
{
  vtkSmartPointer<vtkTextureObject>* textures[] = { &this->Geometry, &this->Occludable,
    &this->Lit };
  for (unsigned int i = 1; i < outputs; ++i)
  {
    vtkSmartPointer<vtkTextureObject>& texture = *textures[i - 1];
    const glm::ivec2 size = view.TextureSize;
    if (!texture || static_cast<int>(texture->GetSamples()) != view.Samples)
    {
      texture = vtkSSAOFullScreenStage::NewTexture(view.Window, size.x, size.y, 4, view.Samples);
    }
    texture->Resize(size.x, size.y);
    view.Framebuffer->AddColorAttachment(i, texture);
  }

  // Only the captured textures are cleared: the picture is the renderer's.
  vtkOpenGLState* state = view.Window->GetState();
  std::vector<unsigned int> captured;
  for (unsigned int i = 1; i < outputs; ++i)
  {
    captured.push_back(i);
  }
  vtkSSAOFullScreenStage::ForgetDrawBuffers(view.Window, outputs);
  view.Framebuffer->ActivateDrawBuffers(captured.data(), static_cast<int>(captured.size()));
  const char* description = nullptr;
  if (!vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_DRAW_FRAMEBUFFER, description))
  {
    return false;
  }
  vtkOpenGLState::ScopedglClearColor clearColorSaver(state);
  vtkOpenGLState::ScopedglColorMask colorMaskSaver(state);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  view.Framebuffer->ActivateDrawBuffers(outputs);
  return true;
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::Detach(const vtkSSAOView& view, unsigned int outputs)
{
  vtkSSAOFullScreenStage::ForgetDrawBuffers(view.Window, outputs);
  view.Framebuffer->ActivateDrawBuffers(1);
  for (unsigned int i = 1; i < outputs; ++i)
  {
    view.Framebuffer->RemoveColorAttachment(i);
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::PreReplaceShaderValues(std::string& /*vertexShader*/,
  std::string& /*geometryShader*/, std::string& fragmentShader, vtkAbstractMapper* /*mapper*/,
  vtkProp* /*prop*/)
{
  // The tags of VTK are kept and met once only, so that other passes find them too.
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl",
    std::string(LayerTag) + "\n  //VTK::Light::Impl\n  " + LightTag + "\n", false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Picking::Impl",
    std::string(OutputTag) + "\n  //VTK::Picking::Impl", false);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  const bool sprite = Contains(fragmentShader, "ZCalcS");
  // Sphere and stick impostors compute position and normal after derivatives could be taken.
  const bool impostor = sprite || Contains(fragmentShader, "radiusVCVSOutput");
  // VTK lights lines and points too if they have normals, also beside faces of the same data.
  const bool surface = impostor ||
    (DrawsFaces(mapper) && (!actor || actor->GetProperty()->GetRepresentation() == VTK_SURFACE));
  const bool pbr = Contains(fragmentShader, "  color += Lo;\n");
  const bool lit = surface && Contains(fragmentShader, "vec4 vertexVC") &&
    Contains(fragmentShader, "vec3 normalVCVSOutput") && Contains(fragmentShader, LightTag) &&
    (pbr ||
      (Contains(fragmentShader, "vec3 diffuse =") && Contains(fragmentShader, "ambientColor")));

  const bool clipVarying = lit && !impostor && geometryShader.empty();

  std::string declarations;
  declarations += this->Layers ? "#define SSAO_LAYERS\n" : "";
  declarations += lit ? "#define SSAO_LIT\n" : "";
  declarations += lit && pbr ? "#define SSAO_PBR\n" : "";
  declarations += clipVarying ? "#define SSAO_CLIP_VARYING\n" : "";
  declarations += Contains(fragmentShader, "cross(fdx,fdy)") ? "#define SSAO_FLAT\n" : "";
  declarations += sprite ? "#define SSAO_SPRITE\n" : "";
  declarations += impostor ? "#define SSAO_IMPOSTOR\n" : "";
  declarations += Contains(fragmentShader, "lengthVCVSOutput") ? "#define SSAO_STICK\n" : "";
  // Edges are mixed into the ambient colour unlit, or as tubes into all colours.
  // From VTK 9.3 on they have an opacity.
  const std::string edgeMix =
    Contains(fragmentShader, "emix * edgeOpacity") ? "(emix * edgeOpacity)" : "emix";
  declarations += Contains(fragmentShader, "mix( ambientColor, edgeColor, emix") && !pbr
    ? "#define SSAO_EDGES vec3(edgeColor * " + edgeMix + ")\n"
    : "";
  declarations +=
    Contains(fragmentShader, "float emix") ? "#define SSAO_EDGE_MIX " + edgeMix + "\n" : "";
  declarations += vtkSSAOPass1CaptureDeclarationsFS;
  declarations += vtkSSAOPass0Functions;
  vtkShaderProgram::Substitute(
    fragmentShader, "void main()", declarations + "\nvoid main()", false);
  // At the very end, behind all that may set the position.
  const auto append = [](std::string& shader, const char* declaration, const std::string& text)
  {
    shader.insert(shader.rfind('}'), text);
    vtkShaderProgram::Substitute(
      shader, "void main()", std::string(declaration) + "\nvoid main()", false);
  };
  if (clipVarying)
  {
    append(vertexShader, "out float ssaoClipVSOutput;", "  ssaoClipVSOutput = gl_Position.z;\n");
  }
  if (this->Layers)
  {
    const char* declaration = "uniform vec4 ssaoDeviceOfScene;";
    const std::string move = "  gl_Position.xy = gl_Position.xy * ssaoDeviceOfScene.xy +\n"
                             "    gl_Position.w * ssaoDeviceOfScene.zw;\n";
    if (geometryShader.empty())
    {
      append(vertexShader, declaration, move);
    }
    else
    {
      // Impostors have view coordinates before.
      append(geometryShader, declaration, "");
      vtkShaderProgram::Substitute(geometryShader, "EmitVertex();", move + "  EmitVertex();", true);
    }
  }
  if (lit && !impostor && !this->Layers)
  {
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::UniformFlow::Impl",
      std::string(vtkSSAOPass1CaptureFacetFS) + "  //VTK::UniformFlow::Impl", false);
  }
  if (lit && pbr)
  {
    // The sums that VTK's text forms are split as they are formed.
    vtkShaderProgram::Substitute(fragmentShader, "  vec3 Lo = vec3(0.0);\n",
      "  vec3 Lo = vec3(0.0);\n  vec3 ssaoDirectDiffuse = vec3(0.0);\n", false);
    for (const std::string cosine : { "NdV", "NdL" })
    {
      const std::string end = cosine + ";\n";
      const std::string sum = "  Lo += radiance * (diffuse + specular) * " + end;
      std::string sums = sum;
      sums += "  ssaoDirectDiffuse += radiance * diffuse * ";
      sums += end;
      vtkShaderProgram::Substitute(fragmentShader, sum, sums, true);
    }
    vtkShaderProgram::Substitute(fragmentShader, "  color += Lo;\n",
      "  vec3 ssaoImageBased = color;\n  color += Lo;\n", false);
  }
  vtkShaderProgram::Substitute(fragmentShader, LayerTag, vtkSSAOPass1CaptureLayerFS, false);
  vtkShaderProgram::Substitute(fragmentShader, LightTag, vtkSSAOPass1CaptureLightFS, false);
  vtkShaderProgram::Substitute(fragmentShader, OutputTag,
    this->Layers ? vtkSSAOPass1LayerOutputFS : vtkSSAOPass1CaptureOutputFS, false);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSSAOCapturePass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* /*mapper*/, vtkProp* prop, vtkOpenGLVertexArrayObject* /*VAO*/)
{
  this->Surfaces = true;
  vtkProp3D* actor = vtkProp3D::SafeDownCast(prop);
  const bool mirrored = actor && actor->GetMatrix() && actor->GetMatrix()->Determinant() < 0.0;
  program->SetUniformf("ssaoFrontSign", mirrored ? -1.0F : 1.0F);
  if (this->LayersBefore)
  {
    program->SetUniformi("ssaoLayersBefore", this->LayersBefore->GetTextureUnit());
    program->SetUniformf("ssaoFirstRound", this->FirstRound ? 1.0F : 0.0F);
    program->SetUniform4f("ssaoBeforePlace", &this->BeforePlace[0]);
    program->SetUniform4f("ssaoDeviceOfScene", &this->DeviceOfScene[0]);
    program->SetUniformf("ssaoSheet", this->Sheet);
    program->SetUniformf("ssaoReach", this->Reach);
    program->SetUniform2f("ssaoMargin", &this->Margin[0]);
    program->SetUniformf("ssaoFirstKnown", this->FirstKnown);
  }
  program->SetUniform3f("ssaoOccludableWeights", &this->Weights[0]);
  program->SetUniform4f("ssaoDepthOfWindowRows", &this->DepthOfWindow[0]);
  program->SetUniform2f("ssaoDepthOfClip", &this->DepthOfClip[0]);
  program->SetUniformf("ssaoDepthOrigin", this->DepthOrigin);
  program->SetUniformf("ssaoPerspective", this->Perspective);
  return true;
}

//------------------------------------------------------------------------------
void vtkSSAOCapturePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Compiles = {};
  for (auto* texture : { &this->Geometry, &this->Occludable, &this->Lit })
  {
    if (*texture)
    {
      (*texture)->ReleaseGraphicsResources(window);
      *texture = nullptr;
    }
  }
}
