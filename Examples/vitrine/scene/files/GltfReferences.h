/**
 * Whether the objects of a glTF document refer to objects that are there.
 */
#ifndef VITRINE_GLTF_REFERENCES_H
#define VITRINE_GLTF_REFERENCES_H

#include "scene/files/GltfDocument.h"

namespace program
{

/**
 * Throw InputError for an index, anywhere in the document, beyond the array that it points into.
 */
void CheckGltfReferences(const GltfDocument& document);

}
#endif
