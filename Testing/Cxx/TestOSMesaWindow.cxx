// SPDX-License-Identifier: BSD-3-Clause

// The headless window of vtkSSAOPass::OSMesa: what vtkRenderWindow::New() gives without a display,
// and that it survives all that programs do with windows.

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <GL/gl.h>
#include <dlfcn.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
using Color = std::array<unsigned char, 3>;
const Color Red = { 255, 0, 0 };
const Color Green = { 0, 255, 0 };
const Color Blue = { 0, 0, 255 };

//------------------------------------------------------------------------------
int Failures = 0;
std::string Section;

void Expect(bool passed, const std::string& what)
{
  if (!passed)
  {
    ++Failures;
    std::cerr << Section << ": " << what << "\n";
  }
}

template <typename T>
void ExpectEqual(const T& got, const T& wanted, const std::string& what)
{
  if (got != wanted)
  {
    ++Failures;
    std::cerr << Section << ": " << what << " is " << got << ", not " << wanted << "\n";
  }
}

//------------------------------------------------------------------------------
// OpenGL 1.1 functions as the program itself and VTK see them: the first in the order of loading.
template <typename Function>
Function OpenGL(const char* name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}
#define TEST_GL(name) OpenGL<decltype(&name)>(#name)

// VTK's own windows (9.4 and later) bind OpenGL differently; only ours is looked into that deep.
bool IsOwnWindow(vtkRenderWindow* window)
{
  return std::strcmp(window->GetClassName(), "vtkSSAOOSMesaRenderWindow") == 0;
}

// Errors that VTK clears away unseen come through this callback (OpenGL 4.3).
std::string DebugErrors;
void APIENTRY RecordDebugError(unsigned int, unsigned int type, unsigned int, unsigned int, int,
  const char* message, const void*)
{
  const unsigned int debugTypeError = 0x824C; // GL_DEBUG_TYPE_ERROR
  if (type == debugTypeError)
  {
    DebugErrors += std::string("\n  ") + message;
  }
}

void RecordErrorsOf(vtkRenderWindow* window)
{
  if (!IsOwnWindow(window))
  {
    return;
  }
  window->MakeCurrent();
  using Callback = decltype(&RecordDebugError);
  auto setCallback = OpenGL<void (*)(Callback, const void*)>("glDebugMessageCallback");
  Expect(setCallback != nullptr, "libOSMesa has glDebugMessageCallback");
  if (setCallback)
  {
    TEST_GL(glEnable)(0x92E0); // GL_DEBUG_OUTPUT
    TEST_GL(glEnable)(0x8242); // GL_DEBUG_OUTPUT_SYNCHRONOUS
    setCallback(RecordDebugError, nullptr);
  }
}

void ExpectNoErrors(vtkRenderWindow* window)
{
  if (IsOwnWindow(window))
  {
    window->MakeCurrent();
    ExpectEqual<int>(TEST_GL(glGetError)(), GL_NO_ERROR, "glGetError");
  }
}

//------------------------------------------------------------------------------
// A window that looks at the square [-1, 1]^2 in the plane z = 0, from z = 10 with the clipping
// range 5 ... 25, and at a plane of one colour in it.
struct Scene
{
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;

  Scene(const Color& color, int width, int height, int multiSamples = 0)
  {
    // Larger than the view, so that it fills it.
    this->Plane->SetOrigin(-9, -9, 0);
    this->Plane->SetPoint1(9, -9, 0);
    this->Plane->SetPoint2(-9, 9, 0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Plane->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(color[0] / 255., color[1] / 255., color[2] / 255.);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 10);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1);
    camera->SetClippingRange(5, 25);

    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->SetMultiSamples(multiSamples);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
  }

  // Plane with the lower left part of the view below a slanted line, rest background.
  void SlantThePlane()
  {
    this->Plane->SetOrigin(-9, -9, 0);
    this->Plane->SetPoint1(9, -6.3, 0);
    this->Plane->SetPoint2(-9, 0.1 - 2.7 * 0.5, 0);
  }
};

