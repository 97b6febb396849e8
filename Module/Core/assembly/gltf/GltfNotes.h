#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_NOTES_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_NOTES_H

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/GltfDocument.h"
#include "Core/assembly/gltf/GltfNodes.h"

namespace vitrine
{

/**
 * Notes in an assembly what is shown otherwise than the file says, once each: extensions of the nodes, meshes,
 * materials and textures that the scene uses, and animations.
 */
void NoteWhatIsNotShown(const GltfDocument& document, const GltfScene& scene, Assembly& assembly);

}

#endif
