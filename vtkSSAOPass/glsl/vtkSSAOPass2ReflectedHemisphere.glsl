// Stage 2, estimator ReflectedHemisphere: the SSAO image effect of Unity's standard assets. Fixed
// points of the ball, reflected at a plane that differs from pixel to pixel, turned to the
// normal's side and moved by 0.3 along the normal. Where such a point lies in the picture follows
// from its x and y at the depth of the centre alone, without its own depth. In the source that
// distance is a share of the picture's width divided by the depth; here it is the radius in
// pixels.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns 1 minus the mean weight of the occluders, 1 open. Samples outside the viewport leave the
// divisor: nothing is known of them.

// Weight of an occluder that lies in front of the sample point by a share of the radius from 0 to
// 1.
float ssaoOccluderWeight(float difference)
{
  float near = float(1.0) - difference;
  float power = pow(near, falloffExponent);
  float nullSquare = float(1.0) - min(pow(near, float(11.0)) + difference, float(1.0));
  float inverseSquare = float(1.0) / (float(1.0) + float(10.0) * difference * difference);
  return falloff == 0 ? power : (falloff == 1 ? nullSquare : inverseSquare);
}

float ssaoVisibility(vec2 pixel, vec4 center)
{
  vec3 normal = ssaoUnpackNormal(center.y);
  vec3 mirror = ssaoMirror(ssaoNoiseAt(pixel));
  float radiusOnPlane = radius / (perspective * center.x + (float(1.0) - perspective));
  float hidden = float(0.0);
  float counted = float(0.0);
  for (int i = 0; i < kernelSize; ++i)
  {
    vec3 direction = reflect(ssaoKernelAt(i), mirror);
    direction = dot(direction, normal) < float(0.0) ? -direction : direction;
    direction = direction + normal * float(0.3);
    vec2 samplePixel =
      pixel + ssaoTransform2(rayToPixel, vec2(direction.x, direction.y) * radiusOnPlane);
    bool known = ssaoIsInViewport(samplePixel, viewport);
    float depth = ssaoGeometryAt(samplePixel).x;
    float difference =
      clamp((center.x - direction.z * radius - depth) / radius, float(0.0), float(1.0));
    bool behind = depth > float(0.0) && difference > minimumDifference;
    counted += known ? float(1.0) : float(0.0);
    hidden += known && behind ? ssaoOccluderWeight(difference) : float(0.0);
  }
  return float(1.0) - hidden / max(counted, float(1.0));
}
