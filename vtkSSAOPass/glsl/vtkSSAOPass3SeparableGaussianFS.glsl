//VTK::System::Dec
//VTK::Output::Dec

// Stage 3, denoiser SeparableGaussian: the blur of Unity's SSAO image effect, drawn twice, across
// and then down. A Gaussian over the pixels to either side, as far as one noise tile, of those
// whose depth and normal are alike. The source's weights are 5 4 3 2 1; the Gaussian has the same
// variance.

//SSAO::Functions
//SSAO::View

uniform sampler2D visibility; // (raw ambient visibility, depth, certainty), or what is drawn here first
uniform int noiseSize;        // edge of the noise tile in pixels
uniform vec2 axis;            // (1, 0) across, (0, 1) down
uniform float largestStep;    // difference of depth that is an edge, world units

void main()
{
  vec2 pixel = gl_FragCoord.xy;
  vec4 center = ssaoGeometryAt(pixel);
  float result = 1.0;
  float certainty = 1.0;
  if (center.x > 0.0)
  {
    vec3 normal = ssaoUnpackNormal(center.y);
    float deviation = 0.5 * float(noiseSize);
    float sum = 0.0;
    float weights = 0.0;
    float gaussians = 0.0;
    for (int i = -noiseSize; i <= noiseSize; ++i)
    {
      vec2 at = pixel + float(i) * axis;
      vec4 neighbour = ssaoGeometryAt(at);
      // Normals up to 41 degrees apart: what the source's 0.1 of its encoding is.
      bool alike = ssaoIsInViewport(at, viewport) && neighbour.x > 0.0 &&
        abs(neighbour.x - center.x) < largestStep &&
        dot(ssaoUnpackNormal(neighbour.y), normal) > 0.75;
      float away = float(i) / deviation;
      float weight = alike || i == 0 ? exp(-0.5 * away * away) : 0.0;
      vec3 there = textureLod(visibility, at * texelSize, 0.0).xyz;
      sum += weight * there.z * there.x;
      weights += weight * there.z;
      gaussians += weight;
    }
    result = sum / max(weights, 0.000001);
    certainty = weights / gaussians;
  }
  gl_FragData[0] = vec4(result, center.x, certainty, 1.0);
}
