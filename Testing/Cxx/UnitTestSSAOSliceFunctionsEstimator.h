// SPDX-License-Identifier: BSD-3-Clause

// What the estimators with slices are compiled with, in the precision of the namespace that
// includes this: textures without contents, which count how often they are asked.
struct EstimatorInputs
{
  vec4 viewport, drawn, pixelToRay, rayToPixel, rayOffset, solidsPlace;
  vec2 depthSlope, sliceTurn;
  float perspective, radius, sheet;
  float ssaoCertainty = 1.0f;
  int directions, steps;
  int fetches = 0;
  vec4 ssaoFetch()
  {
    ++this->fetches;
    return vec4(0);
  }
  vec4 ssaoGeometryAt(vec2) { return this->ssaoFetch(); }
  vec4 ssaoNoiseAt(vec2) { return this->ssaoFetch() + vec4(0, 0, 1, 0); } // no turn
  vec4 ssaoSolidsAt(vec2) { return this->ssaoFetch(); }
  vec4 ssaoMoreSolidsAt(vec2) { return this->ssaoFetch(); }
};

struct Estimator : EstimatorInputs
{
#include "glsl/vtkSSAOPass2LayeredBitmask.glsl"
};

struct ExactHorizon : EstimatorInputs
{
#include "glsl/vtkSSAOPass2ExactHorizon.glsl"
};
