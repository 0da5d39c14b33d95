// Functions that several stages share. They are pure: everything comes by parameter. The same text
// is compiled as C++ through GLM, in float and in double, and tested there, so it uses neither
// swizzles nor out parameters, and every literal that meets a scalar is written float(...).
//
// Spaces: VC is view coordinates in world units, the eye at the origin looking along -z; "depth" is
// -z in VC, positive in front of the eye. "pixel" is a position in the framebuffer, pixel centres
// at .5.

// Normal to two numbers, both in [-1, 1] (Cigolla et al., "A Survey of Efficient Representations
// for Independent Unit Vectors", 2014: octahedral mapping). normal: any unit vector.
vec2 ssaoOctahedralEncode(vec3 normal)
{
  float inverseLength = float(1.0) / (abs(normal.x) + abs(normal.y) + abs(normal.z));
  float x = normal.x * inverseLength;
  float y = normal.y * inverseLength;
  float signX = x >= float(0.0) ? float(1.0) : float(-1.0);
  float signY = y >= float(0.0) ? float(1.0) : float(-1.0);
  return normal.z >= float(0.0) ? vec2(x, y)
                                : vec2((float(1.0) - abs(y)) * signX, (float(1.0) - abs(x)) * signY);
}

// The inverse of ssaoOctahedralEncode. Returns a unit vector.
vec3 ssaoOctahedralDecode(vec2 code)
{
  float z = float(1.0) - abs(code.x) - abs(code.y);
  float fold = max(-z, float(0.0));
  float x = code.x + (code.x >= float(0.0) ? -fold : fold);
  float y = code.y + (code.y >= float(0.0) ? -fold : fold);
  return normalize(vec3(x, y, z));
}

// Unit vector to one float32 without loss beyond 12 bits for each octahedral coordinate: an integer
// below 2^24, which blending with alpha 1 leaves exact.
float ssaoPackNormal(vec3 normal)
{
  vec2 code = ssaoOctahedralEncode(normal);
  float x = floor((code.x * float(0.5) + float(0.5)) * float(4094.0) + float(0.5));
  float y = floor((code.y * float(0.5) + float(0.5)) * float(4094.0) + float(0.5));
  return x * float(4096.0) + y;
}

// The inverse of ssaoPackNormal. 4094 is even, so that 0 is met exactly: an axis stays an axis.
vec3 ssaoUnpackNormal(float code)
{
  float x = floor(code / float(4096.0));
  float y = code - x * float(4096.0);
  return ssaoOctahedralDecode(
    vec2(x, y) * float(2.0) / float(4094.0) - vec2(float(1.0), float(1.0)));
}

// Facet normal and whether the facet shows its front (facing 1) or its back (facing -1) to one
// float32. The sign is the facing, so the code itself must not be 0.
float ssaoPackFacet(vec3 facet, float facing)
{
  return facing * (ssaoPackNormal(facet) + float(1.0));
}

// The inverse of ssaoPackFacet.
vec3 ssaoUnpackFacet(float code)
{
  return ssaoUnpackNormal(abs(code) - float(1.0));
}

float ssaoUnpackFacing(float code)
{
  return code < float(0.0) ? float(-1.0) : float(1.0);
}

// 2x2 matrix (rows m.xy and m.zw) times v.
vec2 ssaoTransform2(vec4 m, vec2 v)
{
  return vec2(m.x * v.x + m.y * v.y, m.z * v.x + m.w * v.y);
}

// Position in VC of what is seen at a pixel.
//   pixel, depth        as above
//   pixelToRay          2x2 matrix, pixels to the view plane at depth 1 (perspective) or to x, y in
//                       VC (parallel)
//   rayOffset           xy: added to pixelToRay x pixel; zw: shift of x, y in VC
//   depthSlope          shift of x, y in VC for each unit of depth (off-axis projections)
//   perspective         1 for perspective, 0 for parallel projection
vec3 ssaoPositionVC(
  vec2 pixel, float depth, vec4 pixelToRay, vec4 rayOffset, vec2 depthSlope, float perspective)
{
  vec2 ray = ssaoTransform2(pixelToRay, pixel) + vec2(rayOffset.x, rayOffset.y);
  float scale = perspective * depth + (float(1.0) - perspective);
  vec2 xy = ray * scale + depthSlope * depth + vec2(rayOffset.z, rayOffset.w);
  return vec3(xy.x, xy.y, -depth);
}

// Direction of a pixel's ray, (x, y, -1), its x and y. Parameters as in ssaoPositionVC.
vec2 ssaoRayThrough(
  vec2 pixel, vec4 pixelToRay, vec4 rayOffset, vec2 depthSlope, float perspective)
{
  return (ssaoTransform2(pixelToRay, pixel) + vec2(rayOffset.x, rayOffset.y)) * perspective +
    depthSlope;
}

