// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOStability.h"

#include "vtkSSAOTestMonitor.h"
#include "vtkSSAOTestView.h"

#include <iostream>
#include <sstream>

namespace
{
constexpr int ColumnOfVTK = vtkSSAOTestView::NumberOfPresets;
}

//------------------------------------------------------------------------------
vtkSSAOStability::vtkSSAOStability(vtkSSAOTestMonitor& monitor, const std::string& name,
  const std::string& measure, Promise promise, double limit)
  : Monitor(monitor)
  , Name(name)
  , Measure(measure)
  , Wanted(promise)
  , Limit(limit)
{
}

//------------------------------------------------------------------------------
vtkSSAOStability::~vtkSSAOStability()
{
  std::ostringstream row;
  row.precision(3);
  row << "STABILITY | " << this->Name << " | " << this->Measure
      << (this->Wanted == AtMost ? " at most " : " at least ") << this->Limit << " |";
  for (int column = 0; column <= ColumnOfVTK; ++column)
  {
    row << (column == ColumnOfVTK ? " | " : (column ? " / " : " "));
    if (this->Known[column])
    {
      row << this->Worst[column];
    }
    else
    {
      row << "-";
    }
  }
  std::cout << row.str() << " |" << std::endl;
}

//------------------------------------------------------------------------------
void vtkSSAOStability::Keep(int column, double figure)
{
  double& worst = this->Worst[column];
  // NaN is the worst of all, and stays.
  const bool better =
    this->Known[column] && (this->Wanted == AtMost ? figure <= worst : figure >= worst);
  worst = better || worst != worst ? worst : figure;
  this->Known[column] = true;
}

//------------------------------------------------------------------------------
bool vtkSSAOStability::Ours(int preset, double figure, const std::string& what)
{
  this->Keep(preset, figure);
  const std::string text =
    this->Name + ", " + vtkSSAOTestView::GetPresetName(preset) + ", " + what + ": " + this->Measure;
  return this->Wanted == AtMost ? this->Monitor.ExpectAtMost(figure, this->Limit, text)
                                : this->Monitor.ExpectAtLeast(figure, this->Limit, text);
}

//------------------------------------------------------------------------------
void vtkSSAOStability::VTK(double figure, const std::string& what)
{
  this->Keep(ColumnOfVTK, figure);
  std::cout << "  VTK   " << this->Name << ", " << what << ": " << this->Measure << ": " << figure
            << std::endl;
}
