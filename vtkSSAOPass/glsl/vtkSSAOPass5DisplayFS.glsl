//VTK::System::Dec
//VTK::Output::Dec

// Instead of the picture: visibility, normals or depth.

//SSAO::Functions

uniform sampler2D geometry;   // (depth, packed normal, packed facet normal, 1)
uniform sampler2D visibility; // denoised ambient visibility
uniform vec4 target;          // viewport that is written
uniform vec4 source;          // viewport in the textures
uniform vec2 texelSize;       // 1 / size of the textures
uniform int mode;             // OutputModeType of the public class
uniform vec2 clippingRange;   // depths shown as 0 and 1

void main()
{
  vec2 at = ((gl_FragCoord.xy - target.xy) / target.zw * source.zw + source.xy) * texelSize;
  vec4 center = textureLod(geometry, at, 0.0);
  vec3 shown = vec3(center.x > 0.0 ? textureLod(visibility, at, 0.0).x : 1.0);
  if (mode == 3)
  {
    shown = center.x > 0.0 ? ssaoUnpackNormal(center.y) * 0.5 + 0.5 : vec3(0.0);
  }
  else if (mode == 4)
  {
    float range = clippingRange.y - clippingRange.x;
    shown = vec3(center.x > 0.0 ? clamp((center.x - clippingRange.x) / range, 0.0, 1.0) : 1.0);
  }
  gl_FragData[0] = vec4(shown, 1.0);
}
