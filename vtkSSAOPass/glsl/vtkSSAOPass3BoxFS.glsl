//VTK::System::Dec
//VTK::Output::Dec

// Stage 3, denoiser Box: the plain mean over one rotation tile, at -N/2 .. N/2-1 pixels
// (LearnOpenGL, "SSAO": -2..1). It does not know of edges.

//SSAO::View

uniform sampler2D visibility; // (raw ambient visibility, depth, certainty)
uniform int noiseSize;        // edge of the rotation tile in pixels

void main()
{
  vec2 low = viewport.xy + 0.5;
  vec2 high = viewport.xy + viewport.zw - 0.5;
  float sum = 0.0;
  float weights = 0.0;
  for (int j = 0; j < noiseSize; ++j)
  {
    for (int i = 0; i < noiseSize; ++i)
    {
      vec2 pixel = gl_FragCoord.xy + vec2(ivec2(i, j) - noiseSize / 2);
      vec3 neighbour = textureLod(visibility, clamp(pixel, low, high) * texelSize, 0.0).xyz;
      sum += neighbour.z * neighbour.x;
      weights += neighbour.z;
    }
  }
  float mean = sum / max(weights, 0.000001);
  // A pixel without a surface has no occlusion to blur.
  gl_FragData[0] = vec4(ssaoGeometryAt(gl_FragCoord.xy).x > 0.0 ? mean : 1.0, 0.0, 0.0, 1.0);
}
