// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOReportMethods.h
 * @brief  The methods that the report compares.
 */

#ifndef vtkSSAOReportMethods_h
#define vtkSSAOReportMethods_h

#include "vtkSmartPointer.h" // For return value

#include <functional>
#include <string>
#include <vector>

class vtkImageProcessingPass;
class vtkScreenSpaceAmbientOcclusionPass;

struct vtkSSAOReportMethod
{
  std::string Name;
  std::string Family;
  int Samples = 0;
  bool IsVTK = false; ///< VTK's own pass

  /**
   * A pass for a scene's radius in world units.
   */
  std::function<vtkSmartPointer<vtkImageProcessingPass>(double radius)> NewPass;
};

/**
 * All methods, VTK's own first; quick: only those of the quick report.
 */
std::vector<vtkSSAOReportMethod> vtkSSAOReportMethods(bool quick);

#endif
