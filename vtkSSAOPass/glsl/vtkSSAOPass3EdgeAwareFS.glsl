//VTK::System::Dec
//VTK::Output::Dec

// Stage 3, denoiser EdgeAware: the mean over one rotation tile, centred, of the estimated pixels that
// lie on the same surface, by their distance from the facet's plane. With an even tile the outermost
// rows count half, so that each rotation of the tile has the same weight and its pattern cancels.

//SSAO::Functions
//SSAO::View

uniform sampler2D visibility; // (raw ambient visibility, depth, certainty) of the estimated pixels
uniform vec2 coarseTexelSize; // 1 / size of that texture
uniform float downsampling;   // edge of the squares in pixels of which the first is estimated
uniform vec4 estimated;       // x, y, width, height of what of it was drawn
uniform int noiseSize;        // edge of the rotation tile in estimated pixels

void main()
{
  vec2 corner = downsampling > 1.0 ? vec2(0.0) : viewport.xy;
  vec2 low = estimated.xy + 0.5;
  vec2 high = estimated.xy + estimated.zw - 0.5;
  vec2 pixel = viewport.xy + downsampling * (gl_FragCoord.xy - 0.5 - corner) + 0.5;
  vec2 center = textureLod(visibility, gl_FragCoord.xy * coarseTexelSize, 0.0).xy;
  SsaoPlane plane = ssaoPlaneThrough(ssaoUnpackFacet(ssaoGeometryAt(pixel).z), pixel, center.y,
    pixelToRay, rayOffset, depthSlope, perspective);
  // No turn of the loops where there is no surface.
  float reach = center.y > 0.0 ? float(noiseSize / 2) : -1.0;
  float border = noiseSize % 2 == 0 ? 0.5 : 1.0;
  float sum = 0.0;
  float weights = 0.0;
  for (float j = -reach; j <= reach; j += 1.0)
  {
    float rowWeight = abs(j) == reach ? border : 1.0;
    for (float i = -reach; i <= reach; i += 1.0)
    {
      vec2 at = clamp(gl_FragCoord.xy + vec2(i, j), low, high);
      vec3 neighbour = textureLod(visibility, at * coarseTexelSize, 0.0).xyz;
      float weight = (abs(i) == reach ? border : 1.0) * rowWeight * max(neighbour.z, 0.001) *
        ssaoPlaneWeight(plane, neighbour.y, (at - gl_FragCoord.xy) * downsampling);
      sum += weight * neighbour.x;
      weights += weight;
    }
  }
  gl_FragData[0] = vec4(center.y > 0.0 ? sum / weights : 1.0, center.y, 0.0, 1.0);
}
