  // Stage 1, after lighting and before textures: the part of the light that may be occluded.
#if defined(SSAO_PBR)
  vec3 ssaoLit = mix(ssaoImageBased + Lo, (ssaoImageBased + Lo) * ao, aoStrengthUniform) +
    emissiveColor;
  vec3 ssaoOccludable = (ssaoOccludableWeights.x * ssaoImageBased +
    ssaoOccludableWeights.y * ssaoDirectDiffuse) * mix(1.0, ao, aoStrengthUniform);
#elif defined(SSAO_LIT)
  vec3 ssaoLit = gl_FragData[0].rgb;
#if defined(SSAO_EDGES)
  vec3 ssaoAmbient = ambientColor - SSAO_EDGES;
#else
  vec3 ssaoAmbient = ambientColor;
#endif
  vec3 ssaoOccludable = ssaoOccludableWeights.x * ssaoAmbient + ssaoOccludableWeights.y * diffuse;
#endif
