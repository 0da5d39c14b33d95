//VTK::System::Dec
//VTK::Output::Dec

// Stage 3: the interpolated visibility of every pixel, for what does not modulate the picture at once.

//SSAO::Functions
//SSAO::View
//SSAO::Interpolation

void main()
{
  float interpolated = ssaoInterpolated(gl_FragCoord.xy, ssaoGeometryAt(gl_FragCoord.xy));
  gl_FragData[0] = vec4(interpolated, 0.0, 0.0, 1.0);
}
