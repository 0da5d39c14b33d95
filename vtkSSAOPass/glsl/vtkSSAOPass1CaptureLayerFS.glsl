  // Stage 1, before lighting: where this surface is and which side it shows.
#if defined(SSAO_LIT)
#if defined(SSAO_SPRITE)
  float ssaoDepth = ssaoDepthOfWindow(gl_FragDepth, ssaoDepthOfWindowRows);
#elif defined(SSAO_IMPOSTOR)
  float ssaoDepth = -vertexVC.z - ssaoDepthOrigin;
#else
  float ssaoDepth = SSAO_MESH_DEPTH;
#endif
#if defined(SSAO_IMPOSTOR)
  float ssaoFacing = 1.0;
#else
  float ssaoFacing = gl_FrontFacing ? ssaoFrontSign : -ssaoFrontSign;
#endif
#if defined(SSAO_LAYERS)
  // An impostor has no faces behind: its exit is computed.
#if defined(SSAO_SPRITE)
  float ssaoExit = ssaoDepth + ssaoSheet;
#elif defined(SSAO_IMPOSTOR)
  vec3 ssaoRay = -ssaoTowardsViewer(vertexVC.xyz, ssaoPerspective);
  float ssaoThrough = 2.0 * radiusVCVSOutput * max(-dot(normalVCVSOutput, ssaoRay), 0.0);
#if defined(SSAO_STICK)
  float ssaoAlong = dot(ssaoRay, orientVCVSOutput);
  ssaoThrough = min(ssaoThrough / max(1.0 - ssaoAlong * ssaoAlong, 0.01), lengthVCVSOutput);
#endif
  float ssaoExit = ssaoDepth - ssaoThrough * ssaoRay.z;
#endif
#endif
#endif
