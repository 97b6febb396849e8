#ifndef VITRINE_CORE_ASSEMBLY_GLTF_MESHOPT_VIEWS_H
#define VITRINE_CORE_ASSEMBLY_GLTF_MESHOPT_VIEWS_H

#include "Core/assembly/gltf/GltfDocument.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Decompresses the views of buffers that are compressed (EXT_meshopt_compression), in parallel.
 * @return  bytes by number of the view, empty where that is not compressed; nothing if no view is
 * @throws  AssemblyError if the data of a view is damaged
 */
std::vector<std::vector<std::uint8_t>> DecompressMeshoptViews(const GltfDocument& document);

}

#endif
