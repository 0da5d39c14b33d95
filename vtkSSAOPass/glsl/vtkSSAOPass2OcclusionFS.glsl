//VTK::System::Dec
//VTK::Output::Dec

// Stage 2: geometry to (raw ambient visibility, depth, certainty, 1 if samples were taken). The second
// and third are for the denoiser, the last is counted.

//SSAO::Functions
//SSAO::View

uniform float radius;            // world units
uniform float bias;              // world units
uniform int samplesInKernel;     // number of sample points
uniform int rangeCheck;          // 1: occluders far in front of the surface count less
uniform int halfRule;            // CrytekSphere, 1: only what is hidden beyond one half counts
uniform float minimumDifference; // ReflectedHemisphere: share of the radius
uniform float falloffExponent;   // ReflectedHemisphere
uniform int falloff;             // ReflectedHemisphere: FalloffType of the public class
uniform int allDirections;       // HorizonAngle; ExactHorizon, LayeredBitmask: slices
uniform int allSteps;            // of these: samples for each direction or side of a slice
uniform float leastReach;        // ExactHorizon, LayeredBitmask: pixels that the radius must cover
uniform vec4 uneven;             // LayeredBitmask: (x, y, end of x, end of y): all other texels show ...
uniform float evenFacet;         // ... planes with this packed facet normal; 0: not known
uniform vec2 angleBias;          // HorizonAngle: (cos, sin)
uniform sampler2D solids;        // LayeredBitmask: (front, back, front, back) of each ray's stretches
uniform sampler2D moreSolids;    // LayeredBitmask: the third and fourth stretch
uniform vec4 solidsPlace;        // LayeredBitmask: (scale, offset): pixel of a texel of these
uniform vec2 solidsTexelSize;    // LayeredBitmask: 1 / size of these
uniform float sheet;             // LayeredBitmask: thickness of what has no back, world units
uniform vec2 sliceTurn;          // ExactHorizon, LayeredBitmask: (cos, sin) from slice to slice
uniform float downsampling;      // edge in pixels of the squares of which one pixel is estimated
uniform float noiseSize;         // edge of the noise tile in estimated pixels
uniform sampler2D kernelTexture; // kernelSize x 1: the estimator's sample points, lengths up to 1
uniform sampler2D noiseTexture;  // noiseSize x noiseSize: see vtkSSAONoiseTile

vec3 ssaoKernelAt(int index)
{
  return textureLod(kernelTexture, vec2((float(index) + 0.5) / float(samplesInKernel), 0.5), 0.0).xyz;
}

// The random numbers of a pixel: (turn, second number, cos and sin of the turn), the first two
// from 0 to 1; for ExactHorizon and LayeredBitmask cos and sin are of the first slice's angle. The
// tile starts at the viewport's corner, so that the picture does not depend on where the viewport
// lies.
vec4 ssaoNoiseAt(vec2 pixel)
{
  return textureLod(noiseTexture, (pixel - viewport.xy) / (noiseSize * downsampling), 0.0);
}

// LayeredBitmask: the stretches of a pixel's ray inside solids, (front, back, front, back); 0: none.
vec4 ssaoSolidsAt(vec2 texel)
{
  return textureLod(solids, texel * solidsTexelSize, 0.0);
}

vec4 ssaoMoreSolidsAt(vec2 texel)
{
  return textureLod(moreSolids, texel * solidsTexelSize, 0.0);
}

// How much of the hemisphere the visibility speaks for: what a slice weighs, and how much of it lay
// inside the picture. Means over pixels are weighted with it, as those over slices are: one slice does
// for a pixel then. An estimator may set it.
float ssaoCertainty = 1.0;

// What an estimator takes of its samples and directions: nothing where there is no surface. Software
// rasterisers leave a loop that no pixel is in, but run both sides of a branch.
int kernelSize = 0;
int directions = 0;
int steps = 0;

//SSAO::Estimator

// Whether samples may tell something: the radius covers enough pixels, and within it not all is the one
// plane that the pixel shows.
bool ssaoNeedsSamples(vec2 pixel, vec4 center)
{
  vec2 ray = ssaoRayThrough(pixel, pixelToRay, rayOffset, depthSlope, perspective);
  float reach = ssaoLargestReach(radius, center.x, ray, rayToPixel, perspective);
  vec2 away = max(uneven.xy - pixel, pixel - uneven.zw);
  bool isEven = max(away.x, away.y) > reach + 2.0 * solidsPlace.x;
  return center.x > 0.0 && reach >= leastReach && !(isEven && center.z == evenFacet);
}

void main()
{
  vec2 pixel = downsampling > 1.0
    ? viewport.xy + downsampling * floor(gl_FragCoord.xy) + 0.5
    : gl_FragCoord.xy;
  vec4 center = ssaoGeometryAt(pixel);
  kernelSize = center.x > 0.0 ? samplesInKernel : 0;
  directions = center.x > 0.0 ? allDirections : 0;
  steps = ssaoNeedsSamples(pixel, center) ? allSteps : 0;
  float visibility = center.x > 0.0 ? ssaoVisibility(pixel, center) : 1.0;
  gl_FragData[0] = vec4(visibility, center.x, ssaoCertainty, steps > 0 ? 1.0 : 0.0);
}
