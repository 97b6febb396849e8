// Vertex shader of one triangle that covers the part of the viewport on one side of a vertical edge. It reads
// gl_VertexID.
uniform float edge;
uniform float side; // 1 for the part left of x = edge (NDC), -1 for its mirror image
void main()
{
  vec2 corner = gl_VertexID == 0 ? vec2(edge, -9.0) : gl_VertexID == 1 ? vec2(edge, 9.0) : vec2(-9.0, 0.0);
  gl_Position = vec4(side * corner.x, corner.y, 0.0, 1.0);
}
