// Reads glTF files that are made up. Whatever they hold, an error is an AssemblyError, and what is read can be used.
// An input is the JSON of a GLB, a zero and its buffer, so that changes leave the chunks whole. Other inputs are files
// as they are: those that begin with "glTF". `FuzzGltf -rss_limit_mb=2048 -max_len=65536 FOLDER`

#include "FuzzBytes.h"

#include "Core/assembly/gltf/GltfReader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace
{

using namespace vitrine;

/** A file of this process, which is overwritten for each input and removed at the end. */
class ScratchFile
{
public:
  ScratchFile()
    : Folder(std::filesystem::temp_directory_path() / ("fuzz-gltf-" + std::to_string(getpid())))
  {
    std::filesystem::create_directory(this->Folder);
  }
  ~ScratchFile()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Folder, error);
  }

  std::filesystem::path Write(const std::string& content) const
  {
    const std::filesystem::path path = this->Folder / "a.glb";
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

private:
  std::filesystem::path Folder;
};

std::string Word(std::size_t word)
{
  std::string bytes;
  for (int i = 0; i < 4; ++i)
  {
    bytes += static_cast<char>(word >> 8 * i & 0xff);
  }
  return bytes;
}

std::string FileOf(const std::string& input)
{
  if (input.compare(0, 4, "glTF") == 0)
  {
    return input;
  }
  const std::size_t end = std::min(input.find('\0'), input.size());
  const std::string binary = input.substr(std::min(end + 1, input.size()));
  const std::string chunks = Word(end) + "JSON" + input.substr(0, end) + Word(binary.size()) +
    std::string("BIN\0", 4) + binary;
  return "glTF" + Word(2) + Word(12 + chunks.size()) + chunks;
}

void Check(const AssemblyGeometry& geometry, std::size_t materials)
{
  const std::size_t vertices = geometry.Positions.size();
  Require(geometry.Material >= NO_INDEX && geometry.Material < static_cast<int>(materials),
    "a material that is not there");
  Require(
    geometry.Indices.size() % static_cast<std::size_t>(geometry.Kind) == 0, "a part of a cell");
  Require(std::all_of(geometry.Indices.begin(), geometry.Indices.end(),
            [vertices](std::uint32_t i) { return i < vertices; }),
    "a vertex that is not there");
  for (const std::size_t size : { geometry.Normals.size(), geometry.Tangents.size(),
         geometry.Colors.size(), geometry.TexCoords[0].size(), geometry.TexCoords[1].size() })
  {
    Require(size == 0 || size == vertices, "arrays of different lengths");
  }
}

void Check(const Assembly& assembly)
{
  for (const AssemblyMesh& mesh : assembly.Meshes)
  {
    for (const AssemblyGeometry& geometry : mesh.Geometries)
    {
      Check(geometry, assembly.Materials.size());
    }
  }
  for (const AssemblyNode& node : assembly.Nodes)
  {
    Require(node.Mesh >= NO_INDEX && node.Mesh < static_cast<int>(assembly.Meshes.size()),
      "a mesh that is not there");
  }
  for (const AssemblyTexture& texture : assembly.Textures)
  {
    Require(texture.Image >= NO_INDEX && texture.Image < static_cast<int>(assembly.Images.size()),
      "an image that is not there");
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const ScratchFile file;
  try
  {
    Check(ReadGltf(file.Write(FileOf({ data, data + size }))));
  }
  catch (const AssemblyError& error)
  {
    const std::string message = error.what();
    Require(
      !message.empty() && message.find('\n') == std::string::npos, "a message of several lines");
  }
  return 0;
}
