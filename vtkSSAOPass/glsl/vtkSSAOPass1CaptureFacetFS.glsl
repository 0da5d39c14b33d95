  // Stage 1, in uniform flow: the facet's own normal, before anything is discarded.
  vec3 ssaoMeshVC = vec3(vertexVC.xy, -SSAO_MESH_RELATIVE_DEPTH);
  vec3 ssaoFacetVC = cross(dFdx(ssaoMeshVC), dFdy(ssaoMeshVC));
