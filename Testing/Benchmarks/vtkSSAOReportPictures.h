// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOReportPictures.h
 * @brief  The report's charts and sheets, as PNG.
 */

#ifndef vtkSSAOReportPictures_h
#define vtkSSAOReportPictures_h

#include <string>
#include <vector>

struct vtkSSAOReportRow;

/**
 * One picture of a sheet: V in [0, 1], row by row from the bottom left.
 */
struct vtkSSAOReportPanel
{
  std::string Title;
  std::vector<float> Visibility;
};

/**
 * RMSE (y) against the ratio of cost to VTK's pass with 256 samples (x, logarithmic): one series
 * per family, members joined in the order of their cost, the Pareto front over all rows marked.
 * rows are those of one view, or means. False if the file cannot be written.
 */
bool vtkSSAOWriteErrorAgainstCost(
  const std::vector<vtkSSAOReportRow>& rows, const std::string& title, const std::string& fileName);

/**
 * RMSE (y) against samples per pixel (x, logarithmic), one line per family with more than one
 * member.
 */
bool vtkSSAOWriteErrorAgainstSamples(
  const std::vector<vtkSSAOReportRow>& rows, const std::string& title, const std::string& fileName);

/**
 * A sheet of one view: the truth and the panels as grey pictures in the upper row, below each panel
 * its signed error V - truth in a diverging colour map (blue: too dark, red: too light, white:
 * right; grey where mask is 0) with the scale beside it, and RMSE and bias under each. Pictures
 * have width x height pixels.
 */
bool vtkSSAOWriteSheet(const std::string& title, int width, int height,
  const std::vector<float>& truth, const std::vector<unsigned char>& mask,
  const std::vector<vtkSSAOReportPanel>& panels, const std::string& fileName);

#endif