// Pixels that a radius about a point covers, at most, in x or y: a step of that length square to the
// view direction. radius: world units; depth: the point's; ray: of ssaoRayThrough; rayToPixel as in
// ssaoPixelOf.
float ssaoLargestReach(float radius, float depth, vec2 ray, vec4 rayToPixel, float perspective)
{
  float scale = perspective * depth + (float(1.0) - perspective);
  float squaredPixels = max(rayToPixel.x * rayToPixel.x + rayToPixel.y * rayToPixel.y,
    rayToPixel.z * rayToPixel.z + rayToPixel.w * rayToPixel.w);
  return radius * sqrt(squaredPixels * (float(1.0) + perspective * dot(ray, ray))) / scale;
}

// Pixel that shows a point in VC: the inverse of ssaoPositionVC. rayToPixel is the inverse of
// pixelToRay. The point must lie in front of the eye in perspective.
vec2 ssaoPixelOf(vec3 positionVC, vec4 rayToPixel, vec4 rayOffset, vec2 depthSlope, float perspective)
{
  float depth = -positionVC.z;
  float scale = perspective * depth + (float(1.0) - perspective);
  vec2 shifted = vec2(positionVC.x, positionVC.y) - depthSlope * depth -
    vec2(rayOffset.z, rayOffset.w);
  return ssaoTransform2(rayToPixel, shifted / scale - vec2(rayOffset.x, rayOffset.y));
}

// Unit vector from a point in VC towards the viewer.
vec3 ssaoTowardsViewer(vec3 positionVC, float perspective)
{
  return perspective > float(0.5) ? normalize(-positionVC)
                                  : vec3(float(0.0), float(0.0), float(1.0));
}

// Depth of a sprite's surface from its window depth in [0, 1]. depthOfWindow holds rows 2 and 3 of
// the projection matrix: (m22, m23, m32, m33).
float ssaoDepthOfWindow(float windowDepth, vec4 depthOfWindow)
{
  float ndc = windowDepth * float(2.0) - float(1.0);
  return -(depthOfWindow.y - ndc * depthOfWindow.w) / (ndc * depthOfWindow.z - depthOfWindow.x);
}

// The inverse of ssaoDepthOfWindow. The quotient that the depth does not change is taken out first,
// so that rounding does no more harm than storing the result does.
float ssaoWindowOfDepth(float depth, vec4 depthOfWindow)
{
  bool divides = depthOfWindow.z != float(0.0);
  float constant = divides ? depthOfWindow.x / depthOfWindow.z : float(0.0);
  float numerator = divides ? depthOfWindow.y - constant * depthOfWindow.w
                            : depthOfWindow.y - depthOfWindow.x * depth;
  float ndc = constant + numerator / (depthOfWindow.w - depthOfWindow.z * depth);
  return ndc * float(0.5) + float(0.5);
}

// Whether a position in pixels lies in a viewport (x, y, width, height). False for NaN.
bool ssaoIsInViewport(vec2 pixel, vec4 viewport)
{
  return pixel.x >= viewport.x && pixel.y >= viewport.y && pixel.x < viewport.x + viewport.z &&
    pixel.y < viewport.y + viewport.w;
}

// Whether the captured surfaces tell something of a point in VC that projects to a pixel: it must
// lie in front of the eye and inside the viewport.
bool ssaoIsInView(vec3 positionVC, vec2 pixel, vec4 viewport, float perspective)
{
  return (positionVC.z < float(0.0) || perspective < float(0.5)) &&
    ssaoIsInViewport(pixel, viewport);
}

// First tangent of the Gram-Schmidt basis about a unit normal (Chapman, "SSAO Tutorial", 2013).
// rotation: unit vector (cos, sin) in the view plane. Where it is parallel to the normal the view
// direction takes its place.
vec3 ssaoTangent(vec3 normal, vec2 rotation)
{
  vec3 random = vec3(rotation.x, rotation.y, float(0.0));
  vec3 tangent = random - normal * dot(random, normal);
  vec3 spare = vec3(float(0.0), float(0.0), float(1.0)) - normal * normal.z;
  return normalize(dot(tangent, tangent) > float(0.0001) ? tangent : spare);
}

// Normal of the plane at which a pixel's sample points are reflected. noise: the pixel's random
// numbers, see vtkSSAONoiseTile. Over a tile the normals cover one half of the sphere evenly, and
// the other half would give the same planes.
vec3 ssaoMirror(vec4 noise)
{
  float across = sqrt(float(1.0) - noise.y * noise.y);
  return vec3(noise.z * across, noise.w * across, noise.y);
}

