#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MATERIALS_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_MATERIALS_H

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/GltfDocument.h"

namespace vitrine
{

/**
 * Reads materials, textures and encoded images into an assembly.
 * @throws  AssemblyError if an image is missing or a factor is no number
 */
void ReadGltfMaterials(const GltfDocument& document, Assembly& assembly);

}

#endif
