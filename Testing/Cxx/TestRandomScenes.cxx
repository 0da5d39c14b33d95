// SPDX-License-Identifier: BSD-3-Clause

// 500 scenes and settings by chance, the same in every run: no crash, no message, no error of
// OpenGL, and a visibility between 0 and 1 in every pixel. Arguments: first case and number of
// cases.

#include "vtkAssembly.h"
#include "vtkCameraPass.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDiskSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpaquePass.h"
#include "vtkProp3D.h"
#include "vtkSSAOTestCompatibility.h"
#include "vtkSSAOTestEverything.h"
#include "vtkTriangleFilter.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// The same numbers everywhere: Lehmer's generator.
class Chance
{
public:
  explicit Chance(unsigned int seed)
    : State(seed * 2654435761ULL % 2147483646ULL + 1ULL)
  {
    this->Next();
  }
  double Next()
  {
    this->State = this->State * 48271ULL % 2147483647ULL;
    return static_cast<double>(this->State) / 2147483647.0;
  }
  double In(double low, double high) { return low + (high - low) * this->Next(); }
  int Of(int count) { return std::min(static_cast<int>(this->Next() * count), count - 1); }
  bool Likely(double share) { return this->Next() < share; }

private:
  unsigned long long State;
};

//------------------------------------------------------------------------------
// A mesh, now and then one that is broken.
vtkSmartPointer<vtkPolyData> MakeMesh(Chance& chance)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  const int kind = chance.Of(6);
  if (kind < 2)
  {
    mesh->DeepCopy(MakeSphere(chance.In(0.1, 1.0), 3 + chance.Of(20)));
  }
  else if (kind == 2)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(chance.In(0.0, 2.0));
    cube->Update();
    mesh->DeepCopy(cube->GetOutput());
  }
  else if (kind == 3)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(3 + chance.Of(10));
    cone->Update();
    mesh->DeepCopy(cone->GetOutput());
  }
  else if (kind == 4)
  {
    mesh->DeepCopy(MakeStar(chance.Likely(0.5)));
  }
  else
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(1 + chance.Of(4), 1 + chance.Of(4));
    plane->Update();
    mesh->DeepCopy(plane->GetOutput());
  }
  if (chance.Likely(0.3))
  {
    mesh = WithoutNormals(mesh);
  }
  if (chance.Likely(0.15) && mesh->GetNumberOfPoints() > 0)
  {
    const double broken[] = { std::nan(""), 1.0e30, std::numeric_limits<double>::infinity(), 0.0 };
    const double value = broken[chance.Of(4)];
    mesh->GetPoints()->SetPoint(
      chance.Of(static_cast<int>(mesh->GetNumberOfPoints())), value, 0.0, value);
  }
  if (chance.Likely(0.2))
  {
    mesh->GetPointData()->SetScalars(MakeColors(mesh->GetNumberOfPoints()));
  }
  return mesh;
}

//------------------------------------------------------------------------------
void AddProps(vtkRenderer* renderer, Chance& chance, double scale)
{
  const int count = chance.Of(8);
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkActor> actor = MakeActor(MakeMesh(chance));
    if (chance.Likely(0.1))
    {
      vtkNew<vtkGlyph3DMapper> glyphs;
      glyphs->SetInputData(MakeSphere(1.0, 4));
      glyphs->SetSourceData(MakeMesh(chance));
      glyphs->SetScaleFactor(chance.In(0.05, 0.5));
      actor->SetMapper(glyphs);
    }
    actor->GetMapper()->SetScalarVisibility(chance.Likely(0.5));
    vtkProperty* property = actor->GetProperty();
    property->SetColor(chance.Next(), chance.Next(), chance.Next());
    property->SetAmbient(chance.Next());
    property->SetDiffuse(chance.Next());
    property->SetSpecular(chance.Next());
    property->SetInterpolation(chance.Of(4)); // PBR among them
    property->SetRepresentation(chance.Likely(0.8) ? VTK_SURFACE : chance.Of(2));
    property->SetEdgeVisibility(chance.Likely(0.15));
    property->SetVertexVisibility(chance.Likely(0.1));
    property->SetLighting(chance.Likely(0.9));
    property->SetOpacity(chance.Likely(0.8) ? 1.0 : chance.Next());
    property->SetPointSize(static_cast<float>(chance.In(1.0, 9.0)));
    property->SetLineWidth(static_cast<float>(chance.In(1.0, 5.0)));
    property->SetRenderPointsAsSpheres(chance.Likely(0.2));
    // VTK's own shader of tubes does not compile for surfaces that lack normals.
    property->SetRenderLinesAsTubes(chance.Likely(0.2) &&
      property->GetRepresentation() != VTK_SURFACE && !property->GetEdgeVisibility());
    property->SetBackfaceCulling(chance.Likely(0.1));
    actor->SetPosition(
      scale * chance.In(-1.0, 1.0), scale * chance.In(-1.0, 1.0), scale * chance.In(-1.0, 1.0));
    actor->RotateWXYZ(chance.In(0.0, 360.0), chance.Next(), chance.Next(), 0.1);
    actor->SetScale(scale * chance.In(0.2, 1.5), scale * chance.In(0.2, 1.5),
      scale * chance.In(0.2, 1.5) * (chance.Likely(0.1) ? -1.0 : 1.0));
    actor->SetVisibility(chance.Likely(0.95));
    renderer->AddActor(actor);
  }
  if (chance.Likely(0.7))
  {
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-2.0, -1.0, -2.0);
    floor->SetPoint1(2.0, -1.0, -2.0);
    floor->SetPoint2(-2.0, -1.0, 2.0);
    floor->Update();
    vtkSmartPointer<vtkActor> actor = MakeActor(floor->GetOutput());
    actor->SetScale(scale);
    renderer->AddActor(actor);
  }
}