// Weight of an occluder by the difference of the depths of surface and occluder: 1 within the
// radius, falling to 0 far beyond (LearnOpenGL, "SSAO": smoothstep(0, 1, R / |dz|)).
float ssaoRangeCheck(float depthDifference, float radius)
{
  float t = clamp(radius / max(abs(depthDifference), radius * float(0.000001)), float(0.0),
    float(1.0));
  return t * t * (float(3.0) - float(2.0) * t);
}

// How much the depth of a surface's tangent plane changes within half a pixel to either side, in
// world units: what a stored depth may differ from the plane because it was taken at a pixel's
// centre. rayX, rayY: change of ssaoPositionVC(pixel, 1) for a step of one pixel in x and in y.
float ssaoHalfPixelSlope(
  vec3 positionVC, vec3 normal, vec2 rayX, vec2 rayY, float perspective, float limit)
{
  float scale = perspective * -positionVC.z + (float(1.0) - perspective);
  vec3 towards = perspective > float(0.5) ? positionVC / positionVC.z
                                          : vec3(float(0.0), float(0.0), float(1.0));
  float facing = max(abs(dot(normal, towards)), float(0.00001));
  float stepX = abs(normal.x * rayX.x + normal.y * rayX.y) * scale / facing;
  float stepY = abs(normal.x * rayY.x + normal.y * rayY.y) * scale / facing;
  return min((stepX + stepY) * float(0.5), limit);
}

// The plane of a facet seen at a pixel: the distance from it of what a neighbouring pixel sees is a
// sum of the neighbour's depth and place.
struct SsaoPlane
{
  float depth;       // of the pixel
  float ofDepth;     // distance for one world unit of depth more, in half footprints
  vec2 ofPlace;      // distance for one pixel sideways, over scale
  float perspective; // 1 if the scale is the neighbour's depth, 0 if it is 1
};

// facet: unit normal in VC; depth: at the pixel; the others as in ssaoPositionVC.
SsaoPlane ssaoPlaneThrough(vec3 facet, vec2 pixel, float depth, vec4 pixelToRay, vec4 rayOffset,
  vec2 depthSlope, float perspective)
{
  float footprint = length(vec2(pixelToRay.x, pixelToRay.z)) *
    (perspective * depth + (float(1.0) - perspective));
  float perHalfFootprint = float(2.0) / max(footprint, float(1.0e-30));
  vec2 ray = ssaoRayThrough(pixel, pixelToRay, rayOffset, depthSlope, perspective);
  SsaoPlane plane;
  plane.depth = depth;
  plane.ofDepth = (facet.x * ray.x + facet.y * ray.y - facet.z) * perHalfFootprint;
  plane.ofPlace = vec2(facet.x * pixelToRay.x + facet.y * pixelToRay.z,
    facet.x * pixelToRay.y + facet.y * pixelToRay.w) * perHalfFootprint;
  plane.perspective = perspective;
  return plane;
}

// Distance of what a neighbouring pixel sees from a plane, in half footprints of the plane's pixel.
// depth: the neighbour's; moved: pixels to it.
float ssaoHalfFootprintsOffPlane(SsaoPlane plane, float depth, vec2 moved)
{
  float scale = plane.perspective * depth + (float(1.0) - plane.perspective);
  return (depth - plane.depth) * plane.ofDepth + dot(plane.ofPlace, moved) * scale;
}

// Weight of a neighbour in the edge-aware mean: 1 on the plane, 0 from a slope of one half off it; a tenth of a
// pixel off does not count as an edge. depth: the neighbour's, 0 for none; moved: pixels to it.
float ssaoPlaneWeight(SsaoPlane plane, float depth, vec2 moved)
{
  float away = ssaoHalfFootprintsOffPlane(plane, depth, moved);
  float steepness =
    max(abs(away) - float(0.2), float(0.0)) * inversesqrt(max(dot(moved, moved), float(1.0)));
  return depth > float(0.0) ? clamp(float(1.0) - steepness, float(0.0), float(1.0)) : float(0.0);
}

// Visibility after the controls for strength; all parameters as in the public class. 1 stays 1
// unless shift is negative.
float ssaoStrength(float visibility, float power, float intensity, float scale, float shift)
{
  float powered = pow(clamp(visibility, float(0.0), float(1.0)), power);
  float occlusion = clamp((float(1.0) - powered - shift) * scale, float(0.0), float(1.0));
  return clamp(float(1.0) - intensity * occlusion, float(0.0), float(1.0));
}
