// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOReportView
 * @brief   One view of one scene: its truth, and what each method gives and costs there.
 *
 * All methods draw into the same window, and their frames are interleaved, so that what else the
 * machine does falls on all of them alike. In each round every method draws one timed frame, which
 * is paired with a plain frame drawn shortly before.
 */

#ifndef vtkSSAOReportView_h
#define vtkSSAOReportView_h

#include "vtkSSAOReportMethods.h"
#include "vtkSSAOReportTable.h"
#include "vtkSSAOTruthImage.h"

#include "vtkNew.h" // For members

#include <memory>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;
class vtkSSAOTwin;

class vtkSSAOReportView
{
public:
  struct Settings
  {
    int Width = 800;
    int Height = 600;
    int RaysPerPixel = 256;
    int Rounds = 3; ///< pairs of frames timed per method
    std::string DataDirectory;
    std::string CacheDirectory;
  };

  vtkSSAOReportView(const std::string& scene, int view, const Settings& settings);
  ~vtkSSAOReportView();
  vtkSSAOReportView(const vtkSSAOReportView&) = delete;
  void operator=(const vtkSSAOReportView&) = delete;

  /**
   * Build the scene and trace or read its truth. False with the reason in error.
   */
  bool Prepare(std::string& error);

  /**
   * Measure all methods: one row for each. False, with the reason in error, if a picture could not
   * be made.
   */
  bool Measure(const std::vector<vtkSSAOReportMethod>& methods, std::vector<vtkSSAOReportRow>& rows,
    std::string& error);

  const vtkSSAOTruthImage& GetTruth() const { return this->Truth; }

  /**
   * V of a method that was measured, by its name; empty if there is none.
   */
  std::vector<float> GetVisibility(const std::string& method) const;

private:
  struct Trial;

  double TimeFrame();
  void MeasureCosts(std::vector<Trial>& trials);
  bool MeasureOurs(std::vector<Trial>& trials, std::string& error);
  void MeasureArithmetic(Trial& trial, const vtkSSAOTwin& twin, const std::vector<float>& raw);
  bool MeasureVTK(Trial& trial);
  void ShowVisibilityAsColor();
  void FillErrors(const Trial& trial, vtkSSAOReportRow& row) const;

  std::string Scene;
  int View;
  Settings Options;
  double Radius = 0.0;
  vtkSSAOTruthImage Truth;
  std::vector<std::pair<std::string, std::vector<float>>> Pictures;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

#endif
