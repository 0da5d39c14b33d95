// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tests of modulation, output modes, delegates and harmlessness share: pictures and their
 * comparison, a window with one renderer, an unclamped picture in float, and props of every kind.
 */

#ifndef vtkSSAOTestScenes_h
#define vtkSSAOTestScenes_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImageProcessingPass.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPixelBufferObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace vtkSSAOTest
{
using AOPass = vtkScreenSpaceAmbientOcclusionPass;

/// One step of an 8-bit channel.
constexpr double Step = 1.0 / 255.0;

//------------------------------------------------------------------------------
/// RGB values, 0 black and 1 white, rows from the bottom.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Values;

  const float* At(int x, int y) const { return &this->Values[3 * (y * this->Width + x)]; }
  float* At(int x, int y) { return &this->Values[3 * (y * this->Width + x)]; }

  /// A picture whose every value is function(values of the others at the same place).
  template <typename Function, typename... Pictures>
  static Picture Of(Function function, const Picture& first, const Pictures&... others)
  {
    Picture result = first;
    for (std::size_t i = 0; i < result.Values.size(); ++i)
    {
      result.Values[i] = static_cast<float>(function(first.Values[i], others.Values[i]...));
    }
    return result;
  }

  /// The part of width x height pixels whose lower left corner is (x, y).
  Picture Part(int x, int y, int width, int height) const
  {
    Picture part;
    part.Width = width;
    part.Height = height;
    for (int row = y; row < y + height; ++row)
    {
      part.Values.insert(part.Values.end(), this->At(x, row), this->At(x, row) + 3 * width);
    }
    return part;
  }
};

/// Which pixels count.
using Mask = std::function<bool(int x, int y)>;

/// Largest difference of the channels of two pictures at a pixel.
inline double DifferenceAt(const Picture& a, const Picture& b, int x, int y)
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::max(largest, std::abs(double(a.At(x, y)[i]) - b.At(x, y)[i]));
  }
  return largest;
}

/// Pixels that are the same in both pictures, and all their neighbours too.
inline Mask UntouchedPixels(const Picture& a, const Picture& b)
{
  return [&a, &b](int x, int y)
  {
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, a.Height - 1); ++j)
    {
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, a.Width - 1); ++i)
      {
        if (DifferenceAt(a, b, i, j) > 0.0)
        {
          return false;
        }
      }
    }
    return true;
  };
}

/// Pixels in which a picture differs from another.
inline Mask ChangedPixels(const Picture& a, const Picture& b)
{
  return [&a, &b](int x, int y) { return DifferenceAt(a, b, x, y) > 0.0; };
}

/// Pixels whose neighbourhood of 3x3 is nearly of one colour.
inline Mask SmoothPixels(const Picture& picture, double tolerance)
{
  return [&picture, tolerance](int x, int y)
  {
    if (x < 1 || y < 1 || x > picture.Width - 2 || y > picture.Height - 2)
    {
      return false;
    }
    for (int k = 0; k < 27; ++k)
    {
      const float* other = picture.At(x + k % 3 - 1, y + k / 3 % 3 - 1);
      if (std::abs(other[k / 9] - picture.At(x, y)[k / 9]) > tolerance)
      {
        return false;
      }
    }
    return true;
  };
}

//------------------------------------------------------------------------------
/// The expectations of a test about pictures.
class Report : public vtkSSAOTestMonitor
{
public:
  template <typename Value>
  bool Equal(const std::string& what, const Value& expected, const Value& actual)
  {
    return this->Expect(expected == actual,
      what + ": expected " + Report::Text(expected) + ", actual " + Report::Text(actual));
  }

  /// Every pixel of the mask agrees within the tolerance, and the mask holds leastPixels.
  bool Same(const std::string& what, const Picture& expected, const Picture& actual,
    double tolerance, const Mask& mask = {}, int leastPixels = 1)
  {
    if (expected.Width != actual.Width || expected.Height != actual.Height)
    {
      return this->Expect(false, what + ": the pictures differ in size");
    }
    int counted = 0;
    int above = 0;
    int worstX = 0;
    int worstY = 0;
    double worst = -1.0;
    for (int y = 0; y < expected.Height; ++y)
    {
      for (int x = 0; x < expected.Width; ++x)
      {
        if (mask && !mask(x, y))
        {
          continue;
        }
        const double difference = DifferenceAt(expected, actual, x, y);
        ++counted;
        // Written so that NaN fails.
        above += difference <= tolerance + Rounding ? 0 : 1;
        if (!(difference <= worst))
        {
          worst = difference;
          worstX = x;
          worstY = y;
        }
      }
    }
    if (counted < leastPixels)
    {
      return this->Expect(false,
        what + ": expected at least " + std::to_string(leastPixels) +
          " pixels to compare, actual " + std::to_string(counted));
    }
    return this->Expect(above == 0,
      what + ": expected at most " + Steps(tolerance) + " difference, actual " + Steps(worst) +
        " at (" + std::to_string(worstX) + ", " + std::to_string(worstY) + "), there " +
        Colour(expected.At(worstX, worstY)) + " expected, " + Colour(actual.At(worstX, worstY)) +
        " actual; " + std::to_string(above) + " of " + std::to_string(counted) + " pixels above");
  }

