// SPDX-License-Identifier: BSD-3-Clause
// The estimators that the pass has.
#ifndef InteractiveViewer_Estimators_h
#define InteractiveViewer_Estimators_h

#include <string>
#include <vector>

namespace viewer
{
struct Estimator
{
  int Value;
  std::string Name;
  bool HasDirections; // its samples are directions x steps, not points of a kernel
};

/// In the order of their values. Found by trying, so that one that is added to the pass is there.
std::vector<Estimator> FindEstimators();
}

#endif