//------------------------------------------------------------------------------
// Now and then what the pass must leave alone, and what it draws in another way.
void AddOthers(vtkRenderer* renderer, Chance& chance, double scale)
{
  Grid grid(2);
  if (chance.Likely(0.15))
  {
    AddTranslucentProps(renderer, grid);
  }
  if (chance.Likely(0.1))
  {
    AddVolume(renderer, grid);
    vtkProp3D::SafeDownCast(renderer->GetViewProps()->GetLastProp())->SetScale(scale);
  }
  if (chance.Likely(0.1))
  {
    AddAnnotations(renderer, grid);
  }
  if (chance.Likely(0.1))
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetNumberOfBlocks(3);
    blocks->SetBlock(0, MakeMesh(chance));
    blocks->SetBlock(2, MakeMesh(chance));
    vtkNew<vtkSSAOTestCompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetScale(scale);
    renderer->AddActor(actor);
  }
  if (chance.Likely(0.1))
  {
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(MakeActor(MakeMesh(chance)));
    assembly->AddPart(MakeActor(MakeMesh(chance)));
    assembly->SetScale(scale);
    renderer->AddActor(assembly);
  }
  if (chance.Likely(0.2))
  {
    renderer->GradientBackgroundOn();
    renderer->SetBackground2(chance.Next(), chance.Next(), chance.Next());
  }
  if (chance.Likely(0.2))
  {
    SetBrightLights(renderer);
  }
}

//------------------------------------------------------------------------------
void PlaceCamera(vtkRenderer* renderer, Chance& chance, double scale)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(chance.Likely(0.3));
  camera->SetPosition(
    scale * chance.In(-4.0, 4.0), scale * chance.In(-0.9, 4.0), scale * chance.In(-4.0, 5.0));
  camera->SetFocalPoint(scale * chance.In(-0.5, 0.5), scale * chance.In(-0.5, 0.5), 0.0);
  camera->SetViewUp(0.1 * chance.Next(), 1.0, 0.05);
  camera->SetViewAngle(chance.Likely(0.2) ? chance.In(0.1, 120.0) : 40.0);
  camera->SetParallelScale(scale * chance.In(0.2, 4.0));
  camera->SetWindowCenter(chance.Likely(0.1) ? 0.4 : 0.0, 0.0);
  const double near = scale * std::pow(10.0, chance.In(-3.0, 0.0));
  camera->SetClippingRange(near, near * std::pow(10.0, chance.In(0.5, 5.0)));
}

//------------------------------------------------------------------------------
// Few programs are built, because each control is a uniform: estimators and denoisers are not.
void SetParameters(AOPass* pass, Chance& chance, double scale)
{
  if (chance.Likely(0.3))
  {
    // As most programs have it.
    const int quality = chance.Of(3);
    quality == 0 ? pass->SetQualityToFast()
                 : (quality == 1 ? pass->SetQualityToBalanced() : pass->SetQualityToAccurate());
    pass->SetRadius(chance.Likely(0.5) ? 0.0 : scale * chance.Next());
    pass->SetOutputModeToComposite();
    return;
  }
  pass->SetEstimator(chance.Of(AOPass::LayeredBitmask + 1));
  pass->SetDenoiser(chance.Of(AOPass::EdgeAware + 1));
  pass->SetModulation(chance.Of(3));
  pass->SetRadius(chance.Likely(0.3) ? 0.0 : scale * std::pow(10.0, chance.In(-4.0, 3.0)));
  pass->SetKernelSize(1 + chance.Of(48));
  pass->SetDirections(1 + chance.Of(6));
  pass->SetSteps(1 + chance.Of(8));
  pass->SetLayers(1 + chance.Of(9));
  pass->SetThickness(chance.Likely(0.7) ? 0.0 : scale * chance.Next());
  pass->SetNoiseSize(1 + chance.Of(9));
  pass->SetDownsampling(1 + chance.Of(4));
  pass->SetAngleBias(chance.In(0.0, 89.0));
  pass->SetHalfRule(chance.Likely(0.5));
  pass->SetRangeCheck(chance.Likely(0.5));
  pass->SetMinimumDifference(chance.Next());
  pass->SetFalloff(chance.Of(3));
  pass->SetAttenuation(std::pow(10.0, chance.In(-2.0, 2.0)));
  chance.Likely(0.5) ? pass->SetBiasToAutomatic() : pass->SetBias(scale * chance.Next());
  pass->SetIntensity(chance.In(0.0, 10.0));
  pass->SetPower(std::pow(10.0, chance.In(-2.0, 1.2)));
  pass->SetIntensityScale(chance.In(0.0, 10.0));
  pass->SetIntensityShift(chance.In(-1.0, 1.0));
  pass->SetOutputMode(chance.Likely(0.5) ? 0 : chance.Of(5));
  pass->SetLayerDownsampling(1 + chance.Of(4));
  pass->SetStageTiming(chance.Likely(0.1));
}

