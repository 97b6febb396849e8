#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MATERIALS_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MATERIALS_H

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/GltfDocument.h"

namespace vitrine
{

/**
 * Reads materials, textures, and the encoded images that materials use, into an assembly. Missing images are noted.
 * @throws  AssemblyError if a factor is no number or an image is outside of the folder
 */
void ReadGltfMaterials(const GltfDocument& document, Assembly& assembly);

}

#endif
