// Stage 2, estimator HemisphereLinearDepth: the first version of LearnOpenGL, "SSAO", where linear
// depth stands in the position buffer's alpha. As Hemisphere, but the surface is compared without
// anything in its favour, so that it hides itself where it is steep or its depth is coarse.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the visible share, 1 open. Sample points outside the viewport or behind the eye leave the
// divisor: nothing is known of them.
float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  vec3 normal = ssaoUnpackNormal(center.y);
  vec4 noise = ssaoNoiseAt(pixel);
  vec3 tangent = ssaoTangent(normal, vec2(noise.z, noise.w));
  vec3 bitangent = cross(normal, tangent);
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < kernelSize; ++i)
  {
    vec3 point = ssaoKernelAt(i);
    vec3 sampleVC =
      positionVC + (tangent * point.x + bitangent * point.y + normal * point.z) * radius;
    vec2 samplePixel = ssaoPixelOf(sampleVC, rayToPixel, rayOffset, depthSlope, perspective);
    bool known = ssaoIsInView(sampleVC, samplePixel, viewport, perspective);
    float depth = ssaoGeometryAt(samplePixel).x;
    bool behind = depth > float(0.0) && depth <= -sampleVC.z - bias;
    float weight = rangeCheck == 1 ? ssaoRangeCheck(center.x - depth, radius) : float(1.0);
    counted += known ? float(1.0) : float(0.0);
    hidden += known && behind ? weight : float(0.0);
  }
  return float(1.0) - hidden / max(counted, float(1.0));
}
