// Stage 2, estimator DepthSphere: OGLdev, tutorial 46 ("SSAO With Depth Reconstruction").
// PositionSphere with every depth taken through a depth buffer of 32 bits: what the buffer would
// hold is computed from the captured depth, and the view depth rebuilt from that.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the square of the visible share, 1 open. Sample points outside the viewport or behind
// the eye leave the divisor: nothing is known of them.

// The depth as it comes back from a depth buffer; 0, no surface, stays 0.
float ssaoDepthFromBuffer(float depth)
{
  return depth > float(0.0)
    ? ssaoDepthOfWindow(ssaoWindowOfDepth(depth, depthOfWindow), depthOfWindow)
    : float(0.0);
}

float ssaoVisibility(vec2 pixel, vec4 center)
{
  float centerDepth = ssaoDepthFromBuffer(center.x);
  vec3 positionVC =
    ssaoPositionVC(pixel, centerDepth, pixelToRay, rayOffset, depthSlope, perspective);
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < kernelSize; ++i)
  {
    vec3 sampleVC = positionVC + ssaoKernelAt(i) * radius;
    vec2 samplePixel = ssaoPixelOf(sampleVC, rayToPixel, rayOffset, depthSlope, perspective);
    bool known = ssaoIsInView(sampleVC, samplePixel, viewport, perspective);
    float depth = ssaoDepthFromBuffer(ssaoGeometryAt(samplePixel).x);
    bool behind = depth > float(0.0) && depth <= -sampleVC.z - bias;
    bool inRange = rangeCheck == 0 || abs(centerDepth - depth) < radius;
    counted += known ? float(1.0) : float(0.0);
    hidden += known && behind && inRange ? float(1.0) : float(0.0);
  }
  float visible = float(1.0) - hidden / max(counted, float(1.0));
  return visible * visible;
}
