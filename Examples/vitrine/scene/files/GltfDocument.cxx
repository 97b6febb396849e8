#include "scene/files/GltfDocument.h"

#include "Errors.h"
#include "scene/files/FileBytes.h"

#include "vtkBase64Utilities.h"

#include <array>
#include <filesystem>

namespace program
{

namespace
{
using Json = nlohmann::json;

const std::size_t GlbHeaderBytes = 12;
const std::size_t ChunkHeaderBytes = 8;
const std::uint32_t JsonChunk = 0x4e4f534a;
const std::uint32_t BinaryChunk = 0x004e4942;

/** Extensions without which the picture is right all the same, or which VTK's importer knows. */
const std::array<const char*, 2> KnownExtensions = { "KHR_lights_punctual", "KHR_materials_unlit" };

struct GlbChunks
{
  std::string Json;
  std::string Binary;
  bool HasBinary = false;
};

[[noreturn]] void FailLength(const std::string& path, std::size_t stated, std::size_t actual)
{
  throw InputError(path,
    "is truncated or damaged: it states " + std::to_string(stated) + " bytes and has " +
      std::to_string(actual));
}

GlbChunks SplitGlb(const std::string& path, const std::string& bytes)
{
  if (bytes.size() < GlbHeaderBytes || bytes.compare(0, 4, "glTF") != 0)
  {
    throw InputError(path, "is no GLB file");
  }
  if (ReadUInt32(bytes, 4) != 2)
  {
    throw InputError(path,
      "is of version " + std::to_string(ReadUInt32(bytes, 4)) + " of glTF; only 2 can be read");
  }
  if (ReadUInt32(bytes, 8) != bytes.size())
  {
    FailLength(path, ReadUInt32(bytes, 8), bytes.size());
  }
  GlbChunks chunks;
  for (std::size_t begin = GlbHeaderBytes; begin < bytes.size();)
  {
    const std::size_t left = bytes.size() - begin;
    if (left < ChunkHeaderBytes || left - ChunkHeaderBytes < ReadUInt32(bytes, begin))
    {
      throw InputError(path, "is damaged: a chunk is longer than the file");
    }
    const std::size_t length = ReadUInt32(bytes, begin);
    const std::uint32_t type = ReadUInt32(bytes, begin + 4);
    const std::string content = bytes.substr(begin + ChunkHeaderBytes, length);
    if (begin == GlbHeaderBytes && type == JsonChunk)
    {
      chunks.Json = content;
    }
    else if (type == BinaryChunk && !chunks.HasBinary)
    {
      chunks.Binary = content;
      chunks.HasBinary = true;
    }
    begin += ChunkHeaderBytes + length;
  }
  return chunks;
}

Json ParseJson(const std::string& path, const std::string& text)
{
  Json json = Json::parse(text, nullptr, /* allow_exceptions= */ false);
  if (!json.is_object())
  {
    throw InputError(path, "is no glTF file: its JSON is damaged or not there");
  }
  return json;
}

void CheckExtensions(const std::string& path, const Json& json)
{
  for (const Json& extension : json.value("extensionsRequired", Json::array()))
  {
    const std::string name = extension.get<std::string>();
    if (std::find(KnownExtensions.begin(), KnownExtensions.end(), name) == KnownExtensions.end())
    {
      throw InputError(path, "requires the extension " + name + ", which VTK cannot read");
    }
  }
}

std::string DecodeBase64(const GltfDocument& document, const std::string& text)
{
  std::string bytes(3 * (text.size() / 4 + 1), '\0');
  const std::size_t length =
    vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(text.data()),
      text.size(), reinterpret_cast<unsigned char*>(bytes.data()), bytes.size());
  if (length == 0)
  {
    throw InputError(document.Path, "is damaged: a data URI holds no base64");
  }
  bytes.resize(length);
  return bytes;
}

void ReadBuffers(GltfDocument& document, const GlbChunks& chunks)
{
  const Json descriptions = document.Json.value("buffers", Json::array());
  for (std::size_t i = 0; i < descriptions.size(); ++i)
  {
    const Json& description = descriptions[i];
    const std::size_t length = description.at("byteLength").get<std::size_t>();
    const bool isChunk = i == 0 && chunks.HasBinary && !description.contains("uri");
    std::string bytes =
      isChunk ? chunks.Binary : ReadGltfUri(document, description.at("uri").get<std::string>());
    if (bytes.size() < length)
    {
      throw InputError(document.Path,
        "is truncated: buffer " + std::to_string(i) + " should have " + std::to_string(length) +
          " bytes and has " + std::to_string(bytes.size()));
    }
    bytes.resize(length);
    document.Buffers.push_back(std::move(bytes));
  }
  if (chunks.HasBinary && descriptions.size() > 1)
  {
    throw InputError(
      document.Path, "has buffers beside its binary chunk, which VTK's importer mixes up");
  }
}
}

GltfDocument ReadGltfDocument(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  GltfDocument document;
  document.Path = path;
  GlbChunks chunks;
  if (std::filesystem::path(path).extension() == ".glb")
  {
    chunks = SplitGlb(path, bytes);
  }
  else
  {
    chunks.Json = bytes;
  }
  document.Json = ParseJson(path, chunks.Json);
  CheckExtensions(path, document.Json);
  ReadBuffers(document, chunks);
  return document;
}

std::string ReadGltfUri(const GltfDocument& document, const std::string& uri)
{
  if (uri.compare(0, 5, "data:") == 0)
  {
    return DecodeBase64(document, uri.substr(uri.find(',') + 1));
  }
  const std::filesystem::path file = std::filesystem::path(document.Path).parent_path() / uri;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    throw InputError(document.Path, "needs the file " + file.string() + ", which is not there");
  }
  return ReadBytes(file.string());
}

}
