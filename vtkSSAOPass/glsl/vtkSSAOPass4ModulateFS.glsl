//VTK::System::Dec
//SSAO::Samples::Dec
//VTK::Output::Dec

// Stage 4: what is to be taken from the picture, in its own encoding: blending subtracts it. Or, with
// SSAO_ALL_OCCLUDABLE, the visibility, with which blending multiplies the picture.
// With SSAO_INTERPOLATED the visibility of one pixel of each square is known, and interpolated here.

//SSAO::Functions
#if defined(SSAO_INTERPOLATED)
//SSAO::View
//SSAO::Interpolation
#else
uniform sampler2D geometry;   // (depth, ...); depth 0: nothing that may be occluded
uniform sampler2D visibility; // denoised ambient visibility
uniform vec2 texelSize;       // 1 / size of these textures
#endif
uniform vec4 strength;        // power, intensity, scale, shift of ssaoStrength
uniform int haveLit;          // 1: texture lit holds the colour before clamping
uniform float white;          // largest value the picture can hold, 1 if it is clamped
#if defined(SSAO_ALL_OCCLUDABLE)
// The picture itself.
#elif defined(SSAO_MULTISAMPLE)
uniform sampler2DMS occludable; // part of the light that may be occluded, textures included
uniform sampler2DMS lit;        // colour before clamping; negative: linear light
#define SSAO_LIGHT(texture) texelFetch(texture, ivec2(gl_FragCoord.xy), gl_SampleID).rgb
#else
uniform sampler2D occludable;
uniform sampler2D lit;
#define SSAO_LIGHT(texture) textureLod(texture, gl_FragCoord.xy * texelSize, 0.0).rgb
#endif

void main()
{
  vec2 place = gl_FragCoord.xy * texelSize;
  vec4 center = textureLod(geometry, place, 0.0);
#if defined(SSAO_INTERPOLATED)
  float ambient = ssaoInterpolated(gl_FragCoord.xy, center);
#else
  float ambient = textureLod(visibility, place, 0.0).x;
#endif
  float v = ssaoStrength(ambient, strength.x, strength.y, strength.z, strength.w);
  if (v >= 1.0)
  {
    discard;
  }
#if defined(SSAO_ALL_OCCLUDABLE)
  gl_FragData[0] = vec4(vec3(center.x > 0.0 ? v : 1.0), 0.0);
#else
  vec3 taken = (1.0 - v) * SSAO_LIGHT(occludable);
  if (haveLit == 1)
  {
    vec3 before = SSAO_LIGHT(lit);
    bool linear = any(lessThan(before, vec3(0.0)));
    before = abs(before);
    vec3 after = max(before - taken, vec3(0.0));
    if (linear)
    {
      before = pow(before, vec3(1.0 / 2.2));
      after = pow(after, vec3(1.0 / 2.2));
    }
    taken = min(before, vec3(white)) - min(after, vec3(white));
  }
  gl_FragData[0] = vec4(taken, 0.0);
#endif
}
