// Stage 2, estimator LayeredBitmask. As in ExactHorizon the hemisphere is cut into slices through the
// view direction, but what a sample's ray meets is known behind its first surface too: stretches
// inside solids. Each is cut by the ball of the radius, joined with the stretch of the sample before
// if both lie on one surface, and marks the sectors of its side of the slice that it hides: 30 with
// equal cosine-weighted measure (after Therrien, Levesque, Gilet, "Screen Space Indirect Lighting
// with Visibility Bitmask", 2023, whose sectors are equal in angle and whose thickness is constant).
// With one contiguous arc to either side the result is that of ExactHorizon.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
// Returns the visible share, 1 open. All samples are taken inside the viewport; where it cuts a side
// of a slice short that side weighs less, as if the samples beyond had been skipped.

int ssaoNumberOfSectors(int sectors)
{
  int pairs = sectors - ((sectors >> 1) & 0x55555555);
  int fours = (pairs & 0x33333333) + ((pairs >> 2) & 0x33333333);
  int eights = (fours + (fours >> 4)) & 0x0F0F0F0F;
  int sixteens = eights + (eights >> 8);
  return (sixteens + (sixteens >> 16)) & 63;
}

// What a stretch of a sample's ray hides: (front, largest cosine, smallest cosine), the front -1e30 if
// it lies outside the ball of the radius.
//   stretch      depths of its ends, 0: none
//   centerDepth  the point's;  ball: where the ray enters and leaves the ball, less centerDepth
vec3 ssaoHiddenArc(SsaoRay ray, vec2 stretch, float centerDepth, vec2 ball, float lowest)
{
  float low = max(stretch.x - centerDepth, ball.x);
  float high = min(stretch.y - centerDepth, ball.y);
  float front = ssaoCosineAt(ray, low, lowest);
  float back = ssaoCosineAt(ray, high, lowest);
  return vec3(stretch.x > float(0.0) && low < high ? stretch.x : float(-1.0e30), max(front, back),
    min(front, back));
}

// An arc grown by that of the sample before if their fronts lie on one surface.
vec3 ssaoJoin(vec3 arc, vec3 before, float reach)
{
  bool joins = abs(arc.x - before.x) < reach;
  return vec3(
    arc.x, joins ? max(arc.y, before.y) : arc.y, joins ? min(arc.z, before.z) : arc.z);
}

// The sectors of an arc. dither: from 0 to 1, how its ends are rounded.
int ssaoSectorsOf(
  vec3 arc, float normalCosine, float normalSine, float sectorsPerMeasure, float dither)
{
  // Where next to nothing is open the measure is off by more than that: there are no other sectors.
  float first = clamp(ssaoArcMeasureNear(arc.y, normalCosine, normalSine) * sectorsPerMeasure,
    float(0.0), float(30.0)) + dither;
  float end = clamp(ssaoArcMeasureNear(arc.z, normalCosine, normalSine) * sectorsPerMeasure,
    float(0.0), float(30.0)) + dither;
  return arc.x > float(0.0) ? (1 << int(end)) - (1 << int(first)) : 0;
}

// What is known of one side of a slice.
struct SsaoSide
{
  vec2 reach;             // pixels that the radius covers inside the picture
  float lowest;           // cosine of the lowest open angle
  float normalSine;       // of the projected normal's angle, positive where it leans to this side
  float sectorsPerMeasure;
  int hidden;             // sectors, as bits
  vec3 first;             // the arcs of the sample before
  vec3 second;
};

SsaoSide ssaoSide(vec2 reach, float lowest, float normalCosine, float normalSine, float centerDepth)
{
  SsaoSide side;
  side.reach = reach;
  side.lowest = lowest;
  side.normalSine = normalSine;
  side.sectorsPerMeasure =
    float(30.0) / max(ssaoArcMeasureNear(lowest, normalCosine, normalSine), float(0.000001));
  side.hidden = 0;
  // At first the surface itself, on the horizon.
  side.first = vec3(centerDepth, lowest, lowest);
  side.second = vec3(float(-1.0e30), lowest, lowest);
  return side;
}

// Centre of the solids' texel that a pixel falls into, or of the last one before the viewport's end.
// Where texels are larger than pixels, their borders are shifted off the pixels' centres: a trace along
// an axis must not depend on its rounding.
vec2 ssaoSolidsTexelOf(vec2 pixel)
{
  vec2 edge = vec2(solidsPlace.x, solidsPlace.y);
  vec2 last = vec2(viewport.x + viewport.z, viewport.y + viewport.w) -
    edge * float(0.5) - vec2(float(0.5), float(0.5));
  float shift = solidsPlace.x > float(1.0) ? float(0.125) : float(0.0);
  return floor((min(pixel, last) - vec2(solidsPlace.z, solidsPlace.w)) / edge +
           vec2(shift, shift)) +
    vec2(float(0.5), float(0.5));
}

