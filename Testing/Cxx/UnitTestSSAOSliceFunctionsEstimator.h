// SPDX-License-Identifier: BSD-3-Clause

// What LayeredBitmask is compiled with, in the precision of the namespace that includes this.
struct Estimator
{
  vec4 viewport, drawn, pixelToRay, rayToPixel, rayOffset, solidsPlace;
  vec2 depthSlope, sliceTurn;
  float perspective, radius, sheet;
  float ssaoCertainty = 1.0f;
  int directions, steps;
  vec4 ssaoNoiseAt(vec2) { return vec4(0); }
  vec4 ssaoSolidsAt(vec2) { return vec4(0); }
  vec4 ssaoMoreSolidsAt(vec2) { return vec4(0); }
#include "glsl/vtkSSAOPass2LayeredBitmask.glsl"
};
