// Stage 2, estimator CrytekSphere: Mittring, "Finding Next Gen: CryEngine 2" (2007). Points in the
// whole ball about the surface, no normal: those behind the captured surface are hidden, on an open
// plane one half. The half rule lets only what is hidden beyond one half count; without it open
// surfaces are grey. The points are reflected at a plane that differs from pixel to pixel.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the visible share, 1 open. Sample points outside the viewport or behind the eye leave the
// divisor: nothing is known of them.
float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  vec3 mirror = ssaoMirror(ssaoNoiseAt(pixel));
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < kernelSize; ++i)
  {
    vec3 sampleVC = positionVC + reflect(ssaoKernelAt(i), mirror) * radius;
    vec2 samplePixel = ssaoPixelOf(sampleVC, rayToPixel, rayOffset, depthSlope, perspective);
    bool known = ssaoIsInView(sampleVC, samplePixel, viewport, perspective);
    float depth = ssaoGeometryAt(samplePixel).x;
    bool behind = depth > float(0.0) && depth <= -sampleVC.z - bias;
    float weight = rangeCheck == 1 ? ssaoRangeCheck(center.x - depth, radius) : float(1.0);
    counted += known ? float(1.0) : float(0.0);
    hidden += known && behind ? weight : float(0.0);
  }
  float visible = float(1.0) - hidden / max(counted, float(1.0));
  return halfRule == 1 ? min(float(2.0) * visible, float(1.0)) : visible;
}