// Marks what a sample hides.
//   facing   1 where the point's surface shows its front, -1 where it shows its back
//   share    of the reach at which it is taken;  join: fronts nearer than this lie on one surface
//   jitter   from 0 to 1: how arcs are rounded
SsaoSide ssaoTakeSample(SsaoSide side, vec2 pixel, float share, float join, vec4 center,
  float facing, vec2 centerRay, vec3 facet, vec3 viewer, float normalCosine, float jitter)
{
  vec2 texel = ssaoSolidsTexelOf(pixel + side.reach * share);
  vec2 at = texel * vec2(solidsPlace.x, solidsPlace.y) + vec2(solidsPlace.z, solidsPlace.w);
  SsaoRay ray = ssaoRayOf(
    ssaoTransform2(pixelToRay, at - pixel), center.x, centerRay, facet, viewer, perspective);
  float inverse = float(1.0) / ray.squares.z;
  float middle = -ray.squares.y * inverse;
  float squaredHalf = (radius * radius - ray.squares.x) * inverse + middle * middle;
  float halfLength = ssaoIsInViewport(at, drawn) ? sqrt(max(squaredHalf, float(0.0))) : float(0.0);
  vec2 ball = vec2(middle - halfLength, middle + halfLength);
  SsaoStretches solids =
    ssaoStretchesSeen(ssaoSolidsAt(texel), ssaoMoreSolidsAt(texel), facing, sheet);
  // Two of the three are looked at: what ends in front of the ball hides nothing.
  bool before = solids.first.y - center.x <= ball.x;
  vec2 firstStretch = before ? solids.second : solids.first;
  vec2 secondStretch = before ? solids.third : solids.second;
  vec3 first = ssaoHiddenArc(ray, firstStretch, center.x, ball, side.lowest);
  vec3 second = ssaoHiddenArc(ray, secondStretch, center.x, ball, side.lowest);
  // A surface may have come in front of one that goes on, or have ended there.
  vec3 firstJoined = ssaoJoin(ssaoJoin(first, side.first, join), side.second, join);
  vec3 secondJoined = ssaoJoin(ssaoJoin(second, side.first, join), side.second, join);
  SsaoSide result = side;
  result.hidden = side.hidden |
    ssaoSectorsOf(firstJoined, normalCosine, side.normalSine, side.sectorsPerMeasure, jitter) |
    ssaoSectorsOf(secondJoined, normalCosine, side.normalSine, side.sectorsPerMeasure, jitter);
  result.first = first;
  result.second = second;
  return result;
}

// The measure of what is seen on a side.
float ssaoVisibleMeasure(SsaoSide side)
{
  return (float(30.0) - float(ssaoNumberOfSectors(side.hidden))) / side.sectorsPerMeasure;
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
  float footprint = solidsPlace.x * length(vec2(pixelToRay.x, pixelToRay.z)) *
    (perspective * center.x + (float(1.0) - perspective));
  // Of a face that is there twice the solids know which side counts; where they were looked for at
  // another pixel they may tell of another surface than the one whose facet the pixel shows.
  vec2 ownTexel = ssaoSolidsTexelOf(pixel);
  float own = ssaoSolidsAt(ownTexel).x;
  SsaoRay ownRay = ssaoRayOf(ssaoTransform2(pixelToRay,
      ownTexel * vec2(solidsPlace.x, solidsPlace.y) + vec2(solidsPlace.z, solidsPlace.w) - pixel),
    center.x, centerRay, facet, viewer, perspective);
  float onFacet = center.x - ownRay.facet.x / min(ownRay.facet.y, float(-0.000001));
  bool isOwn = abs(abs(own) - onFacet) < float(2.0) * footprint;
  float facing = isOwn ? (own < float(0.0) ? float(-1.0) : float(1.0)) : ssaoUnpackFacing(center.z);
  float visible = float(0.0);
  float open = float(0.0);
  float sign = float(1.0);
  // Both sides of all slices in one loop, which keeps the program small: software rasterisers pay for
  // its length.
  for (int i = 0; i < 2 * directions; ++i)
  {
    SsaoSlice slice = ssaoSlice(across, up, viewer, normal, facet, turn);
    vec2 reach = ssaoTrace(slice, positionVC, rayToPixel, perspective) * radius;
    float inside = ssaoShareInside(pixel, reach * sign, viewport, solidsPlace.x);
    float reachInPixels = length(reach) * inside / solidsPlace.x;
    SsaoSide side = ssaoSide(reach * (sign * inside),
      sign > float(0.0) ? slice.lowestAhead : slice.lowestBehind, slice.normalCosine,
      slice.normalSine * sign, center.x);
    float shareBefore = float(0.0);
    int count = min(steps, int(ceil(reachInPixels)));
    for (int j = 0; j < count; ++j)
    {
      float share = ssaoSampleShare(float(j) + noise.y, float(count), reachInPixels);
      float join = float(4.0) * max((share - shareBefore) * inside * radius, footprint);
      shareBefore = share;
      side = ssaoTakeSample(side, pixel, share, join, center, facing, centerRay, facet, viewer,
        slice.normalCosine, noise.y);
    }
    float weight = slice.weight * sqrt(inside);
    visible += weight * ssaoVisibleMeasure(side);
    open += weight * float(30.0) / side.sectorsPerMeasure;
    turn = sign > float(0.0) ? turn : ssaoTurned(turn, sliceTurn);
    sign = -sign;
  }
  ssaoCertainty = open / float(max(directions, 1));
  return open > float(0.000001) ? clamp(visible / open, float(0.0), float(1.0)) : float(1.0);
}
