// Functions of the estimators that cut the hemisphere into slices, and of the layers they look at. As
// those of vtkSSAOPass0Functions.glsl, which go before, they are compiled as C++ too.

// acos to within 0.00007 rad (Abramowitz and Stegun, 4.4.45). x from -1 to 1.
float ssaoArcCosine(float x)
{
  float a = min(abs(x), float(1.0));
  float y = ((float(-0.0187293) * a + float(0.0742610)) * a - float(0.2121144)) * a +
    float(1.5707288);
  y *= sqrt(float(1.0) - a);
  return x < float(0.0) ? float(3.14159265358979) - y : y;
}

// A direction (cos, sin) turned by an angle (cos, sin).
vec2 ssaoTurned(vec2 direction, vec2 angle)
{
  return vec2(direction.x * angle.x - direction.y * angle.y,
    direction.x * angle.y + direction.y * angle.x);
}

// A plane through a point, spanned by the direction towards the viewer and one across it. Angles in
// it are counted from the viewer's direction to either side; side 1 is that of "along".
struct SsaoSlice
{
  vec3 along;         // unit vector in VC, square to the viewer's direction
  float weight;       // length of the normal projected into the slice
  float normalCosine; // of the angle from the viewer's direction to the projected normal
  float normalSine;   // positive where the normal leans to side 1
  float lowestAhead;  // cosine of the lowest angle on side 1 that facet and normal leave open
  float lowestBehind; // the same on side -1
};

// across, up, viewer: orthonormal, VC; turn: (cos, sin) of the slice's angle from across to up;
// normal, facet: unit vectors in VC, which bound what is open.
SsaoSlice ssaoSlice(vec3 across, vec3 up, vec3 viewer, vec3 normal, vec3 facet, vec2 turn)
{
  SsaoSlice slice;
  slice.along = across * turn.x + up * turn.y;
  vec2 projected = vec2(dot(normal, viewer), dot(normal, slice.along));
  slice.weight = length(projected);
  float inverse = float(1.0) / max(slice.weight, float(0.000001));
  slice.normalCosine = projected.x * inverse;
  slice.normalSine = projected.y * inverse;
  vec2 facetInSlice = vec2(dot(facet, viewer), dot(facet, slice.along));
  float facetSine = facetInSlice.y / max(length(facetInSlice), float(0.000001));
  // Beyond a right angle nothing is open on the other side.
  float upright = slice.normalSine >= float(0.0) ? float(1.0) : float(-1.0);
  float normalSine = slice.normalCosine >= float(0.0) ? slice.normalSine : upright;
  slice.lowestAhead = -min(normalSine, facetSine);
  slice.lowestBehind = max(normalSine, facetSine);
  return slice;
}

// Cosine-weighted measure of the directions of a slice from the viewer's to an angle to one side,
// 0 to 1 (Jimenez, Wu, Pesce, Jarabo, "Practical Realtime Strategies for Accurate Indirect
// Occlusion", 2016, equation 7: the integral of cos(angle to the normal) |sin(angle)|, here in terms
// of the angle's cosine). normalSine: positive where the normal leans to this side.
float ssaoArcMeasure(float cosine, float normalCosine, float normalSine)
{
  float squaredSine = max(float(1.0) - cosine * cosine, float(0.0));
  float angle = ssaoArcCosine(cosine);
  return float(0.5) *
    (squaredSine * normalCosine + (angle - cosine * sqrt(squaredSine)) * normalSine);
}

// The same without roots, to within 0.0006: for counting sectors.
float ssaoArcMeasureNear(float cosine, float normalCosine, float normalSine)
{
  float c = cosine * cosine;
  float twice = ((float(-0.180649) * c + float(0.160150)) * c - float(0.415907)) * c + float(2.008260);
  return float(0.5) * ((float(1.0) - c) * normalCosine +
    (float(1.5707963267949) - cosine * twice) * normalSine);
}

// Where the slice's trace in the picture has got to, in pixels, when one world unit along it is
// covered. depth, positionVC: of the point; rayToPixel as in ssaoPixelOf.
vec2 ssaoTrace(SsaoSlice slice, vec3 positionVC, vec4 rayToPixel, float perspective)
{
  float depth = perspective > float(0.5) ? -positionVC.z : float(1.0);
  vec2 moved = vec2(slice.along.x, slice.along.y) +
    vec2(positionVC.x, positionVC.y) * (perspective * slice.along.z / depth);
  return ssaoTransform2(rayToPixel, moved / depth);
}

