// Stage 2, estimator PositionSphere: OGLdev, tutorial 45 ("Screen Space Ambient Occlusion"). The
// same points of the cube about the surface for every pixel, in view coordinates, no normal: those
// behind the captured surface are hidden if that surface is not farther from the centre's depth
// than the radius. The visible share is squared. In the source the points do not scale with the
// radius, which is that of the range check only; here both do.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the square of the visible share, 1 open. Sample points outside the viewport or behind
// the eye leave the divisor: nothing is known of them.
float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < kernelSize; ++i)
  {
    vec3 sampleVC = positionVC + ssaoKernelAt(i) * radius;
    vec2 samplePixel = ssaoPixelOf(sampleVC, rayToPixel, rayOffset, depthSlope, perspective);
    bool known = ssaoIsInView(sampleVC, samplePixel, viewport, perspective);
    float depth = ssaoGeometryAt(samplePixel).x;
    bool behind = depth > float(0.0) && depth <= -sampleVC.z - bias;
    bool inRange = rangeCheck == 0 || abs(center.x - depth) < radius;
    counted += known ? float(1.0) : float(0.0);
    hidden += known && behind && inRange ? float(1.0) : float(0.0);
  }
  float visible = float(1.0) - hidden / max(counted, float(1.0));
  return visible * visible;
}
