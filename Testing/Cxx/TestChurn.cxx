// SPDX-License-Identifier: BSD-3-Clause

// 1,000 times on and off, 300 sizes one after another, a context that is lost again and again: the
// picture stays, and so do the number of OpenGL's objects and the memory in use.

#include "vtkSSAOTestScenes.h"
#include "vtkSSAOTestShapes.h"

#include <atomic>
#include <cstdlib>
#include <new>

#if defined(__has_feature) // of Clang
#define SSAO_HAS_FEATURE(feature) __has_feature(feature)
#else
#define SSAO_HAS_FEATURE(feature) 0
#endif
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !SSAO_HAS_FEATURE(address_sanitizer)
#define SSAO_COUNT_BYTES // elsewhere a sanitizer looks for leaks, or nobody tells a block's size
#include <malloc.h>
#endif

namespace
{
// Of all that C++ has asked for, VTK's objects among it. What the driver takes by malloc is not in
// it: its threads give that back when they come to it, so that its sum is another at every look.
std::atomic<long> BlocksInUse{ 0 };
std::atomic<long> BytesInUse{ 0 };
}

#ifdef SSAO_COUNT_BYTES
//------------------------------------------------------------------------------
void* operator new(std::size_t size)
{
  void* const block = std::malloc(size > 0 ? size : 1);
  if (!block)
  {
    throw std::bad_alloc();
  }
  ++BlocksInUse;
  BytesInUse += static_cast<long>(malloc_usable_size(block));
  return block;
}

//------------------------------------------------------------------------------
void operator delete(void* block) noexcept
{
  if (block)
  {
    --BlocksInUse;
    BytesInUse -= static_cast<long>(malloc_usable_size(block));
    std::free(block);
  }
}

//------------------------------------------------------------------------------
void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}
#endif

namespace
{
using namespace vtkSSAOTest;

const char* const Kinds[] = { "Texture", "Framebuffer", "Renderbuffer", "Program", "Shader",
  "Buffer", "VertexArray" };

//------------------------------------------------------------------------------
std::vector<int> Count(Stage& stage)
{
  std::vector<int> counts;
  for (const char* kind : Kinds)
  {
    counts.push_back(vtkSSAOCountObjects(stage.Window, kind));
  }
  return counts;
}

//------------------------------------------------------------------------------
void ExpectSame(Report& report, const std::string& name, const std::vector<int>& before,
  const std::vector<int>& after)
{
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    report.Equal(name + ", objects of the kind " + Kinds[i], before[i], after[i]);
  }
}

//------------------------------------------------------------------------------
void CheckSwitches(Report& report)
{
  Stage stage(report, 32, 24);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 3, 0.5);
  vtkNew<AOPass> pass;
  const Picture plain = stage.Draw(nullptr);
  const Picture occluded = stage.Draw(pass);
  stage.Draw(nullptr);
  const std::vector<int> before = Count(stage);
  const unsigned long bytes = pass->GetTextureMemory();
  int changes = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const bool on = i % 2 == 0;
    changes +=
      stage.Draw(on ? pass.Get() : nullptr).Values == (on ? occluded : plain).Values ? 0 : 1;
  }
  report.Equal("1,000 switches, changed pictures", 0, changes);
  report.Equal("1,000 switches, texture bytes", bytes, pass->GetTextureMemory());
  ExpectSame(report, "1,000 switches", before, Count(stage));
  // By the pass's own switches, and with a pass of its own each time.
  for (int i = 0; i < 100; ++i)
  {
    pass->SetIntensity(i % 2);
    pass->SetOutputMode(i % 5);
    stage.Draw(pass);
    vtkNew<AOPass> other;
    stage.Draw(other);
    stage.Renderer->SetPass(nullptr);
    other->ReleaseGraphicsResources(stage.Window);
  }
  pass->SetIntensity(1.0);
  pass->SetOutputModeToComposite();
  stage.Draw(pass);
  pass->ReleaseGraphicsResources(stage.Window);
  const std::vector<int> released = Count(stage);
  report.Expect(released[0] < before[0], "released: there are fewer textures than in use");
  stage.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Frames, switches and whole lives of a pass leave no memory behind.
void CheckMemory(Report& report)
{
  Stage stage(report, 32, 24);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 3, 0.5);
  vtkNew<AOPass> pass;
  const auto frames = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      pass->Modified();
      stage.Draw(pass);
      stage.Draw(nullptr);
    }
  };
  const auto lives = [&](int count)
  {
    for (int i = 0; i < count; ++i)
    {
      vtkNew<AOPass> other;
      stage.Draw(other);
      stage.Renderer->SetPass(nullptr);
      other->ReleaseGraphicsResources(stage.Window);
    }
  };
  const auto expectNoGrowth = [&](const std::string& name, const std::function<void(int)>& draw)
  {
    constexpr int count = 40;
    draw(count);
    const long blocksBefore = BlocksInUse;
    const long bytesBefore = BytesInUse;
    draw(count);
    const std::array<long, 2> growth{ BlocksInUse - blocksBefore, BytesInUse - bytesBefore };
    report.Equal("blocks that 40 " + name + " leave behind", 0L, growth[0]);
    // A block may have a few bytes more than were asked for; the least one has 24.
    report.ExpectAtMost(static_cast<double>(growth[1]) / count, 16.0,
      "bytes that each of 40 " + name + " leaves behind");
  };
  expectNoGrowth("frames", frames);
  expectNoGrowth("passes", lives);
  stage.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
void CheckSizes(Report& report, int multiSamples)
{
  const std::string name = "300 sizes, " + std::to_string(multiSamples) + " samples";
  Stage stage(report, 40, 30, multiSamples);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 3, 0.5);
  vtkNew<AOPass> pass;
  const Picture first = stage.Draw(pass);
  stage.Window->SetSize(90, 70); // here silhouettes show, so that layers are drawn
  stage.Draw(pass);
  stage.Window->SetSize(40, 30);
  stage.Draw(pass);
  const std::vector<int> before = Count(stage);
  const unsigned long bytes = pass->GetTextureMemory();
  unsigned int state = 1;
  for (int i = 0; i < 300; ++i)
  {
    state = state * 1103515245U + 12345U;
    stage.Window->SetSize(1 + (state >> 16) % 90, 1 + (state >> 24) % 70);
    stage.Draw(pass);
  }
  stage.Window->SetSize(40, 30);
  report.Same(name, first, stage.Draw(pass), 0.0);
  report.Equal(name + ", texture bytes", bytes, pass->GetTextureMemory());
  ExpectSame(report, name, before, Count(stage));
  stage.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
void CheckLostContext(Report& report)
{
  Stage stage(report, 40, 30);
  vtkSSAOAddFloorAndSpheres(stage.Renderer, 3, 0.5);
  vtkNew<AOPass> pass;
  const Picture first = stage.Draw(pass);
  stage.Window->Finalize();
  stage.Draw(pass);
  const std::vector<int> before = Count(stage);
  for (int i = 0; i < 10; ++i)
  {
    stage.Window->Finalize();
    report.Same("after loss " + std::to_string(i), first, stage.Draw(pass), 0.0);
  }
  ExpectSame(report, "10 losses", before, Count(stage));
  stage.Renderer->SetPass(nullptr);
}
}

//------------------------------------------------------------------------------
int TestChurn(int, char*[])
{
  Report report;
  CheckSwitches(report);
  CheckMemory(report);
  CheckSizes(report, 0);
  CheckSizes(report, 4);
  CheckLostContext(report);
  return report.GetResult();
}
