#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_READER_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_READER_H

#include "Core/assembly/Assembly.h"

#include <filesystem>

namespace vitrine
{

/**
 * Reads a file of glTF 2.0 (.gltf or .glb). Meshes are read in parallel. Skins and morph targets are shown at rest.
 * Compressed data is read too: EXT_meshopt_compression, KHR_draco_mesh_compression, KHR_mesh_quantization.
 * @param scene  number of the scene that is read; the one that the file names if NO_INDEX
 * @throws       AssemblyError if the file is damaged, is too large, or requires what is not known
 */
Assembly ReadGltf(const std::filesystem::path& file, int scene = NO_INDEX);

}

#endif
