//VTK::System::Dec
//VTK::Output::Dec

// Stage 3, denoiser BoxCentered: the plain mean over one noise tile, at -(N-1)/2 .. (N-1)/2 pixels
// (OGLdev, tutorial 45: -1.5 .. 1.5), so that the picture does not shift. With an even N the places
// lie between four pixels, and linear filtering reads their mean: of N + 1 rows the outermost count
// half. It does not know of edges.

//SSAO::View

uniform sampler2D visibility; // (raw ambient visibility, depth, certainty)
uniform int noiseSize;        // edge of the noise tile in pixels

void main()
{
  vec2 low = viewport.xy + 0.5;
  vec2 high = viewport.xy + viewport.zw - 0.5;
  int reach = noiseSize / 2;
  float border = noiseSize % 2 == 0 ? 0.5 : 1.0;
  float sum = 0.0;
  float weights = 0.0;
  for (int j = -reach; j <= reach; ++j)
  {
    for (int i = -reach; i <= reach; ++i)
    {
      float weight = (abs(i) == reach ? border : 1.0) * (abs(j) == reach ? border : 1.0);
      vec2 pixel = gl_FragCoord.xy + vec2(i, j);
      vec3 neighbour = textureLod(visibility, clamp(pixel, low, high) * texelSize, 0.0).xyz;
      weight *= neighbour.z;
      sum += weight * neighbour.x;
      weights += weight;
    }
  }
  float mean = sum / max(weights, 0.000001);
  // A pixel without a surface has no occlusion to blur.
  gl_FragData[0] = vec4(ssaoGeometryAt(gl_FragCoord.xy).x > 0.0 ? mean : 1.0, 0.0, 0.0, 1.0);
}
