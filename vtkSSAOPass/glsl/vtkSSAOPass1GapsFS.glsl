//VTK::System::Dec
//VTK::Output::Dec

// Between stages 1 and 2: how the surface goes on at each texel of the layers. Where one goes on over
// the whole picture nothing that lies behind it can be met by light that reaches it, so that layers
// need not be known; where it is a plane, nothing is in reach of it. Returns (0 if the texels to the
// right and above show the same plane, 1 if not, 2 if they show a surface that ends before another one;
// packed facet normal, 0 where there is no surface).

//SSAO::Functions
//SSAO::View

uniform vec4 layerPlace; // (scale, offset): pixel of a texel
uniform float radius;    // world units

// How a surface goes on from one texel to the next, as above: 2 if each lies off the other's plane by
// more than a texel and a half, or they show different sides; 0 if neither rises over the other's plane
// by more than 1 in 500, a fifth of what the estimators take for the facet (ssaoCosineAt). Where the
// radius covers less than a pixel no layer is looked at.
float ssaoChange(vec4 one, vec2 pixelOfOne, vec4 other, vec2 pixelOfOther)
{
  SsaoPlane planeOfOne = ssaoPlaneThrough(ssaoUnpackFacet(one.z), pixelOfOne, one.x, pixelToRay,
    rayOffset, depthSlope, perspective);
  SsaoPlane planeOfOther = ssaoPlaneThrough(ssaoUnpackFacet(other.z), pixelOfOther, other.x, pixelToRay,
    rayOffset, depthSlope, perspective);
  vec2 moved = pixelOfOther - pixelOfOne;
  float offOne = abs(ssaoHalfFootprintsOffPlane(planeOfOne, other.x, moved));
  float offOther = abs(ssaoHalfFootprintsOffPlane(planeOfOther, one.x, -moved));
  vec2 ray = ssaoRayThrough(pixelOfOne, pixelToRay, rayOffset, depthSlope, perspective);
  bool reaches = ssaoLargestReach(radius, min(one.x, other.x), ray, rayToPixel, perspective) >= 1.0;
  bool both = one.x > 0.0 && other.x > 0.0;
  bool apart = both && reaches &&
    (min(offOne, offOther) > 3.0 * layerPlace.x || one.z * other.z < 0.0);
  bool same = both ? max(offOne, offOther) <= 0.004 * layerPlace.x && one.z * other.z > 0.0
                   : one.x == other.x;
  bool known = ssaoIsInViewport(pixelOfOther, drawn);
  return known ? (apart ? 2.0 : (same ? 0.0 : 1.0)) : 0.0;
}

void main()
{
  vec2 pixel = gl_FragCoord.xy * layerPlace.xy + layerPlace.zw;
  vec2 right = pixel + vec2(layerPlace.x, 0.0);
  vec2 above = pixel + vec2(0.0, layerPlace.y);
  vec4 center = ssaoGeometryAt(pixel);
  float change = max(ssaoChange(center, pixel, ssaoGeometryAt(right), right),
    ssaoChange(center, pixel, ssaoGeometryAt(above), above));
  gl_FragData[0] = vec4(change, center.x > 0.0 ? center.z : 0.0, 0.0, 0.0);
}
