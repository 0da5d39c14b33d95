// Stage 3, denoiser EdgeAware where only one pixel of each square was estimated: from the four
// estimated pixels about a pixel, linearly, but only from those that lie on its surface.
uniform sampler2D visibility; // (ambient visibility, depth) of the estimated pixels
uniform vec2 coarseTexelSize; // 1 / size of that texture
uniform vec4 estimated;       // x, y, width, height of what of it was drawn
uniform float downsampling;   // edge of the squares in pixels of which the first is estimated

// The ambient visibility of a pixel, 1 where there is no surface.
//   pixel    position in the framebuffer
//   center   the geometry there: (depth, packed normal, packed facet normal, 1)
float ssaoInterpolated(vec2 pixel, vec4 center)
{
  SsaoPlane plane = ssaoPlaneThrough(ssaoUnpackFacet(center.z), pixel, center.x, pixelToRay, rayOffset,
    depthSlope, perspective);
  vec2 place = pixel - viewport.xy - 0.5;
  vec2 square = floor(place / downsampling);
  vec2 last = estimated.xy + estimated.zw - 1.0;
  float sum = 0.0;
  float weights = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 at = min(square + vec2(i % 2, i / 2), last);
    vec2 moved = at * downsampling - place;
    vec2 neighbour = textureLod(visibility, (at + 0.5) * coarseTexelSize, 0.0).xy;
    vec2 near = max(1.0 - abs(moved) / downsampling, 0.0);
    // Where nothing lies on the same surface, anything is better than nothing.
    float weight = neighbour.y > 0.0
      ? (near.x * near.y + 0.001) * (ssaoPlaneWeight(plane, neighbour.y, moved) + 0.0001)
      : 0.0;
    sum += weight * neighbour.x;
    weights += weight;
  }
  return center.x > 0.0 && weights > 0.0 ? sum / weights : 1.0;
}
