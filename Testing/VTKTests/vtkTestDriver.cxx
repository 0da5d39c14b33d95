// SPDX-License-Identifier: BSD-3-Clause
// Runs one of VTK's test programs without editing it, with the pass in every renderer it makes.
//
//   vtkTestDriver <module> <function> plain|zero|open -T <folder> -V <name>.png
//   vtkTestDriver compare <a.png> <b.png>
//
// plain: without the pass; zero: with the pass at Intensity 0; open: with all its stages, and V 1.
// VTK's testing class writes the picture to <folder>, because the baseline <name>.png does not
// exist.

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkScreenSpaceAmbientOcclusionPass.h"
#include "vtkTestingInteractor.h"
#include "vtkTestingObjectFactory.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersion.h"

// Including a header of each registers its OpenGL classes; the programs are not told of them.
#if __has_include("vtkDomainsChemistryModule.h")
#include "vtkDomainsChemistryModule.h"
#endif
#if __has_include("vtkRenderingContext2DModule.h")
#include "vtkRenderingContext2DModule.h"
#endif
#if __has_include("vtkRenderingVolumeModule.h")
#include "vtkRenderingVolumeModule.h"
#endif

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <iostream>
#include <string>

namespace
{
bool Zero = false;

//------------------------------------------------------------------------------
// A renderer that starts with the pass set.
class RendererWithPass : public vtkOpenGLRenderer
{
public:
  static RendererWithPass* New();
  vtkTypeMacro(RendererWithPass, vtkOpenGLRenderer);

protected:
  RendererWithPass()
  {
    vtkNew<vtkScreenSpaceAmbientOcclusionPass> pass;
    if (Zero)
    {
      pass->SetIntensity(0.0);
    }
    else
    {
      pass->SetIntensityScale(0.0);
    }
    this->SetPass(pass);
  }
};
vtkStandardNewMacro(RendererWithPass);
VTK_CREATE_CREATE_FUNCTION(RendererWithPass);

//------------------------------------------------------------------------------
class SubstituteFactory : public vtkObjectFactory
{
public:
  static SubstituteFactory* New();
  vtkTypeMacro(SubstituteFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "vtkRenderer with a pass"; }

protected:
  SubstituteFactory()
  {
    this->RegisterOverride("vtkRenderer", "RendererWithPass", "renderer with a pass", 1,
      vtkObjectFactoryCreateRendererWithPass);
  }
};
vtkStandardNewMacro(SubstituteFactory);

//------------------------------------------------------------------------------
void Override(const char* name, vtkObjectFactory* factory)
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  factories->InitTraversal();
  while (vtkObjectFactory* other = factories->GetNextItem())
  {
    other->Disable(name);
  }
  vtkObjectFactory::RegisterFactory(factory);
}

//------------------------------------------------------------------------------
// Prints the largest difference of a channel and the number of pixels that differ by more than 1.
int Compare(const char* first, const char* second)
{
  vtkNew<vtkPNGReader> readers[2];
  readers[0]->SetFileName(first);
  readers[1]->SetFileName(second);
  readers[0]->Update();
  readers[1]->Update();
  auto* a =
    vtkUnsignedCharArray::SafeDownCast(readers[0]->GetOutput()->GetPointData()->GetScalars());
  auto* b =
    vtkUnsignedCharArray::SafeDownCast(readers[1]->GetOutput()->GetPointData()->GetScalars());
  if (!a || !b || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    std::cout << "sizes" << std::endl;
    return EXIT_FAILURE;
  }
  int largest = 0;
  int pixels = 0;
  const int components = a->GetNumberOfComponents();
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    int here = 0;
    for (int j = 0; j < components; ++j)
    {
      here =
        std::max(here, std::abs(a->GetValue(i * components + j) - b->GetValue(i * components + j)));
    }
    largest = std::max(largest, here);
    pixels += here > 1 ? 1 : 0;
  }
  std::cout << largest << " " << pixels << std::endl;
  return EXIT_SUCCESS;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  if (argc == 4 && !std::strcmp(argv[1], "compare"))
  {
    return Compare(argv[2], argv[3]);
  }
  if (argc < 8)
  {
    return EXIT_FAILURE;
  }
  const std::string mode = argv[3];
  vtkTestingInteractor::TempDirectory = argv[5];
  vtkTestingInteractor::ValidBaseline = argv[7];
  vtkTestingInteractor::DataDirectory = "no data";
  vtkNew<vtkTestingObjectFactory> interactors;
  Override("vtkRenderWindowInteractor", interactors);
  Zero = mode == "zero";
  vtkNew<SubstituteFactory> renderers;
  if (mode != "plain")
  {
    Override("vtkRenderer", renderers);
  }

  void* module = dlopen(argv[1], RTLD_LAZY | RTLD_GLOBAL);
  if (!module)
  {
    std::cerr << dlerror() << std::endl;
    return EXIT_FAILURE;
  }
  const std::string name = argv[2];
  using Function = int (*)(int, char*[]);
  const std::string mangled = "_Z" + std::to_string(name.size()) + name + "iPPc";
  auto function = reinterpret_cast<Function>(dlsym(module, mangled.c_str()));
  if (!function)
  {
    std::cerr << "no function " << name << std::endl;
    return EXIT_FAILURE;
  }
  char* arguments[] = { argv[2], argv[4], argv[5], argv[6], argv[7], nullptr };
  function(5, arguments);
  return EXIT_SUCCESS;
}
