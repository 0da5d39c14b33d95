// SPDX-License-Identifier: BSD-3-Clause
// What RenderMesh says: one line for an error, and how far a slow step is.
#ifndef RenderMesh_Messages_h
#define RenderMesh_Messages_h

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstdio>
#include <stdexcept>
#include <string>

class vtkAlgorithm;

namespace rendermesh
{
/// Ends the program with one line on stderr and a non-zero exit code.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// From here on VTK's errors and warnings are kept for CheckMessages instead of printed. The
/// program's name begins each line.
void CollectMessages(const std::string& program);

/// Fails with VTK's first error since the last call, if there was one, as "what: error". A warning
/// that speaks of an error counts as one. Otherwise prints VTK's warnings since then.
void CheckMessages(const std::string& what);

/// Put around a reader. While it exists, what the libraries below VTK print on stderr is kept for
/// CheckMessages, and a crash of the reader, as some do in damaged files, ends the program with one
/// line on stderr. Does nothing on systems other than POSIX.
class ReaderGuard
{
public:
  explicit ReaderGuard(const std::string& failed);
  ~ReaderGuard();
  ReaderGuard(const ReaderGuard&) = delete;
  ReaderGuard& operator=(const ReaderGuard&) = delete;

private:
  std::FILE* Printed = nullptr;
};

/// Seconds since some fixed moment.
double Seconds();

/// 'text'
std::string Quoted(const std::string& text);

/// The number as few digits as it needs, at most six.
std::string Text(double number);

/// While it exists, prints how far the algorithm or importer is, at most once a second. Where its
/// fraction jumps back, as vtkSTLReader's does, it prints how long it has taken.
class Progress
{
public:
  Progress(vtkObject* source, std::string what, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

private:
  void Show(double fraction);

  vtkSmartPointer<vtkObject> Source;
  std::string What;
  double StartTime = Seconds();
  double LastTime = StartTime;
  double Fraction = 0.0;
  bool IsSteady = true;
  vtkNew<vtkCallbackCommand> Command;
};

/// Brings a filter up to date with progress lines. Fails as "failed at what: error".
void Update(vtkAlgorithm* filter, const std::string& what, bool quiet);
}

#endif
