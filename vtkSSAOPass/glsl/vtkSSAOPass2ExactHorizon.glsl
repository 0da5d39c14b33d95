// Stage 2, estimator ExactHorizon: Jimenez, Wu, Pesce, Jarabo, "Practical Realtime Strategies for
// Accurate Indirect Occlusion" (2016). In slices through the view direction the horizon to either
// side is searched and the cosine-weighted visible arc integrated in closed form. Deviations: a hard
// cutoff at the radius, the facet bounds the arc besides the shading normal, and the sum over the
// slices is divided by what it would be without occluders, so that an open surface is 1 exactly.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the visible share, 1 open. Samples outside the viewport are skipped.

// Integral of the cosine about the projected normal from the view direction to the angle h, over
// the slice's Jacobian |sin|; h and normalAngle are signed angles from the view direction, radians.
float ssaoArcIntegral(float h, float normalAngle)
{
  return float(0.25) *
    (cos(normalAngle) + float(2.0) * h * sin(normalAngle) - cos(float(2.0) * h - normalAngle));
}

// acos to within 0.00007 rad (Abramowitz and Stegun, 4.4.45).
float ssaoArcCosine(float x)
{
  float a = min(abs(x), float(1.0));
  float y = ((float(-0.0187293) * a + float(0.0742610)) * a - float(0.2121144)) * a +
    float(1.5707288);
  y *= sqrt(float(1.0) - a);
  return x < float(0.0) ? float(3.14159265358979) - y : y;
}

// The largest cosine, against the view direction, of what is seen from a point to one side.
//   start     pixel of the point;  step: pixels that the radius covers in the slice's direction
//   jitter    in [0, 1): where in its interval each sample lies
float ssaoHorizonCosine(vec2 pixel, vec2 reach, vec3 positionVC, vec3 facet, vec3 viewer,
  float jitter, float lowest)
{
  float highest = lowest;
  float reachInPixels = length(reach);
  for (int i = 0; i < steps; ++i)
  {
    float t = (float(i) + jitter) / float(steps);
    float share = max(t * t, float(1.3) / max(reachInPixels, float(1.3)));
    vec2 at = floor(pixel + reach * share) + vec2(float(0.5), float(0.5));
    bool known = at.x >= viewport.x && at.y >= viewport.y && at.x < viewport.x + viewport.z &&
      at.y < viewport.y + viewport.w;
    float depth = ssaoGeometryAt(at).x;
    vec3 offset =
      ssaoPositionVC(at, depth, pixelToRay, rayOffset, depthSlope, perspective) - positionVC;
    float squared = dot(offset, offset);
    float inverse = inversesqrt(max(squared, float(1.0e-30)));
    bool occludes = known && depth > float(0.0) && squared <= radius * radius &&
      dot(facet, offset) * inverse > float(0.01);
    highest = occludes ? max(highest, dot(offset, viewer) * inverse) : highest;
  }
  return highest;
}

float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  vec3 normal = ssaoUnpackNormal(center.y);
  vec3 facet = ssaoUnpackNormal(center.z);
  vec3 viewer = ssaoTowardsViewer(positionVC, perspective);
  vec3 across = normalize(cross(vec3(float(0.0), float(1.0), float(0.0)), viewer));
  vec3 up = cross(viewer, across);
  vec4 noise = ssaoNoiseAt(pixel);
  float visible = float(0.0);
  float open = float(0.0);
  float halfPi = float(1.57079632679490);
  for (int i = 0; i < directions; ++i)
  {
    float turn = (float(i) + noise.x) * float(3.14159265358979) / float(directions);
    vec3 along = across * cos(turn) + up * sin(turn);
    // The slice is spanned by along and viewer; its trace in the picture:
    vec2 trace = perspective > float(0.5)
      ? (vec2(along.x, along.y) * center.x + vec2(positionVC.x, positionVC.y) * along.z) /
        (center.x * center.x)
      : vec2(along.x, along.y);
    vec2 reach = ssaoTransform2(rayToPixel, trace) * radius;
    vec3 axis = cross(along, viewer);
    vec3 projected = normal - axis * dot(normal, axis);
    float projectedLength = length(projected);
    vec3 projectedFacet = facet - axis * dot(facet, axis);
    float normalAngle = (dot(projected, along) >= float(0.0) ? float(1.0) : float(-1.0)) *
      ssaoArcCosine(dot(projected, viewer) / max(projectedLength, float(1.0e-6)));
    float facetAngle = (dot(projectedFacet, along) >= float(0.0) ? float(1.0) : float(-1.0)) *
      ssaoArcCosine(dot(projectedFacet, viewer) / max(length(projectedFacet), float(1.0e-6)));
    float high = min(normalAngle, facetAngle) + halfPi;
    float low = max(normalAngle, facetAngle) - halfPi;
    float cosineHigh = ssaoHorizonCosine(
      pixel, reach, positionVC, facet, viewer, noise.y, float(-1.0));
    float cosineLow = ssaoHorizonCosine(
      pixel, -reach, positionVC, facet, viewer, float(1.0) - noise.y, float(-1.0));
    float horizonHigh = min(ssaoArcCosine(cosineHigh), high);
    float horizonLow = max(-ssaoArcCosine(cosineLow), low);
    visible += projectedLength *
      (ssaoArcIntegral(horizonHigh, normalAngle) + ssaoArcIntegral(horizonLow, normalAngle));
    open += projectedLength *
      (ssaoArcIntegral(high, normalAngle) + ssaoArcIntegral(low, normalAngle));
  }
  return open > float(1.0e-6) ? clamp(visible / open, float(0.0), float(1.0)) : float(1.0);
}
