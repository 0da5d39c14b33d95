// Stage 1, put before main() of a mapper's fragment shader.
uniform vec3 ssaoOccludableWeights; // of the ambient, the diffuse and the whole colour
uniform vec4 ssaoDepthOfWindowRows; // rows 2 and 3 of the projection, see ssaoDepthOfWindow
uniform float ssaoDepthOrigin;      // how far in front of the camera depths begin, world units
uniform vec2 ssaoDepthOfClip;       // (scale, offset): depth of a clip coordinate z; 0: take that of VC
uniform float ssaoPerspective;      // 1: perspective, 0: parallel projection
uniform float ssaoFrontSign;        // -1: the actor's transform mirrors, front and back are swapped
// Far from the camera z of the clip coordinates has digits that z in VC has lost: it is about 0 in the
// middle of the clipping range. A geometry shader passes it on in the fragment's position alone.
#if defined(SSAO_CLIP_VARYING)
in float ssaoClipVSOutput;
#define SSAO_CLIP ssaoClipVSOutput
#else
#define SSAO_CLIP ((gl_FragCoord.z * 2.0 - 1.0) / gl_FragCoord.w)
#endif
// Without the offset, for differences.
#define SSAO_MESH_RELATIVE_DEPTH \
  (ssaoDepthOfClip.x != 0.0 ? SSAO_CLIP * ssaoDepthOfClip.x : -vertexVC.z)
#define SSAO_MESH_DEPTH (SSAO_MESH_RELATIVE_DEPTH + ssaoDepthOfClip.y)
#if defined(SSAO_LAYERS)
#define SSAO_NONE 1.0e30
uniform sampler2D ssaoLayersBefore; // first round: the captured geometry, later: the layers before
uniform float ssaoFirstRound;       // 1 in the first round
uniform vec4 ssaoBeforePlace;       // (scale, offset): place in that texture of a place on the screen
uniform float ssaoFirstKnown;       // 0: the captured depth is not that at the pixel's centre
uniform vec2 ssaoMargin;            // by which a depth may be off: share of it, share of its change to the next pixel
uniform float ssaoReach;            // how far behind the first surface layers matter, world units
uniform float ssaoSheet;            // thickness of sprites, world units

// -depth and, within reach of the first surface, depth, beyond it -depth again; -1e30 twice if it does
// not count: the first round looks behind the first surface, if that is known exactly, the next ones
// between what is known.
//   known     of this facing, in the later rounds: -depth of the nearest, depth of the farthest
//   first     in the first round: depth of the first surface
//   sameSide  in the first round: whether that shows the same side, 1 or -1. Its other side may lie in
//             the very same place: a face that is there twice, wound both ways
//   off       by which the depth may be off
vec2 ssaoLayer(float depth, vec2 known, float first, float sameSide, float off)
{
  bool isFirst = ssaoFirstRound > 0.5;
  float near = isFirst ? ssaoFirstKnown * first : -known.x;
  float limit = (isFirst ? first : near) + ssaoReach;
  float low = near + (isFirst && sameSide < 0.0 ? -4.0 * off : off);
  bool counts = depth > low && (isFirst || depth < abs(known.y) - off);
  return counts ? vec2(-depth, depth < limit ? depth : -depth) : vec2(-SSAO_NONE);
}
#endif
