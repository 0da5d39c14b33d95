  // Stage 1, when the colour is final: write what the later stages need. Blending is on while VTK
  // draws, with each output's own alpha: the geometry is replaced (1) or kept (0), light is blended
  // as the colour is. An interpolated alpha of 1 may have lost its last bit, so less than half a step
  // of eight bits counts as opaque.
#define SSAO_OPAQUE 0.998
#if defined(SSAO_LIT)
  {
    float ssaoAlpha = gl_FragData[0].a;
    vec3 ssaoColor = gl_FragData[0].rgb;
#if defined(SSAO_PBR)
    // Negative: the light is linear and the picture holds it encoded.
    vec3 ssaoStored = ssaoOccludableWeights.z > 0.5 ? ssaoColor : -ssaoLit;
    vec3 ssaoPart = ssaoOccludableWeights.z > 0.5 ? ssaoColor : ssaoOccludable;
#else
    // What textures did to the colour they did to its parts.
    vec3 ssaoTexture = ssaoColor / max(ssaoLit, vec3(1.0e-20));
    vec3 ssaoStored = max(ssaoColor, vec3(0.0));
    vec3 ssaoPart = ssaoOccludableWeights.z > 0.5
      ? ssaoStored
      : max(ssaoOccludable * ssaoTexture, vec3(0.0));
#endif
#if defined(SSAO_EDGES)
    ssaoPart = ssaoOccludableWeights.z > 0.5
      ? max(ssaoColor - SSAO_EDGES * ssaoTexture, vec3(0.0))
      : ssaoPart;
#elif defined(SSAO_EDGE_MIX)
    ssaoPart *= 1.0 - SSAO_EDGE_MIX;
#endif
    // Of these vectors the directions matter, not the lengths.
    vec3 ssaoViewer = vec3(-ssaoPerspective * vertexVC.xy, ssaoPerspective * -vertexVC.z + 1.0 - ssaoPerspective);
    vec3 ssaoNormal = normalVCVSOutput;
#if defined(SSAO_IMPOSTOR)
    vec3 ssaoFacet = ssaoNormal;
#else
    vec3 ssaoFacet = dot(abs(ssaoFacetVC), vec3(1.0)) > 0.0 ? ssaoFacetVC : ssaoNormal;
#endif
    ssaoFacet = dot(ssaoFacet, ssaoViewer) < 0.0 ? -ssaoFacet : ssaoFacet;
#if defined(SSAO_FLAT)
    ssaoNormal = ssaoFacet; // VTK's is of positions that lose digits far from the camera
#endif
    ssaoNormal = dot(ssaoNormal, ssaoNormal) > 0.25 ? ssaoNormal : ssaoFacet;
    // A normal that looks away from the viewer and from the facet belongs to a face wound the other
    // way. The facet alone is not trusted: on slivers below a pixel its derivatives are noise.
    ssaoNormal =
      dot(ssaoNormal, ssaoViewer) < 0.0 && dot(ssaoNormal, ssaoFacet) < 0.0 ? -ssaoNormal : ssaoNormal;
    ssaoFacet = dot(ssaoNormal, ssaoFacet) < 0.0 ? ssaoNormal : ssaoFacet;
    gl_FragData[1] = vec4(ssaoDepth, ssaoPackNormal(ssaoNormal),
      ssaoPackFacet(ssaoFacet, ssaoFacing), ssaoAlpha < SSAO_OPAQUE ? 0.0 : 1.0);
    gl_FragData[2] = vec4(ssaoPart, ssaoAlpha);
    gl_FragData[3] = vec4(ssaoStored, ssaoAlpha);
  }
#else
  // Nothing ambient to occlude: no depth, no occludable light.
  gl_FragData[1] = vec4(0.0, 0.0, 0.0, gl_FragData[0].a < SSAO_OPAQUE ? 0.0 : 1.0);
  gl_FragData[2] = vec4(0.0, 0.0, 0.0, gl_FragData[0].a);
  gl_FragData[3] = gl_FragData[0];
#endif
