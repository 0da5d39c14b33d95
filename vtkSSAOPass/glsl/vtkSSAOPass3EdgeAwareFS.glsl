//VTK::System::Dec
//VTK::Output::Dec

// Stage 3, denoiser EdgeAware: the mean over one rotation tile, centred, of the pixels that lie on
// the same surface. With an even tile the outermost rows count half, so that each rotation of the
// tile has the same weight and its pattern cancels.

//SSAO::Functions
//SSAO::View

uniform sampler2D visibility; // raw ambient visibility
uniform int noiseSize;        // edge of the rotation tile in pixels

void main()
{
  vec2 pixel = gl_FragCoord.xy;
  vec4 center = ssaoGeometryAt(pixel);
  float result = 1.0;
  if (center.x > 0.0)
  {
    vec3 positionVC =
      ssaoPositionVC(pixel, center.x, pixelToRay, rayOffset, depthSlope, perspective);
    vec3 normal = ssaoUnpackNormal(center.y);
    float footprint = length(vec2(pixelToRay.x, pixelToRay.z)) *
      (perspective > 0.5 ? center.x : 1.0);
    int reach = noiseSize / 2;
    float border = noiseSize % 2 == 0 ? 0.5 : 1.0;
    float sum = 0.0;
    float weights = 0.0;
    for (int j = -reach; j <= reach; ++j)
    {
      for (int i = -reach; i <= reach; ++i)
      {
        vec2 at = pixel + vec2(i, j);
        bool inside = at.x >= viewport.x && at.y >= viewport.y &&
          at.x < viewport.x + viewport.z && at.y < viewport.y + viewport.w;
        vec4 neighbour = ssaoGeometryAt(at);
        vec3 neighbourVC =
          ssaoPositionVC(at, neighbour.x, pixelToRay, rayOffset, depthSlope, perspective);
        float weight = (abs(i) == reach ? border : 1.0) * (abs(j) == reach ? border : 1.0) *
          ssaoPlaneWeight(neighbourVC - positionVC, normal, footprint) *
          ssaoNormalWeight(normal, ssaoUnpackNormal(neighbour.y));
        weight = inside && neighbour.x > 0.0 ? weight : 0.0;
        sum += weight * textureLod(visibility, at * texelSize, 0.0).x;
        weights += weight;
      }
    }
    result = sum / weights;
  }
  gl_FragData[0] = vec4(result, 0.0, 0.0, 1.0);
}
