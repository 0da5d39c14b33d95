// SPDX-License-Identifier: BSD-3-Clause
// How far the visibility is from the ray-traced truth of the same view, which threads trace while
// the window goes on. TruthError.cxx is for builds with Embree, NoTruthError.cxx for others.
#ifndef InteractiveViewer_TruthError_h
#define InteractiveViewer_TruthError_h

#include <memory>
#include <string>

class vtkRenderer;
class vtkScreenSpaceAmbientOcclusionPass;

namespace viewer
{
class TruthError
{
public:
  TruthError();
  ~TruthError();
  TruthError(const TruthError&) = delete;
  TruthError& operator=(const TruthError&) = delete;

  static bool IsAvailable();

  /// Begins to trace what the renderer shows now, with the radius of the pass's last frame.
  void Start(vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass);

  /// Forgets it, and ends the threads.
  void Cancel();

  /// Cancels it if camera, size, radius or scene are not those that it was started with.
  void Follow(vtkRenderer* renderer, vtkScreenSpaceAmbientOcclusionPass* pass);

  /// Until it is traced.
  void Wait();

  bool IsWanted() const { return this->Current != nullptr; } // started, and not cancelled
  bool IsTracing() const;

  /// Compares the visibility of the pass's last frame, once the truth is known.
  void Compare(vtkScreenSpaceAmbientOcclusionPass* pass);

  /// The error, or how far tracing is.
  std::string Describe() const;

private:
  struct Job;
  std::unique_ptr<Job> Current; // null: nothing was asked for
};
}

#endif
