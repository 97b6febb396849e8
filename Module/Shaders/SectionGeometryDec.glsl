// Declarations for the geometry shaders of VTK's mappers: distances from the planes of a section. The vertex shader
// yields the vertex.
uniform vec4 vitrineSectionPlanes[VITRINE_SECTION_PLANES]; // in the coordinates of vertexMC
in vec4 vitrineSectionVertex[];
out vec4 vitrineSectionDistances[(VITRINE_SECTION_PLANES + 3) / 4]; // four planes take a varying
