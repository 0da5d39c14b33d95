//VTK::System::Dec
//VTK::Output::Dec

// Stage 2: geometry to raw ambient visibility, one value per pixel.

//SSAO::Functions
//SSAO::View

uniform float radius;            // world units
uniform float bias;              // world units
uniform int kernelSize;          // number of sample points
uniform int rangeCheck;          // 1: occluders far in front of the surface count less
uniform int halfRule;            // CrytekSphere, 1: only what is hidden beyond one half counts
uniform float minimumDifference; // ReflectedHemisphere: share of the radius
uniform float falloffExponent;   // ReflectedHemisphere
uniform int falloff;             // ReflectedHemisphere: FalloffType of the public class
uniform int directions;          // HorizonAngle
uniform int steps;               // HorizonAngle: samples for each direction
uniform vec2 angleBias;          // HorizonAngle: (cos, sin)
uniform float noiseSize;         // edge of the noise tile in pixels
uniform sampler2D kernelTexture; // kernelSize x 1: the estimator's sample points, lengths up to 1
uniform sampler2D noiseTexture;  // noiseSize x noiseSize: see vtkSSAONoiseTile

vec3 ssaoKernelAt(int index)
{
  return textureLod(kernelTexture, vec2((float(index) + 0.5) / float(kernelSize), 0.5), 0.0).xyz;
}

// The random numbers of a pixel: (turn, second number, cos and sin of the turn), the first two
// from 0 to 1. The tile starts at the viewport's corner, so that the picture does not depend on
// where the viewport lies.
vec4 ssaoNoiseAt(vec2 pixel)
{
  return textureLod(noiseTexture, (pixel - viewport.xy) / noiseSize, 0.0);
}

//SSAO::Estimator

void main()
{
  vec4 center = ssaoGeometryAt(gl_FragCoord.xy);
  float visibility = center.x > 0.0 ? ssaoVisibility(gl_FragCoord.xy, center) : 1.0;
  gl_FragData[0] = vec4(visibility, 0.0, 0.0, 1.0);
}
