// What stages 2 and 3 know of the view; the parameters of ssaoPositionVC and ssaoPixelOf.
uniform sampler2D geometry; // (depth, packed normal, packed facet normal, 1); depth 0: no surface
uniform vec2 texelSize;     // 1 / size of the geometry texture
uniform vec4 viewport;      // x, y, width, height in pixels
uniform vec4 drawn;         // the part of it with surfaces, in the same way
uniform vec4 pixelToRay;
uniform vec4 rayToPixel;
uniform vec4 rayOffset;
uniform vec2 depthSlope;
uniform vec4 depthOfWindow; // see ssaoDepthOfWindow
uniform float perspective;

// The captured surface at a position in pixels, nearest texel.
vec4 ssaoGeometryAt(vec2 pixel)
{
  return textureLod(geometry, pixel * texelSize, 0.0);
}
