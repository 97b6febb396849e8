// Vertex shader of one triangle that covers the viewport. It reads only gl_VertexID.
void main()
{
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