  /// At least so many pixels of the mask differ by at least so much: the check before can fail.
  bool Differ(const std::string& what, const Picture& a, const Picture& b, double least,
    int leastPixels, const Mask& mask = {})
  {
    int differing = 0;
    for (int y = 0; y < a.Height; ++y)
    {
      for (int x = 0; x < a.Width; ++x)
      {
        differing += (!mask || mask(x, y)) && DifferenceAt(a, b, x, y) >= least ? 1 : 0;
      }
    }
    return this->Expect(differing >= leastPixels,
      what + ": expected at least " + std::to_string(leastPixels) + " pixels to differ by " +
        Steps(least) + ", actual " + std::to_string(differing));
  }

private:
  // 8-bit values come as floats.
  static constexpr double Rounding = 1.0e-6;

  static std::string Text(const std::string& value) { return value; }
  template <typename Value>
  static std::string Text(const Value& value)
  {
    return std::to_string(value);
  }
  static std::string Steps(double value) { return std::to_string(value * 255.0) + "/255"; }
  static std::string Colour(const float* rgb)
  {
    return "(" + std::to_string(rgb[0]) + " " + std::to_string(rgb[1]) + " " +
      std::to_string(rgb[2]) + ")";
  }
};

//------------------------------------------------------------------------------
/// Draws its delegate into a float texture, which does not clamp, and keeps the colours.
/// Nothing reaches the window.
class FloatPicturePass : public vtkImageProcessingPass
{
public:
  static FloatPicturePass* New() { VTK_STANDARD_NEW_BODY(FloatPicturePass); }
  vtkTypeMacro(FloatPicturePass, vtkImageProcessingPass);

  void Render(const vtkRenderState* s) override
  {
    int size[2];
    int origin[2];
    s->GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkNew<vtkTextureObject> texture;
    texture->SetContext(window);
    texture->Allocate2D(size[0], size[1], 4, VTK_FLOAT);
    vtkNew<vtkOpenGLFramebufferObject> framebuffer;
    framebuffer->SetContext(window);
    window->GetState()->PushFramebufferBindings();
    this->RenderDelegate(s, size[0], size[1], size[0], size[1], framebuffer, texture);
    window->GetState()->PopFramebufferBindings();

    std::vector<float> rgba(4 * size[0] * size[1]);
    unsigned int dimensions[2] = { static_cast<unsigned int>(size[0]),
      static_cast<unsigned int>(size[1]) };
    vtkIdType increments[2] = { 0, 0 };
    vtkPixelBufferObject* pixels = texture->Download();
    pixels->Download2D(VTK_FLOAT, rgba.data(), dimensions, 4, increments);
    pixels->Delete();
    this->Result.Width = size[0];
    this->Result.Height = size[1];
    this->Result.Values.clear();
    for (std::size_t i = 0; i < rgba.size(); i += 4)
    {
      this->Result.Values.insert(this->Result.Values.end(), &rgba[i], &rgba[i + 3]);
    }
    framebuffer->ReleaseGraphicsResources(window);
    texture->ReleaseGraphicsResources(window);
  }

  Picture Result;

protected:
  FloatPicturePass() = default;
  ~FloatPicturePass() override = default;

private:
  FloatPicturePass(const FloatPicturePass&) = delete;
  void operator=(const FloatPicturePass&) = delete;
};

