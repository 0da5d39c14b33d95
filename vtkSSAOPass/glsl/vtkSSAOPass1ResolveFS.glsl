//VTK::System::Dec
//VTK::Output::Dec

// Stage 1 under multisampling: the geometry of the first sample of each pixel that has any. The
// mappers evaluate position and normal at the pixel's centre for all samples of one surface.

uniform sampler2DMS geometry; // per sample (depth, packed normal, packed facet normal, 1)
uniform int samples;          // samples per pixel

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 found = vec4(0.0);
  for (int i = samples - 1; i >= 0; --i)
  {
    vec4 value = texelFetch(geometry, pixel, i);
    found = value.x > 0.0 ? value : found;
  }
  gl_FragData[0] = found;
}
