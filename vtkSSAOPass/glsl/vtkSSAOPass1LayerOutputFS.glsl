  // Instead of the picture, as a front and as a back: -depth and, within reach of the first surface,
  // depth, beyond it -depth again. Blending keeps the largest of each, so that of fronts and backs the
  // nearest and the farthest within reach remain, or, if none is within reach, the next.
#if defined(SSAO_LIT)
  {
    vec4 ssaoKnown = textureLod(
      ssaoLayersBefore, gl_FragCoord.xy * ssaoBeforePlace.xy + ssaoBeforePlace.zw, 0.0);
    // In the first round: behind the first surface, if it is known exactly; then between what is known.
    float ssaoFirst = ssaoFirstKnown > 0.5 ? ssaoKnown.x : 0.0;
    vec4 ssaoBounds = ssaoFirstRound > 0.5
      ? vec4(ssaoFirst, SSAO_NONE, ssaoFirst, SSAO_NONE)
      : vec4(-ssaoKnown.x, abs(ssaoKnown.y), -ssaoKnown.z, abs(ssaoKnown.w));
#if defined(SSAO_IMPOSTOR)
    vec2 ssaoEnds = vec2(ssaoDepth, ssaoExit);
#else
    vec2 ssaoEnds = vec2(ssaoFacing > 0.0 ? ssaoDepth : SSAO_NONE, ssaoFacing > 0.0 ? SSAO_NONE : ssaoDepth);
#endif
    // The surface that set a bound must not pass it, though it may come out rounded otherwise here.
#if defined(SSAO_IMPOSTOR)
    // Beyond an impostor's rim there is no depth to take a difference with. VTK computes it from the
    // camera on.
    vec3 ssaoViewer = ssaoTowardsViewer(vertexVC.xyz, ssaoPerspective);
    float ssaoChange = dot(abs(normalVCVSOutput.xy), fwidth(vertexVCVSOutput.xy)) /
      max(abs(dot(normalVCVSOutput, ssaoViewer)), 0.02);
    float ssaoRounding = ssaoMargin.x * (ssaoDepth + ssaoDepthOrigin);
#else
    float ssaoChange = fwidth(ssaoDepth);
    float ssaoRounding = ssaoMargin.x * ssaoDepth;
#endif
    float ssaoOff = ssaoRounding + ssaoMargin.y * ssaoChange;
    vec4 ssaoWithin = ssaoBounds + vec4(ssaoOff, -ssaoOff, ssaoOff, -ssaoOff);
    // Its other side may lie in the very same place: a face that is there twice, wound both ways.
    float ssaoCoincident = ssaoFirst - 4.0 * ssaoOff;
    bool ssaoFirstIsFront = ssaoUnpackFacing(ssaoKnown.z) > 0.0;
    ssaoWithin.x = ssaoFirstRound > 0.5 && !ssaoFirstIsFront ? ssaoCoincident : ssaoWithin.x;
    ssaoWithin.z = ssaoFirstRound > 0.5 && ssaoFirstIsFront ? ssaoCoincident : ssaoWithin.z;
    bool ssaoIsFront = ssaoEnds.x > ssaoWithin.x && ssaoEnds.x < ssaoWithin.y;
    bool ssaoIsBack = ssaoEnds.y > ssaoWithin.z && ssaoEnds.y < ssaoWithin.w;
    vec2 ssaoLimit =
      (ssaoFirstRound > 0.5 ? ssaoKnown.xx : vec2(ssaoBounds.x, ssaoBounds.z)) + ssaoReach;
    vec2 ssaoFar = vec2(ssaoEnds.x < ssaoLimit.x ? ssaoEnds.x : -ssaoEnds.x,
      ssaoEnds.y < ssaoLimit.y ? ssaoEnds.y : -ssaoEnds.y);
    gl_FragData[0] = vec4(ssaoIsFront ? vec2(-ssaoEnds.x, ssaoFar.x) : vec2(-SSAO_NONE),
      ssaoIsBack ? vec2(-ssaoEnds.y, ssaoFar.y) : vec2(-SSAO_NONE));
  }
#else
  gl_FragData[0] = vec4(-SSAO_NONE);
#endif