//------------------------------------------------------------------------------
/// A window with one renderer.
class Stage
{
public:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  Stage(vtkSSAOTestMonitor& monitor, int width, int height, int multiSamples = 0)
    : Monitor(monitor)
  {
    this->Window->SetSize(width, height);
    this->Window->SetMultiSamples(multiSamples);
    this->Window->SetOffScreenRendering(1);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.2, 0.3, 0.4);
  }

  vtkCamera* Camera() { return this->Renderer->GetActiveCamera(); }

  /// The window as it was last drawn.
  Picture Read()
  {
    const int* size = this->Window->GetSize();
    Picture picture;
    picture.Width = size[0];
    picture.Height = size[1];
    vtkNew<vtkUnsignedCharArray> bytes;
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, bytes);
    picture.Values.resize(3 * size[0] * size[1]);
    for (std::size_t i = 0; i < picture.Values.size(); ++i)
    {
      picture.Values[i] = bytes->GetValue(static_cast<vtkIdType>(i)) / 255.0F;
    }
    return picture;
  }

  /// The window drawn with a pass; nullptr: without.
  Picture Draw(vtkRenderPass* pass)
  {
    this->Renderer->SetPass(pass);
    this->Render();
    return this->Read();
  }

  void Render()
  {
    this->Window->Render();
    if (!this->Watched)
    {
      this->Watched = true;
      this->Monitor.Watch(this->Window);
    }
  }

  /// The renderer's picture before clamping, drawn by a pass; nullptr: by VTK's render steps.
  Picture DrawUnclamped(vtkRenderPass* pass = nullptr)
  {
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<FloatPicturePass> unclamped;
    unclamped->SetDelegatePass(pass ? pass : static_cast<vtkRenderPass*>(steps));
    this->Renderer->SetPass(unclamped);
    this->Render();
    this->Renderer->SetPass(nullptr);
    steps->ReleaseGraphicsResources(this->Window);
    return unclamped->Result;
  }

private:
  vtkSSAOTestMonitor& Monitor;
  bool Watched = false;
};

//------------------------------------------------------------------------------
/// Make the visibility V of every lit pixel v, whatever was estimated.
inline void ForceVisibility(AOPass* pass, double v)
{
  // Wholly occluded, or not at all where nothing else may switch the pass off.
  pass->SetIntensityScale(v < 1.0 ? 10.0 : 0.0);
  pass->SetIntensityShift(-1.0);
  pass->SetIntensity(v < 1.0 ? 1.0 - v : 1.0);
}

//------------------------------------------------------------------------------
/// A texture of size x size pixels in memory; colour gives 8-bit values for place (s, t) in [0, 1].
inline vtkSmartPointer<vtkTexture> MakeTexture(
  int size, int components, const std::function<std::array<double, 4>(double, double)>& colour)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const std::array<double, 4> rgba = colour((i + 0.5) / size, (j + 0.5) / size);
      for (int k = 0; k < components; ++k)
      {
        *value++ = static_cast<unsigned char>(255.0 * rgba[k] + 0.5);
      }
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->InterpolateOn();
  return texture;
}

/// Smooth waves of all three colours, none of them black.
inline vtkSmartPointer<vtkTexture> MakeWavesTexture(int components = 3)
{
  return MakeTexture(32, components,
    [](double s, double t)
    {
      return std::array<double, 4>{ 0.6 + 0.4 * std::sin(20.0 * s), 0.6 + 0.4 * std::cos(15.0 * t),
        0.5 + 0.3 * std::sin(9.0 * (s + t)), 1.0 };
    });
}

//------------------------------------------------------------------------------
/// An equirectangular environment in linear light, coarse.
inline void SetEnvironment(vtkRenderer* renderer)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 16, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 32; ++i)
    {
      auto* rgb = static_cast<float*>(image->GetScalarPointer(i, j, 0));
      rgb[0] = 0.5F + 0.03F * j;
      rgb[1] = 0.6F + 0.3F * std::sin(0.2F * i);
      rgb[2] = 0.9F - 0.03F * j;
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  renderer->SetEnvironmentTexture(texture);
  auto* openGL = vtkOpenGLRenderer::SafeDownCast(renderer);
  openGL->GetEnvMapLookupTable()->SetLUTSize(64);
  openGL->GetEnvMapLookupTable()->SetLUTSamples(64);
  openGL->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(32);
}

//------------------------------------------------------------------------------
/// A sphere with normals, triangles and n x n resolution.
inline vtkSmartPointer<vtkPolyData> MakeSphere(double radius = 0.45, int n = 24)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(n);
  source->SetPhiResolution(n);
  source->Update();
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->DeepCopy(source->GetOutput());
  return sphere;
}

/// The same data, without normals.
inline vtkSmartPointer<vtkPolyData> WithoutNormals(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  copy->GetPointData()->SetNormals(nullptr);
  copy->GetCellData()->SetNormals(nullptr);
  return copy;
}

