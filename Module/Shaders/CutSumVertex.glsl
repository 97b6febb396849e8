// Vertex shader of the sums of cut parts. `vitrineBeyond` is greater than 0 beyond the plane along the ray.
in vec3 vertexPosition;
in uint vertexSlot;
uniform mat4 vitrineToClip;
uniform vec4 vitrinePlane;
out float vitrineBeyond;
flat out uint vitrineSlot;

void main()
{
  gl_Position = vitrineToClip * vec4(vertexPosition, 1.0);
  vitrineBeyond = dot(vitrinePlane, vec4(vertexPosition, 1.0));
  vitrineSlot = vertexSlot;
}
