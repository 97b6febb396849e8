// The block of a primitive, as a flat index: declarations for the geometry shaders of VTK's mappers. It reads the
// varying of the vertex shader and yields that of the fragment shader. Vertices of a primitive have the same block.
flat in float vitrineBlock[];
flat out float vitrineBlockOfPrimitive;
