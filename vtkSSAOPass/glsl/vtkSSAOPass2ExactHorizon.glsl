// Stage 2, estimator ExactHorizon: Jimenez, Wu, Pesce, Jarabo, "Practical Realtime Strategies for
// Accurate Indirect Occlusion" (2016). In slices through the view direction the horizon to either
// side is searched and the cosine-weighted visible arc integrated in closed form. Deviations: a hard
// cutoff at the radius, the facet bounds the arc besides the shading normal, and the sum over the
// slices is divided by what it would be without occluders, so that an open surface is 1 exactly.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the visible share, 1 open. All samples are taken inside the viewport; where it cuts a side
// of a slice short that side weighs less, as if the samples beyond had been skipped.

// The largest cosine, against the view direction, of what is seen from a point to one side.
//   reach    pixels that the radius covers on this side, inside the picture
//   lowest   cosine of the lowest open angle
float ssaoHorizonCosine(vec2 pixel, vec2 reach, float reachInPixels, float centerDepth,
  vec2 centerRay, vec3 facet, vec3 viewer, float lowest, float jitter)
{
  int count = min(steps, int(ceil(reachInPixels)));
  float highest = lowest;
  for (int i = 0; i < count; ++i)
  {
    vec2 at = floor(pixel + reach * ssaoSampleShare(float(i) + jitter, float(count), reachInPixels)) +
      vec2(float(0.5), float(0.5));
    float depth = ssaoGeometryAt(at).x;
    SsaoRay ray = ssaoRayOf(
      ssaoTransform2(pixelToRay, at - pixel), centerDepth, centerRay, facet, viewer, perspective);
    float t = depth - centerDepth;
    bool known = ssaoIsInViewport(at, viewport) && depth > float(0.0) &&
      ssaoSquaredDistance(ray, t) <= radius * radius;
    highest = known ? max(highest, ssaoCosineAt(ray, t, lowest)) : highest;
  }
  return highest;
}

float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 positionVC =
    ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
  vec2 centerRay = ssaoRayThrough(pixel, pixelToRay, rayOffset, depthSlope, perspective);
  vec3 normal = ssaoUnpackNormal(center.y);
  vec3 facet = ssaoUnpackFacet(center.z);
  vec3 viewer = ssaoTowardsViewer(positionVC, perspective);
  vec3 across = normalize(cross(vec3(float(0.0), float(1.0), float(0.0)), viewer));
  vec3 up = cross(viewer, across);
  vec4 noise = ssaoNoiseAt(pixel);
  vec2 turn = vec2(noise.z, noise.w);
  float visible = float(0.0);
  float open = float(0.0);
  for (int i = 0; i < directions; ++i)
  {
    SsaoSlice slice = ssaoSlice(across, up, viewer, normal, facet, turn);
    turn = ssaoTurned(turn, sliceTurn);
    vec2 reach = ssaoTrace(slice, positionVC, rayToPixel, perspective) * radius;
    float reachInPixels = length(reach);
    float shareAhead = ssaoShareInside(pixel, reach, viewport, float(1.0));
    float shareBehind = ssaoShareInside(pixel, -reach, viewport, float(1.0));
    float ahead = ssaoHorizonCosine(pixel, reach * shareAhead, reachInPixels * shareAhead, center.x,
      centerRay, facet, viewer, slice.lowestAhead, noise.y);
    float behind = ssaoHorizonCosine(pixel, -reach * shareBehind, reachInPixels * shareBehind,
      center.x, centerRay, facet, viewer, slice.lowestBehind, noise.y);
    float knownAhead = slice.weight * sqrt(shareAhead);
    float knownBehind = slice.weight * sqrt(shareBehind);
    float openAhead = ssaoArcMeasure(slice.lowestAhead, slice.normalCosine, slice.normalSine);
    float openBehind = ssaoArcMeasure(slice.lowestBehind, slice.normalCosine, -slice.normalSine);
    visible += knownAhead * ssaoArcMeasure(ahead, slice.normalCosine, slice.normalSine) +
      knownBehind * ssaoArcMeasure(behind, slice.normalCosine, -slice.normalSine);
    open += knownAhead * openAhead + knownBehind * openBehind;
  }
  ssaoCertainty = open / float(max(directions, 1));
  return open > float(0.000001) ? clamp(visible / open, float(0.0), float(1.0)) : float(1.0);
}
