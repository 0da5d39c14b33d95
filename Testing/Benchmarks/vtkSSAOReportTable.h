// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOReportTable.h
 * @brief  The rows of the speed-against-error report, and how they are kept on disk.
 */

#ifndef vtkSSAOReportTable_h
#define vtkSSAOReportTable_h

#include <array>
#include <string>
#include <vector>

/**
 * One method on one view of one scene. Times in seconds, errors over the pixels that show opaque
 * geometry with V in [0, 1]. NaN: not measured for this method.
 */
struct vtkSSAOReportRow
{
  std::string Scene;
  std::string Kind; ///< analytic, procedural or real
  int View = 0;
  int Width = 0;
  int Height = 0;
  double Radius = 0.0; ///< world units
  std::string Method;  ///< unique within a view, e.g. "VTK K=64", "Balanced", "Hemisphere K=32"
  std::string Family;  ///< methods that differ in their number of samples only
  int Samples = 0;     ///< samples per pixel, 0 where the method has no such number

  double RootMeanSquare = 0.0;
  double Bias = 0.0; ///< mean of V - truth: above 0 too light
  double Percentile99 = 0.0;
  double Maximum = 0.0;
  double StructuralSimilarity = 0.0;
  double TruthMean = 0.0;          ///< mean of the truth itself
  double TruthStandardError = 0.0; ///< root mean square of the truth's own standard error

  double PlainTime = 0.0;     ///< whole frame without a pass
  double Cost = 0.0;          ///< median over rounds: frame with the pass minus plain frame
  double CostSpread = 0.0;    ///< half the distance of the quartiles of these differences
  double RatioToVTK32 = 0.0;  ///< Cost / cost of VTK's pass with 32 samples in the same view
  double RatioToVTK64 = 0.0;  ///< the same with 64
  double RatioToVTK256 = 0.0; ///< the same with 256
  std::array<double, 5> StageTimes{}; ///< in the order of the pipeline, as StageType
  double TextureBytes = 0.0;

  ///@{
  /**
   * Root mean square of raw V, before any denoiser, in float32 minus its fp64 twin; and of the twin
   * minus the truth. Methods that differ by their denoiser only have the same two numbers.
   */
  double ArithmeticError = 0.0;
  double TwinError = 0.0;
  ///@}
};

class vtkSSAOReportTable
{
public:
  const std::vector<vtkSSAOReportRow>& GetRows() const { return this->Rows; }

  /**
   * Whether there are rows of a view already.
   */
  bool HasView(const std::string& scene, int view, int width, int height) const;

  /**
   * Rows of one view, replacing those there may be.
   */
  void AddView(const std::vector<vtkSSAOReportRow>& rows);

  /**
   * One row per method with the mean over all views (errors) and the geometric mean (ratios of
   * cost); Scene is "mean", StageTimes and TextureBytes are means. Only methods that every view
   * has.
   */
  std::vector<vtkSSAOReportRow> GetMeans() const;

  ///@{
  /**
   * One line per row with a header line; read back what was written. False if the file cannot be
   * written, or has another header or an incomplete line (then it is not read at all).
   */
  bool WriteCSV(const std::string& fileName) const;
  bool ReadCSV(const std::string& fileName);
  ///@}

  /**
   * {"rows": [...], "means": [...]} with the CSV's column names as keys and the facts of the run.
   */
  bool WriteJSON(const std::string& fileName,
    const std::vector<std::pair<std::string, std::string>>& facts) const;

private:
  std::vector<vtkSSAOReportRow> Rows;
};

#endif
