// SPDX-License-Identifier: BSD-3-Clause

// Volumes of every blend mode, shaded or not, over, across and behind meshes, stay as they are.

#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkSSAOTestHarmless.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// A ball of fog, drawn by a mapper, centred at a height above the floor.
void AddBall(Stage& stage, vtkVolumeMapper* mapper, bool shade, double height)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 16);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(-0.75, -0.75, -0.75);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    static_cast<unsigned char*>(image->GetScalarPointer())[i] =
      static_cast<unsigned char>(255.0 * std::max(0.0, 1.0 - 1.3 * std::hypot(p[0], p[1], p[2])));
  }
  mapper->SetInputData(image);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.2, 0.4, 1.0);
  color->AddRGBPoint(255.0, 1.0, 0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  // The smallest value of a ray is 0 everywhere.
  opacity->AddPoint(
    0.0, mapper->GetBlendMode() == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? 0.5 : 0.0);
  opacity->AddPoint(255.0, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.2);
  volume->GetProperty()->SetShade(shade);
  volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
  volume->SetPosition(1.0, 0.7, height);
  stage.Renderer->AddVolume(volume);
}

//------------------------------------------------------------------------------
void AddGPUBall(Stage& stage, int mode, bool shade, double height)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->UseJitteringOff();
  mapper->SetSampleDistance(0.05F);
  mapper->SetBlendMode(mode);
  AddBall(stage, mapper, shade, height);
}
}

//------------------------------------------------------------------------------
int TestHarmlessVolumes(int, char*[])
{
  Report report;
  const struct
  {
    const char* Name;
    int Mode;
    bool Shade;
  } kinds[] = { { "composite", vtkVolumeMapper::COMPOSITE_BLEND, true },
    { "unshaded", vtkVolumeMapper::COMPOSITE_BLEND, false },
    { "MIP", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, false },
    { "isosurface", vtkVolumeMapper::ISOSURFACE_BLEND, true },
    { "minimum intensity", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, false },
    { "average", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, false } };
  for (const auto& kind : kinds)
  {
    CheckHarmless(report, std::string("volume, ") + kind.Name + ", over the mesh",
      [&](Stage& stage) { AddGPUBall(stage, kind.Mode, kind.Shade, 1.3); });
    CheckHarmless(report, std::string("volume, ") + kind.Name + ", across and behind the mesh",
      [&](Stage& stage)
      {
        AddGPUBall(stage, kind.Mode, kind.Shade, 0.0);
        AddGPUBall(stage, kind.Mode, kind.Shade, -1.6);
      });
  }
  CheckHarmless(report, "volume, additive, reduced image sampling",
    [](Stage& stage)
    {
      vtkNew<vtkGPUVolumeRayCastMapper> mapper;
      mapper->AutoAdjustSampleDistancesOff();
      mapper->UseJitteringOff();
      mapper->SetSampleDistance(0.05F);
      mapper->SetImageSampleDistance(2.0F);
      mapper->SetBlendModeToAdditive();
      AddBall(stage, mapper, false, 0.3);
    });
  CheckHarmless(report, "volume, vtkSmartVolumeMapper",
    [](Stage& stage)
    {
      vtkNew<vtkSmartVolumeMapper> mapper;
      mapper->SetRequestedRenderModeToGPU();
      mapper->AutoAdjustSampleDistancesOff();
      mapper->SetSampleDistance(0.05F);
      AddBall(stage, mapper, true, 0.3);
    });
  CheckHarmless(report, "volume, cropped and cut",
    [](Stage& stage)
    {
      vtkNew<vtkGPUVolumeRayCastMapper> mapper;
      mapper->AutoAdjustSampleDistancesOff();
      mapper->UseJitteringOff();
      mapper->SetSampleDistance(0.05F);
      mapper->CroppingOn();
      mapper->SetCroppingRegionPlanes(-0.4, 0.5, -0.5, 0.6, -0.6, 0.4);
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(1.0, 0.7, 0.3);
      plane->SetNormal(0.3, 1.0, 0.2);
      mapper->AddClippingPlane(plane);
      AddBall(stage, mapper, true, 0.3);
    });
  HarmlessOptions processor;
  // Without any pass, too, VTK shades it otherwise from one window to the next, by up to 115/255.
  processor.FirstFrame = false;
  CheckHarmless(
    report, "volume, on the processor",
    [](Stage& stage)
    {
      vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
      mapper->SetNumberOfThreads(1);
      mapper->LockSampleDistanceToInputSpacingOn();
      mapper->AutoAdjustSampleDistancesOff();
      AddBall(stage, mapper, true, 0.3);
    },
    processor);
  for (const bool peeled : { false, true })
  {
    // No translucent surfaces.
    CheckHarmless(report, std::string("volume, depth peeling") + (peeled ? " of volumes" : ""),
      [peeled](Stage& stage)
      {
        stage.Renderer->UseDepthPeelingOn();
        stage.Renderer->SetUseDepthPeelingForVolumes(peeled);
        AddGPUBall(stage, vtkVolumeMapper::COMPOSITE_BLEND, true, 0.3);
      });
  }
  HarmlessOptions samples;
  samples.MultiSamples = 4;
  CheckHarmless(
    report, "volume, 4 samples",
    [](Stage& stage) { AddGPUBall(stage, vtkVolumeMapper::COMPOSITE_BLEND, true, 0.3); }, samples);
  return report.GetResult();
}