std::vector<unsigned char> ReadRGBA(vtkRenderWindow* window, int front)
{
  const int* size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  Expect(window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, front, pixels) == VTK_OK,
    "GetRGBACharPixelData succeeds");
  return std::vector<unsigned char>(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

int CountOtherPixels(const std::vector<unsigned char>& pixels, int components, const Color& color)
{
  int others = 0;
  for (std::size_t i = 0; i + components <= pixels.size(); i += components)
  {
    others += std::memcmp(&pixels[i], color.data(), 3) != 0;
  }
  return others;
}

// All pixels of the window, read from the buffer drawn into (0) and from the displayed one (1).
void ExpectColor(vtkRenderWindow* window, const Color& color, const std::string& when)
{
  const int* size = window->GetSize();
  for (int front = 0; front < 2; ++front)
  {
    const std::vector<unsigned char> pixels = ReadRGBA(window, front);
    ExpectEqual(pixels.size(), std::size_t(4) * size[0] * size[1], when + ": values read");
    ExpectEqual(CountOtherPixels(pixels, 4, color), 0,
      when + (front ? ": pixels of another colour on display" : ": pixels of another colour"));
  }
  ExpectNoErrors(window);
}

//------------------------------------------------------------------------------
void TestClasses()
{
  Scene scene(Red, 40, 30);
  Expect(std::strcmp(scene.Window->GetClassName(), "vtkXOpenGLRenderWindow") != 0,
    "the window is not VTK's X window");
  vtkNew<vtkRenderWindowInteractor> interactor;
  Expect(std::strcmp(interactor->GetClassName(), "vtkXRenderWindowInteractor") != 0,
    "the interactor is not VTK's X interactor");

  ExpectEqual(scene.Window->SupportsOpenGL(), 1, "SupportsOpenGL");
  scene.Window->Render();
  const std::string report = scene.Window->ReportCapabilities();
  Expect(report.find("OpenGL version string:") != std::string::npos, "the version is reported");
  Expect(scene.Window->GetDepthBufferSize() >= 24, "the depth buffer has 24 bits or more");
  if (IsOwnWindow(scene.Window)) // VTK's EGL window finds none
  {
    int sizes[4];
    scene.Window->GetColorBufferSizes(sizes);
    Expect(sizes[0] == 8 && sizes[1] == 8 && sizes[2] == 8 && sizes[3] == 8, "8 bits each of RGBA");
  }
  Expect(scene.Window->GetScreenSize()[0] > 0, "the screen has a size");
  Expect(!scene.Window->GetEventPending(), "no event is pending");
}

//------------------------------------------------------------------------------
void TestColor()
{
  Scene scene(Red, 61, 47); // odd: row padding would show
  scene.Window->Render();
  RecordErrorsOf(scene.Window);
  scene.Window->Render();
  ExpectColor(scene.Window, Red, "after Render");

  vtkNew<vtkUnsignedCharArray> rgb;
  scene.Window->GetPixelData(0, 0, 60, 46, 1, rgb);
  const std::vector<unsigned char> values(
    rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues());
  ExpectEqual(values.size(), std::size_t(3 * 61 * 47), "values of GetPixelData");
  ExpectEqual(CountOtherPixels(values, 3, Red), 0, "GetPixelData: pixels of another colour");

  // Position, not only colour: the plane is left of the middle.
  scene.Plane->SetPoint1(0, -9, 0);
  scene.Renderer->SetBackground(0, 0, 1);
  scene.Window->SetSize(60, 40);
  scene.Window->Render();
  const std::vector<unsigned char> halves = ReadRGBA(scene.Window, 0);
  int wrong = 0;
  for (int i = 0; i < 60 * 40; ++i)
  {
    wrong += std::memcmp(&halves[4 * i], (i % 60 < 30 ? Red : Blue).data(), 3) != 0;
  }
  ExpectEqual(wrong, 0, "pixels of the wrong half");
}

//------------------------------------------------------------------------------
void TestDepth()
{
  for (int multiSamples : { 0, 4 })
  {
    Scene scene(Red, 60, 40, multiSamples);
    scene.Plane->SetPoint1(0, -9, 0); // left half
    scene.Window->Render();
    RecordErrorsOf(scene.Window);
    scene.Window->Render();
    vtkNew<vtkFloatArray> depth;
    Expect(scene.Window->GetZbufferData(0, 0, 59, 39, depth) == VTK_OK, "GetZbufferData succeeds");
    ExpectEqual<int>(depth->GetNumberOfValues(), 60 * 40, "depth values");
    int wrong = 0;
    for (int i = 0; i < depth->GetNumberOfValues(); ++i)
    {
      const double wanted = i % 60 < 30 ? (10. - 5.) / (25. - 5.) : 1.;
      wrong += !(std::abs(depth->GetValue(i) - wanted) < 1e-6);
    }
    ExpectEqual(wrong, 0, "wrong depths with " + std::to_string(multiSamples) + " samples");
    ExpectNoErrors(scene.Window);
  }
}

//------------------------------------------------------------------------------
void TestImageFilter()
{
  Scene scene(Green, 50, 40);
  for (int scale : { 1, 3 })
  {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(scene.Window);
    filter->SetScale(scale);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    ExpectEqual(image->GetDimensions()[0], 50 * scale, "image width");
    ExpectEqual(image->GetDimensions()[1], 40 * scale, "image height");
    const unsigned char* data = static_cast<unsigned char*>(image->GetScalarPointer());
    const std::vector<unsigned char> values(data, data + 3 * image->GetNumberOfPoints());
    ExpectEqual(CountOtherPixels(values, 3, Green), 0, "image pixels of another colour");
  }
  ExpectNoErrors(scene.Window);
}

//------------------------------------------------------------------------------
void TestResize()
{
  Scene scene(Red, 100, 80);
  scene.Window->Render();
  RecordErrorsOf(scene.Window);
  void* context = scene.Window->GetGenericContext();
  const int sizes[][2] = { { 173, 91 }, { 37, 211 }, { 1, 1 }, { 640, 480 }, { 100, 80 } };
  for (const auto& size : sizes)
  {
    scene.Window->SetSize(size[0], size[1]);
    ExpectEqual(scene.Window->GetSize()[0], size[0], "width");
    ExpectEqual(scene.Window->GetSize()[1], size[1], "height");
    scene.Window->Render();
    ExpectColor(scene.Window, Red, "at " + std::to_string(size[0]) + "x" + std::to_string(size[1]));
  }
  if (IsOwnWindow(scene.Window))
  {
    ExpectEqual(scene.Window->GetGenericContext(), context, "the context after the resizes");
  }

  Scene unset(Blue, 0, 0); // no size was given: VTK's default
  unset.Window->Render();
  ExpectEqual(unset.Window->GetSize()[0], 300, "default width");
  ExpectColor(unset.Window, Blue, "at the default size");
}

//------------------------------------------------------------------------------
void TestSeveralWindows()
{
  Scene red(Red, 80, 60);
  {
    Scene green(Green, 33, 120, 4);
    for (int i = 0; i < 3; ++i)
    {
      red.Window->Render();
      green.Window->Render();
    }
    RecordErrorsOf(red.Window);
    RecordErrorsOf(green.Window);
    red.Window->Render();
    green.Window->Render();
    // Read in the other order than drawn.
    ExpectColor(red.Window, Red, "first of two windows");
    ExpectColor(green.Window, Green, "second of two windows");
    if (IsOwnWindow(red.Window))
    {
      green.Window->MakeCurrent();
      Expect(green.Window->IsCurrent() && !red.Window->IsCurrent(), "one window is current");
    }
  } // the current one goes
  ExpectColor(red.Window, Red, "after the other window was deleted");
  red.Window->Render();
  ExpectColor(red.Window, Red, "drawn after the other window was deleted");

  // Oldest first, and one that is not current.
  std::vector<Scene*> scenes;
  for (int i = 0; i < 4; ++i)
  {
    scenes.push_back(new Scene(Blue, 20 + i, 20));
    scenes.back()->Window->Render();
  }
  for (int i : { 0, 2, 1 })
  {
    delete scenes[i];
    scenes[3]->Window->Render();
    ExpectColor(scenes[3]->Window, Blue, "after the deletion of an older window");
  }
  delete scenes[3];

  // One actor in two windows: its buffers move from context to context.
  {
    Scene first(Red, 30, 30);
    Scene second(Green, 40, 40);
    second.Renderer->RemoveAllViewProps();
    second.Renderer->AddActor(first.Actor);
    for (int i = 0; i < 2; ++i)
    {
      first.Window->Render();
      second.Window->Render();
      ExpectColor(first.Window, Red, "shared actor in the first window");
      ExpectColor(second.Window, Red, "shared actor in the second window");
    }
  }

  // A renderer that goes on to another window.
  Scene before(Red, 30, 30);
  before.Window->Render();
  vtkNew<vtkRenderWindow> after;
  after->SetMultiSamples(0);
  after->SetSize(50, 20);
  before.Window->RemoveRenderer(before.Renderer);
  after->AddRenderer(before.Renderer);
  before.Window = nullptr;
  after->Render();
  ExpectColor(after, Red, "renderer moved to another window");
}

//------------------------------------------------------------------------------
void TestReleaseAndRenderAgain()
{
  Scene scene(Red, 48, 48);
  scene.Window->Finalize(); // before there is anything
  scene.Window->Render();
  ExpectColor(scene.Window, Red, "first render");
  for (int i = 0; i < 2; ++i)
  {
    scene.Window->ReleaseGraphicsResources(scene.Window);
    scene.Window->Render();
    ExpectColor(scene.Window, Red, "after ReleaseGraphicsResources");
    scene.Window->Finalize();
    scene.Window->Render();
    RecordErrorsOf(scene.Window);
    ExpectColor(scene.Window, Red, "after Finalize");
    scene.Window->WindowRemap();
    scene.Window->Render();
    ExpectColor(scene.Window, Red, "after WindowRemap");
  }
  scene.Window->Finalize();
  scene.Window->Finalize();
}

//------------------------------------------------------------------------------
double ResidentMegabytes()
{
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void TestRecreation()
{
  const auto create = [](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      Scene scene(i % 2 ? Red : Green, 64 + i % 3, 64);
      scene.Window->Render();
      ExpectEqual(
        CountOtherPixels(ReadRGBA(scene.Window, 1), 4, i % 2 ? Red : Green), 0, "wrong pixels");
    }
  };
  create(50); // caches and the allocator settle
  const double before = ResidentMegabytes();
  create(200);
  const double growth = ResidentMegabytes() - before;
  // One lost context would be some megabytes, a lost framebuffer of this size about 0.1.
  Expect(growth < 10, "200 windows left " + std::to_string(growth) + " MB behind");
}

//------------------------------------------------------------------------------
void TestMultiSamples()
{
  const int size = 64;
  Scene aliased(Red, size, size, 0);
  Scene smooth(Red, size, size, 4);
  for (Scene* scene : { &aliased, &smooth })
  {
    scene->SlantThePlane();
    scene->Window->Render();
    RecordErrorsOf(scene->Window);
    scene->Window->Render();
    ExpectNoErrors(scene->Window);
  }
  ExpectEqual(smooth.Window->GetMultiSamples(), 4, "samples");
  for (int front = 0; front < 2; ++front)
  {
    const std::vector<unsigned char> hard = ReadRGBA(aliased.Window, front);
    const std::vector<unsigned char> soft = ReadRGBA(smooth.Window, front);
    int mixedHard = 0;
    int mixedSoft = 0;
    int wrong = 0;
    int covered = 0;
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        const unsigned char h = hard[4 * (y * size + x)];
        const unsigned char s = soft[4 * (y * size + x)];
        mixedHard += h != 0 && h != 255;
        mixedSoft += s != 0 && s != 255;
        covered += h == 255;
        // Away from the edge both pictures are the same.
        bool edge = false;
        for (int dy = -1; dy <= 1; ++dy)
        {
          const int row = y + dy;
          edge |= row >= 0 && row < size && hard[4 * (row * size + x)] != h;
        }
        wrong += !edge && h != s;
      }
    }
    Expect(covered > size * size / 4 && covered < size * size * 3 / 4, "the edge is in the view");
    ExpectEqual(mixedHard, 0, "mixed pixels without samples");
    Expect(mixedSoft > size / 4, "the edge is smooth with 4 samples");
    ExpectEqual(wrong, 0, "pixels away from the edge that samples change");
  }

  // From one to the other in the same window; more than there are is cut to what there is.
  smooth.Window->SetMultiSamples(0);
  smooth.Window->Render();
  Expect(ReadRGBA(smooth.Window, 1) == ReadRGBA(aliased.Window, 1), "samples can be switched off");
  aliased.Window->SetMultiSamples(16);
  aliased.Window->Render();
  Expect(aliased.Window->GetMultiSamples() >= 4 && aliased.Window->GetMultiSamples() <= 16,
    "too many samples are cut");
  Expect(ReadRGBA(smooth.Window, 1) != ReadRGBA(aliased.Window, 1), "samples can be switched on");
}

