/**
 * Whether the accessors of a glTF document stay within their buffers.
 */
#ifndef VITRINE_GLTF_ACCESSORS_H
#define VITRINE_GLTF_ACCESSORS_H

#include "scene/files/GltfDocument.h"

#include <cstdint>

namespace program
{

enum GltfComponent
{
  GLTF_BYTE = 5120,
  GLTF_UNSIGNED_BYTE = 5121,
  GLTF_SHORT = 5122,
  GLTF_UNSIGNED_SHORT = 5123,
  GLTF_UNSIGNED_INT = 5125,
  GLTF_FLOAT = 5126
};

/** An accessor; everything that was left out has the value that glTF says it has then. */
struct GltfAccessor
{
  std::size_t Count = 0;
  int Component = 0; ///< a GltfComponent
  std::string Type;  ///< "SCALAR", "VEC3", ...
  bool IsNormalized = false;
  bool IsSparse = false;
};

/** The accessor of that number. Throws nlohmann::json::exception if it is not as it should be. */
GltfAccessor DescribeGltfAccessor(const GltfDocument& document, std::size_t accessor);

/** Throw InputError unless buffer views lie in their buffers and accessors in their views. */
void CheckGltfAccessors(const GltfDocument& document);

/** The largest index in an accessor of unsigned integers that has been checked. */
std::uint32_t LargestGltfIndex(const GltfDocument& document, std::size_t accessor);

/** The bytes of a buffer view that has been checked. */
std::string GltfViewBytes(const GltfDocument& document, std::size_t bufferView);

}
#endif
