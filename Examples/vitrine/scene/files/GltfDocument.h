/**
 * A glTF document and the bytes that belong to it.
 *
 * Khronos Group: glTF 2.0 Specification, 2021.
 */
#ifndef VITRINE_GLTF_DOCUMENT_H
#define VITRINE_GLTF_DOCUMENT_H

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace program
{

struct GltfDocument
{
  std::string Path;
  nlohmann::json Json;
  std::vector<std::string> Buffers; ///< as long as the document says, each
};

/**
 * Read a .glb or .gltf file with its buffers. Throws InputError if lengths do not match, a buffer
 * is not there, or an extension is required that VTK's importer does not know.
 */
GltfDocument ReadGltfDocument(const std::string& path);

/** The bytes of a URI: base64 in itself, or a file beside the document. */
std::string ReadGltfUri(const GltfDocument& document, const std::string& uri);

}
#endif
