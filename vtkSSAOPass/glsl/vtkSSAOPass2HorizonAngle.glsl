// Stage 2, estimator HorizonAngle: Bavoil, Sainz, Dimitrov, "Image-Space Horizon-Based Ambient
// Occlusion" (2008). In directions about the pixel, the horizon is searched: the highest elevation
// of what is seen within the radius. Each sample that raises it adds the sine it is raised by,
// attenuated by 1 - (distance / radius)^2. Sines are counted from that of the tangent plane plus
// the angle bias, in the sample's own direction (the better of the two qualities of NVIDIA's
// sample). Elevations are against the plane that faces the viewer; in the source against the view
// plane, which is the same at the picture's centre, but off it a wall that is seen may face away
// from it. The directions turn and the samples shift from pixel to pixel.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns 1 minus the mean over the directions, 1 open. Samples outside the viewport are skipped;
// a direction with none inside leaves the divisor.

// Sine of the elevation, against the plane that faces the viewer, of a tangent plane plus the
// angle bias, at most upright. along: direction in that plane, any length.
float ssaoBiasedTangentSine(vec3 normal, vec3 viewer, vec3 along)
{
  float rise = -dot(normal, along);
  float run = max(dot(normal, viewer), float(0.00001)) * length(along);
  float tangentLength = max(sqrt(rise * rise + run * run), float(1.0e-30));
  float biasedSine = (rise * angleBias.x + run * angleBias.y) / tangentLength;
  float biasedCosine = (run * angleBias.x - rise * angleBias.y) / tangentLength;
  return biasedCosine > float(0.0) ? biasedSine : float(1.0);
}

float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  vec3 normal = ssaoUnpackNormal(center.y);
  vec3 viewer = ssaoTowardsViewer(positionVC, perspective);
  vec4 noise = ssaoNoiseAt(pixel);
  float radiusOnPlane = radius / (perspective * center.x + (float(1.0) - perspective));
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < directions; ++i)
  {
    float turn = (float(i) + noise.x) * float(6.28318530717958648) / float(directions);
    vec2 reach = ssaoTransform2(rayToPixel, vec2(cos(turn), sin(turn)) * radiusOnPlane);
    float highest = float(0.0);
    bool inside = false;
    for (int j = 0; j < steps; ++j)
    {
      vec2 samplePixel =
        floor(pixel + reach * ((float(j) + noise.y) / float(steps))) + vec2(float(0.5), float(0.5));
      vec2 moved = samplePixel - pixel;
      bool known = ssaoIsInViewport(samplePixel, viewport) && dot(moved, moved) > float(0.5);
      float depth = ssaoGeometryAt(samplePixel).x;
      vec3 offset =
        (ssaoPositionVC(samplePixel, depth, pixelToRay, rayOffset, depthSlope, perspective) -
          positionVC) / radius;
      float squared = dot(offset, offset);
      float rise = dot(offset, viewer);
      float above = rise / max(sqrt(squared), float(1.0e-30)) -
        ssaoBiasedTangentSine(normal, viewer, offset - viewer * rise);
      bool raises = known && depth > float(0.0) && squared < float(1.0) && above > highest;
      hidden += raises ? (above - highest) * (float(1.0) - squared) : float(0.0);
      highest = raises ? above : highest;
      inside = inside || known;
    }
    counted += inside ? float(1.0) : float(0.0);
  }
  return clamp(float(1.0) - hidden / max(counted, float(1.0)), float(0.0), float(1.0));
}