//------------------------------------------------------------------------------
void TestOffScreen()
{
  Scene scene(Blue, 40, 40);
  for (int i = 0; i < 2; ++i)
  {
    scene.Window->SetOffScreenRendering(1);
    scene.Window->Render();
    RecordErrorsOf(scene.Window);
    ExpectColor(scene.Window, Blue, "off screen");
    if (IsOwnWindow(scene.Window))
    {
      // VTK's EGL window is off screen too, but says otherwise.
      scene.Window->SetOffScreenRendering(0);
      Expect(scene.Window->GetOffScreenRendering() && scene.Window->GetUseOffScreenBuffers(),
        "the window stays off screen");
    }
    scene.Window->SetFullScreen(1);
    scene.Window->SetPosition(10, 10);
    scene.Window->SetWindowName("window");
    scene.Window->HideCursor();
    scene.Window->Render();
    ExpectColor(scene.Window, Blue, "on screen");
    scene.Window->SetFullScreen(0);
    scene.Window->ShowCursor();
  }
}

//------------------------------------------------------------------------------
void TestStencil()
{
  for (int multiSamples : { 0, 4 })
  {
    Scene scene(Red, 32, 32, multiSamples);
    scene.Window->Render(); // without
    scene.Window->SetStencilCapable(1);
    scene.Window->Render();
    RecordErrorsOf(scene.Window);
    scene.Window->Render();
    ExpectColor(scene.Window, Red, "with stencil");
    auto window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
    if (!IsOwnWindow(window) || multiSamples)
    {
      continue; // stencils with samples cannot be read
    }
    window->SetSize(64, 48);
    window->Render();
    window->GetRenderFramebuffer()->Bind();
    window->GetRenderFramebuffer()->ActivateReadBuffer(0);
    TEST_GL(glClearStencil)(0x5a);
    TEST_GL(glClear)(GL_STENCIL_BUFFER_BIT);
    unsigned char stencil = 0;
    TEST_GL(glReadPixels)(16, 16, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
    ExpectEqual<int>(stencil, 0x5a, "stencil value");
    window->GetRenderFramebuffer()->UnBind();
    window->SetStencilCapable(0);
    window->Render();
    ExpectColor(window, Red, "without stencil again");
  }
}

//------------------------------------------------------------------------------
void TestInteractor()
{
  Scene scene(Red, 40, 40);
  vtkNew<vtkRenderWindowInteractor> interactor;
  if (std::strcmp(interactor->GetClassName(), "vtkTestingInteractor") == 0)
  {
    std::cerr << Section << ": skipped, this test driver brings an interactor of its own\n";
    return;
  }
  interactor->SetRenderWindow(scene.Window);

  int presses = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&presses);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  interactor->AddObserver(vtkCommand::LeftButtonPressEvent, count);

  interactor->Initialize();
  Expect(interactor->GetInitialized() != 0, "the interactor is initialized");
  ExpectColor(scene.Window, Red, "after Initialize");
  interactor->ProcessEvents();
  scene.Window->Render();
  interactor->Start(); // returns: there are no events to wait for
  interactor->SetEventInformation(20, 20);
  interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent); // the default style sets a timer
  interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  ExpectEqual(presses, 1, "events observed");
  interactor->UpdateSize(70, 30);
  ExpectEqual(scene.Window->GetSize()[0], 70, "width after UpdateSize");
  interactor->Render();
  ExpectColor(scene.Window, Red, "after UpdateSize");
  interactor->TerminateApp();

  // Start without Initialize, and the interactor deleted before its window.
  Scene other(Green, 30, 30);
  {
    vtkNew<vtkRenderWindowInteractor> second;
    second->SetRenderWindow(other.Window);
    second->Start();
    Expect(second->GetInitialized() != 0, "Start initializes");
    second->SetRenderWindow(nullptr);
    other.Window->SetInteractor(nullptr);
  }
  other.Window->Render();
  ExpectColor(other.Window, Green, "after the interactor is gone");
}
}

