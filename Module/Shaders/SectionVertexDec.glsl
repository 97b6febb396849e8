// Declarations for the vertex shaders of VTK's mappers: distances from the planes of a section.
//
// VITRINE_SECTION_PLANES n  the number of planes
uniform vec4 vitrineSectionPlanes[VITRINE_SECTION_PLANES]; // in the coordinates of vertexMC
out vec4 vitrineSectionDistances[(VITRINE_SECTION_PLANES + 3) / 4]; // four planes take a varying
