// SPDX-License-Identifier: BSD-3-Clause

// The same frame twice is the same bit by bit: in one window, after other frames, and in another
// window.

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSSAOImageCompare.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestShapes.h"
#include "vtkSSAOTestView.h"

//------------------------------------------------------------------------------
int TestRepeatable(int, char*[])
{
  vtkSSAOTestMonitor test;
  for (int preset = 0; preset < vtkSSAOTestView::NumberOfPresets; ++preset)
  {
    const std::string what = std::string(vtkSSAOTestView::GetPresetName(preset)) + ": ";
    vtkSSAOTestView view(test, 150, 100);
    vtkSSAOAddStillLife(view);
    vtkSSAOLookAtStillLife(view, false);
    view.SetPreset(preset);
    const vtkSSAOTestImage first = view.Visibility();
    vtkSmartPointer<vtkImageData> picture = view.Picture();

    test.Expect(view.Visibility() == first, what + "V of the next frame");
    test.ExpectEqual(vtkSSAOImageCompare::Difference(view.Picture(), picture, 0).Largest, 0,
      what + "largest difference of the next picture");

    view.Renderer->GetActiveCamera()->Azimuth(20);
    test.Expect(!(view.Visibility() == first), what + "another view has another V");
    vtkSSAOLookAtStillLife(view, true);
    view.Visibility();
    vtkSSAOLookAtStillLife(view, false);
    test.Expect(view.Visibility() == first, what + "V back at the first view");

    view.Pass->SetKernelSize(7);
    view.Pass->SetNoiseSize(3);
    view.Visibility();
    view.SetPreset(preset);
    test.Expect(view.Visibility() == first, what + "V after other settings");

    view.Window->SetSize(70, 90);
    view.Visibility();
    view.Window->SetSize(150, 100);
    test.Expect(view.Visibility() == first, what + "V after another size");

    vtkSSAOTestView other(test, 150, 100);
    vtkSSAOAddStillLife(other);
    vtkSSAOLookAtStillLife(other, false);
    other.SetPreset(preset);
    test.Expect(other.Visibility() == first, what + "V in another window");
    test.Expect(view.Visibility() == first, what + "V beside another window");
  }
  return test.GetResult();
}
