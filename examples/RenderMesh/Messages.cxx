// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define RENDERMESH_POSIX
#include <unistd.h>
#endif

namespace rendermesh
{
namespace
{
/// "ERROR: In file, line 1\nvtkReader (0x1): text\n\n" -> "text", printable and not too long.
std::string OneLine(const std::string& text)
{
  const size_t newline = text.find('\n');
  const size_t firstLine =
    text.substr(0, newline).find(": In ") == std::string::npos ? 0 : newline + 1;
  const size_t object = text.find("): ", firstLine);
  std::string line;
  for (const char c : text.substr(object == std::string::npos ? firstLine : object + 3, 300))
  {
    const auto code = static_cast<unsigned char>(c);
    if (std::isspace(code))
    {
      line += line.empty() || line.back() == ' ' ? "" : " ";
    }
    else
    {
      line += code < 128 && std::isprint(code) ? c : '?';
    }
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

/// VTK's pipeline says that an algorithm failed, in its own terms, besides what the algorithm says.
bool IsAboutPipeline(const std::string& error)
{
  return error.compare(0, 13, "Algorithm vtk") == 0;
}

class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.push_back(OneLine(text)); }
  void DisplayWarningText(const char* text) override
  {
    const std::string line = OneLine(text);
    const bool damage =
      line.find("rror") != std::string::npos || line.find("may fail") != std::string::npos;
    (damage ? this->Errors : this->Warnings).push_back(line);
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
vtkStandardNewMacro(Collector);

std::string Program;

Collector* Collected()
{
  return Collector::SafeDownCast(vtkOutputWindow::GetInstance());
}

#ifdef RENDERMESH_POSIX
int TrueStderr = -1;
std::string CrashLine;

/// Only calls what a signal handler may call.
extern "C" void ReportCrash(int)
{
  const ssize_t written = write(TrueStderr, CrashLine.data(), CrashLine.size());
  _exit(written > 0 ? EXIT_FAILURE : EXIT_FAILURE + 1);
}
#endif
}

//------------------------------------------------------------------------------
void CollectMessages(const std::string& program)
{
  Program = program;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(vtkNew<Collector>());
}

//------------------------------------------------------------------------------
void CheckMessages(const std::string& what)
{
  Collector* collector = Collected();
  if (!collector)
  {
    return;
  }
  const std::vector<std::string> errors = std::exchange(collector->Errors, {});
  const std::vector<std::string> warnings = std::exchange(collector->Warnings, {});
  if (!errors.empty())
  {
    const auto best = std::find_if_not(errors.begin(), errors.end(), IsAboutPipeline);
    throw Failure(
      what + ": " + (best != errors.end() ? *best : "it is damaged or of another format"));
  }
  for (const std::string& warning : warnings)
  {
    std::cerr << Program << ": warning: " << warning << "\n";
  }
}

//------------------------------------------------------------------------------
ReaderGuard::ReaderGuard(const std::string& failed)
{
#ifdef RENDERMESH_POSIX
  std::cerr.flush();
  CrashLine = Program + ": error: " + failed + ": it is damaged, and the reader crashed\n";
  TrueStderr = dup(STDERR_FILENO);
  this->Printed = std::tmpfile();
  if (this->Printed)
  {
    dup2(fileno(this->Printed), STDERR_FILENO);
  }
  std::signal(SIGSEGV, ReportCrash);
  std::signal(SIGABRT, ReportCrash);
#else
  static_cast<void>(failed);
#endif
}

//------------------------------------------------------------------------------
ReaderGuard::~ReaderGuard()
{
#ifdef RENDERMESH_POSIX
  std::signal(SIGSEGV, SIG_DFL);
  std::signal(SIGABRT, SIG_DFL);
  std::cerr.flush();
  std::fflush(stderr);
  dup2(TrueStderr, STDERR_FILENO);
  close(TrueStderr);
  char text[200] = "";
  if (this->Printed)
  {
    std::rewind(this->Printed);
    if (std::fgets(text, sizeof(text), this->Printed) && Collected())
    {
      Collected()->DisplayErrorText(text);
    }
    std::fclose(this->Printed);
  }
#endif
}

//------------------------------------------------------------------------------
double Seconds()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

//------------------------------------------------------------------------------
std::string Quoted(const std::string& text)
{
  return "'" + text + "'";
}

//------------------------------------------------------------------------------
std::string Text(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

//------------------------------------------------------------------------------
Progress::Progress(vtkObject* source, std::string what, bool quiet)
  : Source(source)
  , What(std::move(what))
{
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* fraction)
    { static_cast<Progress*>(self)->Show(*static_cast<double*>(fraction)); });
  if (!quiet)
  {
    this->Source->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  this->Source->RemoveObserver(this->Command);
}

//------------------------------------------------------------------------------
void Progress::Show(double fraction)
{
  this->IsSteady = this->IsSteady && fraction >= this->Fraction;
  this->Fraction = fraction;
  const double now = Seconds();
  if (now - this->LastTime >= 1.0)
  {
    this->LastTime = now;
    const int amount = static_cast<int>(this->IsSteady ? 100.0 * fraction : now - this->StartTime);
    std::cout << this->What << ": " << amount << (this->IsSteady ? " %" : " s") << std::endl;
  }
}

//------------------------------------------------------------------------------
void Update(vtkAlgorithm* filter, const std::string& what, bool quiet)
{
  Progress progress(filter, what, quiet);
  filter->Update();
  CheckMessages("failed at " + what);
}
}
