//VTK::System::Dec
//VTK::Output::Dec

// Stage 2: geometry to raw ambient visibility, one value per pixel.

//SSAO::Functions
//SSAO::View

uniform float radius;            // world units
uniform float bias;              // world units
uniform int kernelSize;          // number of sample points
uniform float noiseSize;         // edge of the rotation tile in pixels
uniform sampler2D kernelTexture; // kernelSize x 1: sample points in the unit hemisphere about +z
uniform sampler2D noiseTexture;  // noiseSize x noiseSize: (cos, sin) of the rotation

vec3 ssaoKernelAt(int index)
{
  return textureLod(kernelTexture, vec2((float(index) + 0.5) / float(kernelSize), 0.5), 0.0).xyz;
}

// The rotation of a pixel; the tile starts at the viewport's corner, so that the picture does not
// depend on where the viewport lies.
vec2 ssaoRotationAt(vec2 pixel)
{
  return textureLod(noiseTexture, (pixel - viewport.xy) / noiseSize, 0.0).xy;
}

//SSAO::Estimator

void main()
{
  vec4 center = ssaoGeometryAt(gl_FragCoord.xy);
  float visibility = center.x > 0.0 ? ssaoVisibility(gl_FragCoord.xy, center) : 1.0;
  gl_FragData[0] = vec4(visibility, 0.0, 0.0, 1.0);
}
