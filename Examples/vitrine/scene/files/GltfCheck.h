/**
 * Whether a glTF document can be given to VTK's importer, which looks at nothing of this itself.
 */
#ifndef VITRINE_GLTF_CHECK_H
#define VITRINE_GLTF_CHECK_H

#include "scene/files/GltfDocument.h"

namespace program
{

/** Throw InputError unless the document is sound from its buffers to its scenes. */
void CheckGltf(const GltfDocument& document);

}
#endif