/// Texture coordinates by the position in x and y.
inline void AddTextureCoordinates(vtkPolyData* data)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* point = data->GetPoint(i);
    coordinates->InsertNextTuple2(point[0] + 0.5, point[1] + 0.5);
  }
  data->GetPointData()->SetTCoords(coordinates);
}

/// RGB colours that differ from entry to entry.
inline vtkSmartPointer<vtkUnsignedCharArray> MakeColors(vtkIdType number)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < number; ++i)
  {
    colors->InsertNextTuple3(60 + (i * 37) % 190, 40 + (i * 59) % 200, 30 + (i * 83) % 220);
  }
  return colors;
}

/// An actor with a vtkPolyDataMapper, scalars off.
inline vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

//------------------------------------------------------------------------------
/// Where the props of a scene of many stand: rows of squares of size 1 in the plane z = 0.
class Grid
{
public:
  explicit Grid(int columns)
    : Columns(columns)
  {
  }

  /// Put a prop that is centred on the origin into the next square.
  void Place(vtkProp3D* prop)
  {
    prop->AddPosition(this->X(), this->Y(), 0.0);
    this->Skip();
  }
  double X() const { return this->Count % this->Columns; }
  double Y() const { return this->Count / this->Columns; }
  void Skip() { ++this->Count; }

  /// Show all squares, seen from (x, y, z) relative to their middle.
  void Look(vtkRenderer* renderer, bool parallel = false) const
  {
    const int rows = (this->Count + this->Columns - 1) / this->Columns;
    const double middle[3] = { 0.5 * (this->Columns - 1), 0.5 * (rows - 1), 0.0 };
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetFocalPoint(middle);
    // A little askew, so that nothing is exactly on a pixel's border or axis.
    camera->SetPosition(middle[0] + 0.31, middle[1] - 0.57, 3.0 * std::max(this->Columns, rows));
    camera->SetViewUp(0.01, 1.0, 0.0);
    camera->SetViewAngle(20.0);
    camera->SetParallelScale(0.53 * std::max(this->Columns, rows));
    camera->SetClippingRange(
      1.5 * std::max(this->Columns, rows), 4.5 * std::max(this->Columns, rows));
  }

private:
  int Columns;
  int Count = 0;
};

//------------------------------------------------------------------------------
/// The coefficients of many materials, of which parts can be switched off and on.
class LightParts
{
public:
  /// Take part with a property; call it when its coefficients are final.
  void Add(vtkProperty* property)
  {
    this->Materials.push_back(
      { property, property->GetAmbient(), property->GetDiffuse(), property->GetSpecular() });
  }

  void Show(bool ambient, bool diffuse, bool specular)
  {
    for (const Material& material : this->Materials)
    {
      material.Property->SetAmbient(ambient ? material.Ambient : 0.0);
      material.Property->SetDiffuse(diffuse ? material.Diffuse : 0.0);
      material.Property->SetSpecular(specular ? material.Specular : 0.0);
    }
  }

private:
  struct Material
  {
    vtkSmartPointer<vtkProperty> Property;
    double Ambient;
    double Diffuse;
    double Specular;
  };
  std::vector<Material> Materials;
};

//------------------------------------------------------------------------------
/// One light in place of all that the renderer has.
inline void SetHeadlight(vtkRenderer* renderer, double intensity = 1.0)
{
  renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

/// Two coloured distant lights: what a light kit makes of the shaders.
inline void SetDistantLights(vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(i ? -3.0 : 2.0, 1.0, i ? 4.0 : 2.0);
    light->SetColor(i ? 0.3 : 0.6, 0.5, i ? 0.7 : 0.3);
    renderer->AddLight(light);
  }
}

/// A positional lamp, a spot and a distant light, together brighter than 1.
inline void SetBrightLights(vtkRenderer* renderer)
{
  renderer->RemoveAllLights();
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPositional(i < 2);
    light->SetConeAngle(i == 1 ? 40.0 : 90.0);
    light->SetExponent(2.0);
    light->SetAttenuationValues(1.0, 0.02, 0.001);
    light->SetFocalPoint(2.0, 2.0, 0.0);
    light->SetPosition(2.0 * i, 3.0, 6.0);
    light->SetColor(0.9, 1.0 - 0.2 * i, 0.6 + 0.2 * i);
    light->SetIntensity(1.1);
    renderer->AddLight(light);
  }
}
}

#endif
