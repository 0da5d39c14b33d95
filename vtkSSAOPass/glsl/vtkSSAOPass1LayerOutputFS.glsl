  // Instead of the picture, as a front and as a back: what ssaoLayer returns. Blending keeps the largest
  // of each, so that of fronts and backs the nearest and the farthest within reach remain, or, if none
  // is within reach, the next.
#if defined(SSAO_LIT)
  {
    vec4 ssaoKnown = textureLod(
      ssaoLayersBefore, gl_FragCoord.xy * ssaoBeforePlace.xy + ssaoBeforePlace.zw, 0.0);
    float ssaoFirstFacing = ssaoUnpackFacing(ssaoKnown.z);
    // The surface that set a bound must not pass it, though it may come out rounded otherwise here.
#if defined(SSAO_IMPOSTOR)
    // Beyond an impostor's rim there is no depth to take a difference with. VTK computes it from the
    // camera on.
    vec3 ssaoViewer = ssaoTowardsViewer(vertexVC.xyz, ssaoPerspective);
    float ssaoChange = dot(abs(normalVCVSOutput.xy), fwidth(vertexVCVSOutput.xy)) /
      max(abs(dot(normalVCVSOutput, ssaoViewer)), 0.02);
    float ssaoOff = ssaoMargin.x * (ssaoDepth + ssaoDepthOrigin) + ssaoMargin.y * ssaoChange;
    gl_FragData[0] = vec4(ssaoLayer(ssaoDepth, ssaoKnown.xy, ssaoKnown.x, ssaoFirstFacing, ssaoOff),
      ssaoLayer(ssaoExit, ssaoKnown.zw, ssaoKnown.x, -ssaoFirstFacing, ssaoOff));
#else
    bool ssaoIsFront = ssaoFacing > 0.0;
    vec2 ssaoFound = ssaoLayer(ssaoDepth, ssaoIsFront ? ssaoKnown.xy : ssaoKnown.zw, ssaoKnown.x,
      ssaoFacing * ssaoFirstFacing, ssaoMargin.x * ssaoDepth + ssaoMargin.y * fwidth(ssaoDepth));
    vec2 ssaoNone = vec2(-SSAO_NONE);
    gl_FragData[0] = ssaoIsFront ? vec4(ssaoFound, ssaoNone) : vec4(ssaoNone, ssaoFound);
#endif
  }
#else
  gl_FragData[0] = vec4(-SSAO_NONE);
#endif
