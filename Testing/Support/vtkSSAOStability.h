// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSSAOStability
 * @brief   One row of the table of Testing/README.md, section "Stability".
 *
 * Keeps the worst figure of each preset and of VTK's own pass in one case, expects ours to stay
 * within what is promised, and prints the row at the end of its life.
 */

#ifndef vtkSSAOStability_h
#define vtkSSAOStability_h

#include <array>
#include <string>

class vtkSSAOTestMonitor;

class vtkSSAOStability
{
public:
  enum Promise
  {
    AtMost,
    AtLeast
  };

  /**
   * name: of the case; measure: what the figure is.
   */
  vtkSSAOStability(vtkSSAOTestMonitor& monitor, const std::string& name, const std::string& measure,
    Promise promise, double limit);
  ~vtkSSAOStability();
  vtkSSAOStability(const vtkSSAOStability&) = delete;
  void operator=(const vtkSSAOStability&) = delete;

  /**
   * A figure of a preset; what: under which circumstances. False if it breaks the promise.
   */
  bool Ours(int preset, double figure, const std::string& what);

  /**
   * The same of VTK's own pass, of which nothing is expected.
   */
  void VTK(double figure, const std::string& what);

private:
  void Keep(int column, double figure);

  vtkSSAOTestMonitor& Monitor;
  std::string Name;
  std::string Measure;
  Promise Wanted;
  double Limit;
  std::array<bool, 4> Known = {}; // Fast, Balanced, Accurate, VTK's pass
  std::array<double, 4> Worst = {};
};

#endif