//------------------------------------------------------------------------------
// No delegate, as a rule, or one of those that applications have.
void SetDelegate(AOPass* pass, Chance& chance)
{
  vtkSmartPointer<vtkRenderPass> delegate;
  if (chance.Likely(0.15))
  {
    delegate = vtkSmartPointer<vtkRenderStepsPass>::New();
  }
  else if (chance.Likely(0.1))
  {
    delegate = vtkSmartPointer<vtkOpaquePass>::New();
  }
  else if (chance.Likely(0.1))
  {
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
    delegate = camera;
  }
  pass->SetDelegatePass(delegate);
}

//------------------------------------------------------------------------------
// What is wrong with a case, or nothing.
std::string Draw(Stage& stage, vtkRenderer* renderer, AOPass* pass)
{
  stage.Window->Render();
  vtkNew<vtkImageData> visibility;
  if (pass->GetVisibility(visibility))
  {
    const auto* values = static_cast<const float*>(visibility->GetScalarPointer());
    for (vtkIdType i = 0; i < visibility->GetNumberOfPoints(); ++i)
    {
      // Written so that NaN fails.
      if (!(values[i] >= 0.0F && values[i] <= 1.0F))
      {
        return "visibility " + std::to_string(values[i]);
      }
    }
  }
  const double radius = pass->GetEffectiveRadius();
  if (!(radius >= 0.0) || !std::isfinite(radius))
  {
    return "radius " + std::to_string(radius);
  }
  renderer->RemoveAllViewProps();
  return std::string();
}
}

//------------------------------------------------------------------------------
int TestRandomScenes(int argc, char* argv[])
{
  Report report;
  const bool chosen = argc > 2 && argv[1][0] != '-'; // not the folders that ctest gives
  const int first = chosen ? std::atoi(argv[1]) : 0;
  const int count = chosen ? std::atoi(argv[2]) : 100;
  const int perWindow = 50; // then another size, and other samples
  std::unique_ptr<Stage> stage;
  vtkSmartPointer<AOPass> pass;
  int surfaces = 0;
  for (int i = first; i < first + count; ++i)
  {
    Chance chance(static_cast<unsigned int>(i));
    if (!stage || i % perWindow == 0)
    {
      if (stage)
      {
        stage->Renderer->SetPass(nullptr);
      }
      pass = vtkSmartPointer<AOPass>::New();
      stage = std::make_unique<Stage>(report, 64, 48, i / perWindow % 3 == 2 ? 4 : 0);
      stage->Render();
    }
    // A new renderer for each case: no flag is left over.
    vtkNew<vtkRenderer> renderer;
    stage->Window->RemoveRenderer(stage->Renderer);
    stage->Window->AddRenderer(renderer);
    const double scale = std::pow(10.0, chance.In(-5.0, 5.0));
    AddProps(renderer, chance, scale);
    AddOthers(renderer, chance, scale);
    PlaceCamera(renderer, chance, scale);
    SetParameters(pass, chance, scale);
    SetDelegate(pass, chance);
    if (chance.Likely(0.2))
    {
      renderer->SetViewport(0.5 * chance.Next(), 0.5 * chance.Next(), 0.6 + 0.4 * chance.Next(),
        0.6 + 0.4 * chance.Next());
    }
    // Under multisampling both are errors of OpenGL in VTK, with or without the pass.
    const bool onePerPixel = stage->Window->GetMultiSamples() == 0;
    renderer->SetUseFXAA(chance.Likely(0.1) && onePerPixel);
    renderer->SetUseDepthPeeling(chance.Likely(0.15) && onePerPixel);
    renderer->SetPass(chosen && argc > 3 ? nullptr : pass.Get());
    const std::size_t messages = report.GetMessages().size();
    const std::string wrong = Draw(*stage, renderer, pass);
    if (!wrong.empty() || report.GetMessages().size() > messages)
    {
      report.Expect(false, "case " + std::to_string(i) + ": " + wrong);
    }
    surfaces += pass->GetNumberOfEstimatedPixels() > 0 ? 1 : 0;
    renderer->SetPass(nullptr);
    stage->Window->RemoveRenderer(renderer);
    stage->Window->AddRenderer(stage->Renderer);
  }
  stage->Renderer->SetPass(nullptr);
  report.ExpectAtLeast(surfaces, count / 4, "cases in which something was estimated");
  return report.GetResult();
}
