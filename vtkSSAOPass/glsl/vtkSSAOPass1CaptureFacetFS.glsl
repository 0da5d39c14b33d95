  // Stage 1, in uniform flow: the facet's own normal, before anything is discarded.
  vec3 ssaoFacetVC = cross(dFdx(vertexVC.xyz), dFdy(vertexVC.xyz));
