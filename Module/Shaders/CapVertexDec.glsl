// Declarations for the vertex shader of a cap: the coordinates of its points in its plane.
uniform vec4 vitrineCapAxes[2]; // in the coordinates of vertexMC
out vec2 vitrineCapPoint;
