// The block that a vertex belongs to, as a flat index: declarations for the vertex shaders of mappers that merge the
// blocks of composite data into one buffer (scene/PartShader). It reads the attribute and yields the varying.
in float vitrineBlockOfVertex;
flat out float vitrineBlock;
