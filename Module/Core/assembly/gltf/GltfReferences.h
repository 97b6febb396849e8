#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_REFERENCES_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_REFERENCES_H

#include "Core/assembly/gltf/GltfDocument.h"

namespace vitrine
{

/**
 * Checks that each number by which an object of a glTF refers to another is the number of one that is there.
 * @throws  AssemblyError that names the first that is not
 */
void CheckGltfReferences(const GltfDocument::Json& root);

/**
 * Checks that each view of a buffer, compressed or not, lies within its buffer.
 * @throws  AssemblyError
 */
void CheckGltfViews(const GltfDocument& document);

}

#endif
