//VTK::System::Dec
//VTK::Output::Dec

// Between stages 1 and 2: 1 where a surface ends before another one, 0 elsewhere. Where one surface
// goes on over the whole picture nothing that lies behind it can be met by light that reaches it, so
// that layers need not be known.

//SSAO::Functions
//SSAO::View

uniform vec4 layerPlace; // (scale, offset): pixel of a texel

// Whether two surfaces that are seen at neighbouring texels are no continuation of each other: each lies
// off the other's plane by more than a texel and a half, or they show different sides.
bool ssaoAreApart(vec4 one, vec2 pixelOfOne, vec4 other, vec2 pixelOfOther)
{
  SsaoPlane planeOfOne = ssaoPlaneThrough(ssaoUnpackFacet(one.z), pixelOfOne, one.x, pixelToRay,
    rayOffset, depthSlope, perspective);
  SsaoPlane planeOfOther = ssaoPlaneThrough(ssaoUnpackFacet(other.z), pixelOfOther, other.x, pixelToRay,
    rayOffset, depthSlope, perspective);
  vec2 moved = pixelOfOther - pixelOfOne;
  float off = min(abs(ssaoHalfFootprintsOffPlane(planeOfOne, other.x, moved)),
    abs(ssaoHalfFootprintsOffPlane(planeOfOther, one.x, -moved)));
  return one.x > 0.0 && other.x > 0.0 && (off > 3.0 * layerPlace.x || one.z * other.z < 0.0);
}

void main()
{
  vec2 pixel = gl_FragCoord.xy * layerPlace.xy + layerPlace.zw;
  vec2 right = vec2(layerPlace.x, 0.0);
  vec2 up = vec2(0.0, layerPlace.y);
  vec4 center = ssaoGeometryAt(pixel);
  bool apart = ssaoAreApart(center, pixel, ssaoGeometryAt(pixel + right), pixel + right) ||
    ssaoAreApart(center, pixel, ssaoGeometryAt(pixel + up), pixel + up);
  gl_FragData[0] = vec4(apart ? 1.0 : 0.0);
}
