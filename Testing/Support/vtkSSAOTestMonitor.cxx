// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTestMonitor.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkRenderWindow.h"
#include "vtkSSAOTestOpenGL.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
// VTK's output window: hands all messages to the monitor.
class vtkSSAOTestOutputWindow : public vtkOutputWindow
{
public:
  static vtkSSAOTestOutputWindow* New();
  vtkTypeMacro(vtkSSAOTestOutputWindow, vtkOutputWindow);
  void DisplayText(const char* text) override { this->Add(text); }
  void DisplayErrorText(const char* text) override { this->Add(text); }
  void DisplayWarningText(const char* text) override { this->Add(text); }
  void DisplayGenericWarningText(const char* text) override { this->Add(text); }
  vtkSSAOTestMonitor* Monitor = nullptr;

protected:
  vtkSSAOTestOutputWindow() = default;
  ~vtkSSAOTestOutputWindow() override = default;

private:
  vtkSSAOTestOutputWindow(const vtkSSAOTestOutputWindow&) = delete;
  void operator=(const vtkSSAOTestOutputWindow&) = delete;

  void Add(const char* text)
  {
    if (this->Monitor)
    {
      this->Monitor->AddMessage(text);
    }
  }
};
vtkStandardNewMacro(vtkSSAOTestOutputWindow);

//------------------------------------------------------------------------------
constexpr unsigned int DebugOutput = 0x92E0;
constexpr unsigned int DebugOutputSynchronous = 0x8242;
constexpr unsigned int DebugTypeError = 0x824C;

void ReportOpenGLError(unsigned int, unsigned int type, unsigned int, unsigned int, int,
  const char* message, const void* monitor)
{
  if (type == DebugTypeError)
  {
    auto* to = static_cast<vtkSSAOTestMonitor*>(const_cast<void*>(monitor));
    to->AddMessage(std::string("OpenGL: ") + message);
  }
}

using DebugCallback = decltype(&ReportOpenGLError);
}

//------------------------------------------------------------------------------
vtkSSAOTestMonitor::vtkSSAOTestMonitor()
{
  this->Before = vtkOutputWindow::GetInstance();
  vtkNew<vtkSSAOTestOutputWindow> window;
  window->Monitor = this;
  this->Window = window;
  vtkOutputWindow::SetInstance(this->Window);
}

//------------------------------------------------------------------------------
vtkSSAOTestMonitor::~vtkSSAOTestMonitor()
{
  static_cast<vtkSSAOTestOutputWindow*>(this->Window.Get())->Monitor = nullptr;
  vtkOutputWindow::SetInstance(this->Before);
}

//------------------------------------------------------------------------------
bool vtkSSAOTestMonitor::Expect(bool met, const std::string& what)
{
  std::cout << (met ? "  ok    " : "FAILED  ") << what << std::endl;
  this->Failures += met ? 0 : 1;
  return met;
}

//------------------------------------------------------------------------------
bool vtkSSAOTestMonitor::ExpectEqual(double got, double wanted, const std::string& what)
{
  std::ostringstream text;
  text.precision(9);
  text << what << ": " << got << " (equals " << wanted << ")";
  return this->Expect(got == wanted, text.str());
}

//------------------------------------------------------------------------------
bool vtkSSAOTestMonitor::ExpectNear(
  double got, double wanted, double tolerance, const std::string& what)
{
  std::ostringstream text;
  text.precision(9);
  text << what << ": " << got << " (" << wanted << " to within " << tolerance << ")";
  return this->Expect(std::abs(got - wanted) <= tolerance, text.str());
}

//------------------------------------------------------------------------------
bool vtkSSAOTestMonitor::ExpectAtLeast(double got, double limit, const std::string& what)
{
  std::ostringstream text;
  text.precision(6);
  text << what << ": " << got << " (at least " << limit << ")";
  return this->Expect(got >= limit, text.str());
}

//------------------------------------------------------------------------------
bool vtkSSAOTestMonitor::ExpectAtMost(double got, double limit, const std::string& what)
{
  std::ostringstream text;
  text.precision(6);
  text << what << ": " << got << " (at most " << limit << ")";
  return this->Expect(got <= limit, text.str());
}

//------------------------------------------------------------------------------
void vtkSSAOTestMonitor::Watch(vtkRenderWindow* window)
{
  window->MakeCurrent();
  using Enable = void (*)(unsigned int);
  using SetCallback = void (*)(DebugCallback, const void*);
  auto enable = reinterpret_cast<Enable>(vtkSSAOFindOpenGL("glEnable"));
  auto setCallback = reinterpret_cast<SetCallback>(vtkSSAOFindOpenGL("glDebugMessageCallback"));
  if (enable && setCallback)
  {
    enable(DebugOutput);
    enable(DebugOutputSynchronous);
    setCallback(ReportOpenGLError, this);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTestMonitor::AddMessage(const std::string& message)
{
  if (this->Listening)
  {
    std::cout << "MESSAGE " << message << std::endl;
    this->Messages.push_back(message);
  }
}

//------------------------------------------------------------------------------
int vtkSSAOTestMonitor::GetResult()
{
  this->ExpectEqual(static_cast<double>(this->Messages.size()), 0.0, "messages of VTK and OpenGL");
  std::cout << (this->Failures ? "Expectations not met: " + std::to_string(this->Failures)
                               : std::string("All expectations were met"))
            << std::endl;
  return this->Failures ? EXIT_FAILURE : EXIT_SUCCESS;
}

//------------------------------------------------------------------------------
int vtkSSAOCountObjects(vtkRenderWindow* window, const std::string& kind)
{
  int count = 0;
  window->MakeCurrent();
  using Predicate = unsigned char (*)(unsigned int);
  auto is = reinterpret_cast<Predicate>(vtkSSAOFindOpenGL("glIs" + kind));
  for (unsigned int name = 1; is && name < 5000; ++name)
  {
    count += is(name) ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkSSAOErrorObserver::vtkSSAOErrorObserver(vtkObject* object)
  : Object(object)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long event, void* clientData, void* callData)
    {
      auto* self = static_cast<vtkSSAOErrorObserver*>(clientData);
      self->Errors += event == vtkCommand::ErrorEvent ? 1 : 0;
      self->Warnings += event == vtkCommand::WarningEvent ? 1 : 0;
      self->Text += callData ? static_cast<const char*>(callData) : "";
    });
  for (unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    this->Tags.push_back(object->AddObserver(event, command));
  }
}

//------------------------------------------------------------------------------
vtkSSAOErrorObserver::~vtkSSAOErrorObserver()
{
  for (unsigned long tag : this->Tags)
  {
    this->Object->RemoveObserver(tag);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOErrorObserver::Reset()
{
  this->Errors = 0;
  this->Warnings = 0;
  this->Text.clear();
}