// The ray of a sample's pixel as it is seen from a point: the point on it that lies t deeper than the
// point of view is, from there, start + t x direction in VC. What is asked of such points are
// products that are linear or quadratic in t.
struct SsaoRay
{
  vec3 squares; // of start, start by direction, of direction
  vec2 facet;   // by the facet's normal: start, direction
  vec2 viewer;  // by the direction towards the viewer: start, direction
};

// moved: change of ssaoPositionVC(pixel, 1) from the point's pixel to the sample's; depth: the
// point's; centerRay: direction of its own ray, its z is -1.
SsaoRay ssaoRayOf(
  vec2 moved, float depth, vec2 centerRay, vec3 facet, vec3 viewer, float perspective)
{
  vec2 start = moved * (perspective * depth + (float(1.0) - perspective));
  vec2 across = centerRay + moved * perspective;
  SsaoRay ray;
  ray.squares = vec3(dot(start, start), dot(start, across), dot(across, across) + float(1.0));
  ray.facet = vec2(facet.x * start.x + facet.y * start.y,
    facet.x * across.x + facet.y * across.y - facet.z);
  ray.viewer = vec2(viewer.x * start.x + viewer.y * start.y,
    viewer.x * across.x + viewer.y * across.y - viewer.z);
  return ray;
}

// Square of the distance of the point at t.
float ssaoSquaredDistance(SsaoRay ray, float t)
{
  return ray.squares.x + t * (float(2.0) * ray.squares.y + t * ray.squares.z);
}

// Cosine of the angle between the viewer's direction and the point at t, at least lowest. What rises
// less than a hundredth above the facet is the facet: a sample's texel lies beside the slice.
float ssaoCosineAt(SsaoRay ray, float t, float lowest)
{
  float inverse = inversesqrt(max(ssaoSquaredDistance(ray, t), float(1.0e-30)));
  float cosine = (ray.viewer.x + t * ray.viewer.y) * inverse;
  return (ray.facet.x + t * ray.facet.y) * inverse > float(0.01) ? max(cosine, lowest) : lowest;
}

// Share of the radius at which a sample is taken: squares, so that they are denser near the point,
// from 1.3 pixels on (Strugar's XeGTAO has that least distance; there several samples may share it).
// index: sample, with its shift from 0 to 1.
float ssaoSampleShare(float index, float count, float reachInPixels)
{
  float nearest = sqrt(min(float(1.3) / reachInPixels, float(1.0)));
  float t = nearest + (float(1.0) - nearest) * (index / count);
  return t * t;
}

// Share of a trace that lies inside the viewport, 0 to 1; 0 if it leaves within the 1.3 texels of the
// nearest sample. pixel: inside the viewport; reach: pixels of the whole trace; texel: edge of the
// samples' texels in pixels.
float ssaoShareInside(vec2 pixel, vec2 reach, vec4 viewport, float texel)
{
  vec2 left = vec2(reach.x > float(0.0) ? viewport.x + viewport.z - pixel.x : pixel.x - viewport.x,
    reach.y > float(0.0) ? viewport.y + viewport.w - pixel.y : pixel.y - viewport.y);
  float share = min(left.x / max(abs(reach.x), float(1.0e-6)),
    left.y / max(abs(reach.y), float(1.0e-6)));
  bool leaves = share < float(1.0) && share * length(reach) < float(1.3) * texel;
  return leaves ? float(0.0) : min(share, float(1.0));
}

// The stretches of a pixel's ray that lie inside solids, by their depths: front 0, back 0: none.
// And what has been met so far, front to back.
struct SsaoSolids
{
  vec4 first;  // front, back, front, back
  vec4 second; // the next two
  int found;
  int inside;  // solids entered and not left
  float entry; // where the outermost of them was entered, the last one if pairs are matched
  float last;  // where the innermost of them was entered
  float sound; // 0 once something was left that had not been entered
};

SsaoSolids ssaoNoSolids()
{
  SsaoSolids solids;
  solids.first = vec4(float(0.0), float(0.0), float(0.0), float(0.0));
  solids.second = solids.first;
  solids.found = 0;
  solids.inside = 0;
  solids.entry = float(0.0);
  solids.last = float(0.0);
  solids.sound = float(1.0);
  return solids;
}