//------------------------------------------------------------------------------
int TestOSMesaWindow(int, char*[])
{
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");

  const std::vector<std::pair<std::string, std::function<void()>>> sections = {
    { "Classes", TestClasses },
    { "Color", TestColor },
    { "Depth", TestDepth },
    { "ImageFilter", TestImageFilter },
    { "Resize", TestResize },
    { "SeveralWindows", TestSeveralWindows },
    { "ReleaseAndRenderAgain", TestReleaseAndRenderAgain },
    { "Recreation", TestRecreation },
    { "MultiSamples", TestMultiSamples },
    { "OffScreen", TestOffScreen },
    { "Stencil", TestStencil },
    { "Interactor", TestInteractor },
  };
  // VTK's EGL window (9.6) fails some of these itself: actors in two windows, Finalize and render.
  const bool own = IsOwnWindow(vtkNew<vtkRenderWindow>());
  const std::set<std::string> onlyOwn = { "SeveralWindows", "ReleaseAndRenderAgain", "Recreation" };
  for (const auto& section : sections)
  {
    Section = section.first;
    if (!own && onlyOwn.count(Section))
    {
      std::cerr << Section << ": skipped, the window is VTK's own\n";
      continue;
    }
    DebugErrors.clear();
    vtkNew<vtkStringOutputWindow> messages; // in place of VTK's own, which prints to the console
    vtkOutputWindow::SetInstance(messages);
    section.second();
    vtkOutputWindow::SetInstance(nullptr);
    Expect(messages->GetOutput().empty(), "VTK says\n" + messages->GetOutput());
    Expect(DebugErrors.empty(), "OpenGL errors:" + DebugErrors);
  }

  if (Failures)
  {
    std::cerr << Failures << " checks failed\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
