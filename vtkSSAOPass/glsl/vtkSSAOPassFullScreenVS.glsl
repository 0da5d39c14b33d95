//VTK::System::Dec

// One quad over the viewport. vtkOpenGLQuadHelper insists that both of its attributes are used, so
// each gives one coordinate.

in vec4 ndCoordIn;  // -1 .. 1
in vec2 texCoordIn; // 0 .. 1

void main()
{
  gl_Position = vec4(ndCoordIn.x, texCoordIn.y * 2.0 - 1.0, 0.0, 1.0);
}