// One stretch more; a fifth is lost.
SsaoSolids ssaoAddSolid(SsaoSolids solids, float front, float back)
{
  vec4 a = solids.first;
  vec4 b = solids.second;
  SsaoSolids result = solids;
  result.first = solids.found == 0 ? vec4(front, back, a.z, a.w) : a;
  result.first = solids.found == 1 ? vec4(a.x, a.y, front, back) : result.first;
  result.second = solids.found == 2 ? vec4(front, back, b.z, b.w) : b;
  result.second = solids.found == 3 ? vec4(b.x, b.y, front, back) : result.second;
  result.found = solids.found + 1;
  return result;
}

// How many solids a ray is inside of after the next of its layers; parameters as in ssaoAddLayer.
int ssaoInsideAfter(int inside, float layer)
{
  return layer > float(0.0) ? inside + 1 : (layer < float(0.0) ? max(inside - 1, 0) : inside);
}

// The next layer of a ray. layer: its depth, negative if it shows its back, 0 if there is none; sheet: thickness of what has no other end; pairs: 0: entries are counted, and
// what lies between the first entry and the exit that brings the count to 0 is solid; 1: layers are
// missing, so that only an entry and the exit next to it enclose something solid.
SsaoSolids ssaoAddLayer(SsaoSolids solids, float layer, float sheet, float pairs)
{
  SsaoSolids result = solids;
  float depth = abs(layer);
  bool enters = layer > float(0.0);
  bool leaves = layer < float(0.0);
  bool matched = pairs > float(0.5);
  if (enters)
  {
    if (matched && solids.inside == 1)
    {
      result = ssaoAddSolid(solids, solids.entry, solids.entry + sheet);
    }
    result.entry = matched || solids.inside == 0 ? depth : solids.entry;
    result.last = depth;
    result.inside = matched ? 1 : solids.inside + 1;
  }
  else if (leaves)
  {
    if (solids.inside < 2)
    {
      result = ssaoAddSolid(solids, solids.inside == 1 ? solids.entry : depth - sheet, depth);
    }
    result.sound = solids.inside == 0 ? float(0.0) : solids.sound;
    result.inside = max(solids.inside - 1, 0);
  }
  return result;
}

// What was entered and not left. end: depth at which it ends if nothing else is odd about the ray: a
// surface with nothing behind it bounds something that goes on, as a terrain does. Otherwise all
// fronts are sheets.
SsaoSolids ssaoCloseSolids(SsaoSolids solids, float end, float sheet, float pairs)
{
  SsaoSolids result = solids;
  bool goesOn = solids.inside == 1 && solids.sound > float(0.5) && pairs < float(0.5);
  if (solids.inside > 0)
  {
    result = ssaoAddSolid(
      result, solids.entry, goesOn ? max(end, solids.entry + sheet) : solids.entry + sheet);
  }
  if (solids.inside > 1)
  {
    result = ssaoAddSolid(result, solids.last, solids.last + sheet);
  }
  return result;
}

// The stretches of a ray that are solid to the surface that looks at them, (front, back) each.
struct SsaoStretches
{
  vec2 first;
  vec2 second;
  vec2 third;
};

// solids, more: of ssaoCloseSolids; the first front is negative where the ray's first surface shows its
// back. facing: 1, or -1 where the surface that looks shows its back. If they differ, inside and
// outside change places, and what goes on without end is a sheet.
SsaoStretches ssaoStretchesSeen(vec4 solids, vec4 more, float facing, float sheet)
{
  SsaoStretches seen;
  // At a silhouette front and back meet and look like a face that is there twice: it has no inside.
  bool paper = solids.x > float(0.0) && solids.y < float(1.00002) * solids.x;
  bool back = facing * solids.x < float(0.0) && !paper;
  float front = abs(solids.x);
  bool second = front > float(0.0) && solids.y < float(1.0e29);
  bool third = solids.z > float(0.0) && solids.w < float(1.0e29);
  vec2 between =
    vec2(second ? solids.y : float(0.0), solids.z > float(0.0) ? solids.z : solids.y + sheet);
  vec2 behind = vec2(third ? solids.w : float(0.0), more.x > float(0.0) ? more.x : solids.w + sheet);
  seen.first = back ? vec2(max(front - sheet, front * float(0.5)), front) : vec2(front, solids.y);
  seen.second = back ? between : vec2(solids.z, solids.w);
  seen.third = back ? behind : vec2(more.x, more.y);
  return seen;
}
