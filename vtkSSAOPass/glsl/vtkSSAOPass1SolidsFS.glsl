//VTK::System::Dec
//VTK::Output::Dec

// Between stages 1 and 2, for estimators that look behind the first surface: the layers of each pixel
// become the stretches of its ray that lie inside solids. Whether fronts or backs enter them is taken
// from the first surface; the first front is negative if it shows its back.

//SSAO::Functions

uniform sampler2D geometry; // (depth, packed normal, packed facet normal, 1); depth 0: no surface
uniform sampler2D layers;   // what lies behind it: -depth of the nearest front, depth of the farthest
                            // front, -depth of the nearest back, depth of the farthest back
uniform sampler2D inner;    // what lies between these, in the same way
uniform vec2 texelSize;     // 1 / size of the latter
uniform vec4 geometryPlace; // (scale, offset): place in the first of a place in the latter, in texels
uniform int firstKnown;     // 0: the first surface is among the layers, not in the geometry
uniform int rounds;         // 0: neither of them is known, 1: inner is not
uniform float reach;        // within which behind the first surface layers are known, world units
uniform float sheet;        // thickness in world units of what has no known back
uniform int sheetsOnly;     // 1: every surface has that thickness

const float none = 1.0e30;

// The depths of one facing, near to far, none at the end. outer, inside: (-nearest, farthest), the
// latter negative if it is out of reach.
vec4 sorted(vec2 outer, vec2 inside)
{
  float farthest = abs(outer.y) > -outer.x ? abs(outer.y) : none;
  float secondFarthest = abs(inside.y) > -inside.x ? abs(inside.y) : farthest;
  return vec4(-outer.x, -inside.x < none ? -inside.x : farthest,
    -inside.x < none ? secondFarthest : none, secondFarthest < farthest ? farthest : none);
}

void main()
{
  vec2 at = gl_FragCoord.xy * texelSize;
  vec4 first = textureLod(geometry, gl_FragCoord.xy * geometryPlace.xy + geometryPlace.zw, 0.0);
  vec4 outer = rounds > 0 ? textureLod(layers, at, 0.0) : vec4(-none);
  vec4 inside = rounds > 1 ? textureLod(inner, at, 0.0) : vec4(-none);
  vec4 fronts = sorted(outer.xy, inside.xy);
  vec4 backs = sorted(outer.zw, inside.zw);

  bool known = firstKnown == 1;
  float facing = known ? ssaoUnpackFacing(first.z) : (fronts.x <= backs.x ? 1.0 : -1.0);
  // A face that is there twice, wound both ways, is a sheet that shows its front, whichever of the two
  // the rasteriser chose.
  bool firstIsBack = known && facing < 0.0;
  float front = known && !firstIsBack ? first.x : fronts.x;
  float back = firstIsBack ? first.x : backs.x;
  if (back < none && abs(front - back) < 1.0e-5 * back)
  {
    fronts = firstIsBack ? vec4(fronts.yzw, none) : fronts;
    backs = vec4(1.00001 * front, firstIsBack ? backs.xyz : backs.yzw);
    facing = 1.0;
  }

  // Merge the two lists; negative: a back.
  float depths[SSAO_LAYERS];
  float nearestOfAll = known ? first.x : min(fronts.x, backs.x);
  depths[0] = known ? first.x : 0.0;
  int count = depths[0] > 0.0 ? 1 : 0;
  int insideAtEnd = ssaoInsideAfter(0, depths[0]);
  for (int i = 1; i < SSAO_LAYERS; ++i)
  {
    // Where bodies touch rounding does not decide: one is entered before the other is left.
    bool touching = backs.x < none && abs(fronts.x - backs.x) < 1.0e-5 * backs.x;
    bool isFront = touching ? facing > 0.0 : fronts.x <= backs.x;
    float nearest = isFront ? fronts.x : backs.x;
    depths[i] = nearest < none ? (isFront ? facing : -facing) * nearest : 0.0;
    fronts = isFront ? vec4(fronts.yzw, none) : fronts;
    backs = isFront ? backs : vec4(backs.yzw, none);
    count += nearest < none ? 1 : 0;
    insideAtEnd = ssaoInsideAfter(insideAtEnd, depths[i]);
  }

  // A ray with as many layers as can be told that does not get out again has lost some.
  float pairs = count >= SSAO_LAYERS - (known ? 0 : 1) && insideAtEnd > 0 ? 1.0 : 0.0;
  SsaoSolids solids = ssaoNoSolids();
  for (int i = 0; i < SSAO_LAYERS; ++i)
  {
    if (sheetsOnly == 0)
    {
      solids = ssaoAddLayer(solids, depths[i], sheet, pairs);
    }
    else if (depths[i] != 0.0)
    {
      solids = ssaoAddSolid(solids, abs(depths[i]), abs(depths[i]) + sheet);
    }
  }
  float end = count == 1 ? none : nearestOfAll + reach;
  solids = sheetsOnly == 0 ? ssaoCloseSolids(solids, end, sheet, pairs) : solids;
  gl_FragData[0] = vec4(solids.first.x * facing, solids.first.yzw);
  gl_FragData[1] = solids.second;
}
