#ifndef VITRINE_CORE_ASSEMBLY_GLTF_DRACO_PRIMITIVE_H
#define VITRINE_CORE_ASSEMBLY_GLTF_DRACO_PRIMITIVE_H

#include "Core/assembly/gltf/GltfDocument.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace vitrine
{

/** What the compressed data of a primitive holds. */
struct DracoPrimitive
{
  std::vector<std::uint32_t> Indices; ///< three to a triangle
  /** Packed elements of the accessors, by their names. */
  std::map<std::string, std::vector<std::uint8_t>> Attributes;
};

/**
 * Decompresses a primitive (KHR_draco_mesh_compression) into the types that its accessors state.
 * @throws  AssemblyError if the data is damaged, or has other vertices than the accessors state
 */
DracoPrimitive DecompressDracoPrimitive(
  const GltfDocument& document, const GltfDocument::Json& primitive);

}

#endif
