// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOImageCompare.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkSSAOTestMonitor.h"
#include "vtkSmartPointer.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace
{
constexpr int Amplification = 16;

//------------------------------------------------------------------------------
void Write(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Read(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
bool SameSize(vtkImageData* a, vtkImageData* b)
{
  return std::equal(a->GetDimensions(), a->GetDimensions() + 3, b->GetDimensions()) &&
    a->GetNumberOfScalarComponents() == b->GetNumberOfScalarComponents() &&
    a->GetScalarType() == VTK_UNSIGNED_CHAR && b->GetScalarType() == VTK_UNSIGNED_CHAR;
}

//------------------------------------------------------------------------------
// Grey in the middle is equal; brighter: the first picture is brighter.
vtkSmartPointer<vtkImageData> AmplifiedDifference(vtkImageData* a, vtkImageData* b)
{
  auto difference = vtkSmartPointer<vtkImageData>::New();
  difference->DeepCopy(a);
  const auto* from = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* with = static_cast<unsigned char*>(b->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(difference->GetScalarPointer());
  const vtkIdType values = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < values; ++i)
  {
    to[i] = static_cast<unsigned char>(
      std::min(std::max(128 + Amplification * (from[i] - with[i]), 0), 255));
  }
  return difference;
}

//------------------------------------------------------------------------------
void ReportFile(const std::string& name, const std::string& path)
{
  std::cout << "<DartMeasurementFile name=\"" << name << "\" type=\"image/png\">" << path
            << "</DartMeasurementFile>" << std::endl;
}
}

//------------------------------------------------------------------------------
vtkSSAOImageCompare::vtkSSAOImageCompare(int argc, char* argv[], vtkSSAOTestMonitor& monitor)
  : Folder(".")
  , Monitor(monitor)
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], "-V") == 0)
    {
      this->Baseline = argv[i + 1];
    }
    else if (std::strcmp(argv[i], "-T") == 0)
    {
      this->Folder = argv[i + 1];
    }
  }
}

//------------------------------------------------------------------------------
vtkSSAODifference vtkSSAOImageCompare::Difference(
  vtkImageData* a, vtkImageData* b, int channelTolerance)
{
  vtkSSAODifference result;
  result.SameSize = SameSize(a, b);
  if (!result.SameSize)
  {
    return result;
  }
  const auto* left = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* right = static_cast<unsigned char*>(b->GetScalarPointer());
  const int components = a->GetNumberOfScalarComponents();
  const vtkIdType pixels = a->GetNumberOfPoints();
  vtkIdType beyond = 0;
  result.Largest = 0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel)
  {
    int largest = 0;
    for (int i = 0; i < components; ++i, ++left, ++right)
    {
      largest = std::max(largest, std::abs(*left - *right));
    }
    result.Largest = std::max(result.Largest, largest);
    beyond += largest > channelTolerance ? 1 : 0;
  }
  result.Fraction = static_cast<double>(beyond) / pixels;
  return result;
}

//------------------------------------------------------------------------------
bool vtkSSAOImageCompare::Compare(
  vtkImageData* picture, const vtkSSAOTolerance& tolerance, const std::string& caseName)
{
  using vtksys::SystemTools;
  const std::string name = SystemTools::GetFilenameWithoutLastExtension(this->Baseline) +
    (caseName.empty() ? "" : "-" + caseName);
  const std::string baseline = SystemTools::GetFilenamePath(this->Baseline) + "/" + name + ".png";
  const std::string got = this->Folder + "/" + name + ".png";
  const std::string diff = this->Folder + "/" + name + ".diff.png";
  const char* accept = std::getenv("SSAO_ACCEPT_BASELINES");
  const bool accepting = accept && std::strcmp(accept, "1") == 0;
  // Files of an earlier run must not be taken for this one's.
  SystemTools::RemoveFile(got);
  SystemTools::RemoveFile(diff);

  bool passed = false;
  if (!SystemTools::FileExists(baseline, true))
  {
    Write(picture, got);
    std::cout << name << ": no baseline. The new picture is " << got << "\n"
              << "Look at it; if it is right, copy it to " << baseline
              << " or run the test again with SSAO_ACCEPT_BASELINES=1" << std::endl;
  }
  else
  {
    vtkSmartPointer<vtkImageData> wanted = Read(baseline);
    const vtkSSAODifference difference = Difference(picture, wanted, tolerance.Channel);
    passed = difference.SameSize && difference.Fraction <= tolerance.Fraction &&
      difference.Largest <= tolerance.Largest;
    std::cout << name << ": largest difference " << difference.Largest << "/255 (at most "
              << tolerance.Largest << "), " << 100.0 * difference.Fraction
              << " % of the pixels beyond " << tolerance.Channel << "/255 (at most "
              << 100.0 * tolerance.Fraction << " %)" << std::endl;
    std::cout << "<DartMeasurement name=\"LargestDifference\" type=\"numeric/integer\">"
              << difference.Largest << "</DartMeasurement>\n"
              << "<DartMeasurement name=\"FractionBeyond\" type=\"numeric/double\">"
              << difference.Fraction << "</DartMeasurement>" << std::endl;
    if (!passed)
    {
      Write(picture, got);
      ReportFile("TestImage", got);
      ReportFile("ValidImage", baseline);
      if (difference.SameSize)
      {
        Write(AmplifiedDifference(picture, wanted), diff);
        ReportFile("DifferenceImage", diff);
        std::cout << "got " << got << "\ndifference x" << Amplification << " " << diff << std::endl;
      }
      else
      {
        std::cout << "got " << got << ", which has another size or format" << std::endl;
      }
    }
  }
  if (!passed && accepting)
  {
    Write(picture, baseline);
    std::cout << name << ": ACCEPTED as the new baseline " << baseline << std::endl;
    passed = true;
  }
  return this->Monitor.Expect(passed, name + " equals its baseline");
}
