// Stage 1, put before main() of a mapper's fragment shader.
uniform vec3 ssaoOccludableWeights; // of the ambient, the diffuse and the whole colour
uniform vec4 ssaoDepthOfWindowRows; // rows 2 and 3 of the projection, see ssaoDepthOfWindow
uniform float ssaoPerspective;      // 1: perspective, 0: parallel projection
