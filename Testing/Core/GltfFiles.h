#ifndef VITRINE_TESTING_GLTF_FILES_H
#define VITRINE_TESTING_GLTF_FILES_H

#include "Core/assembly/gltf/GltfReader.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

/** Makes small glTF files, and reads them. */
namespace gltf_files
{

using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

enum Component
{
  Byte = 5120,
  UnsignedByte = 5121,
  Short = 5122,
  UnsignedShort = 5123,
  UnsignedInt = 5125,
  Float = 5126
};

/** A folder that is there while this is. */
class Folder
{
public:
  Folder()
  {
    static std::atomic<int> number{ 0 };
    this->Path = std::filesystem::path(testing::TempDir()) /
      ("gltf-" + std::to_string(std::random_device()()) + "-" + std::to_string(number++));
    std::filesystem::create_directory(this->Path);
  }
  ~Folder() { std::filesystem::remove_all(this->Path); }
  Folder(const Folder&) = delete;
  void operator=(const Folder&) = delete;

  std::filesystem::path Write(const std::string& name, const std::string& content) const
  {
    std::ofstream(this->Path / name, std::ios::binary) << content;
    return this->Path / name;
  }

  std::filesystem::path Path;
};

template <class T>
Bytes BytesOf(const std::vector<T>& values)
{
  Bytes bytes(values.size() * sizeof(T));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

inline std::string Word(std::uint32_t word)
{
  std::string bytes;
  for (int i = 0; i < 4; ++i)
  {
    bytes += static_cast<char>(word >> 8 * i & 0xff);
  }
  return bytes;
}

inline std::string Chunk(const std::string& type, const std::string& content)
{
  return Word(static_cast<std::uint32_t>(content.size())) + type + content;
}

inline std::string Glb(const std::string& chunks)
{
  return "glTF" + Word(2) + Word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

/** A file in the making. Its JSON may be changed at will before it is written. */
struct Gltf
{
  Json Root = { { "asset", { { "version", "2.0" } } } };
  Bytes Binary;

  /** Adds an item to an array at the top. Returns its number. */
  int Add(const char* kind, const Json& item)
  {
    this->Root[kind].push_back(item);
    return static_cast<int>(this->Root[kind].size()) - 1;
  }

  int AddView(const Bytes& bytes, const Json& more = Json::object())
  {
    Json view = { { "buffer", 0 }, { "byteOffset", this->Binary.size() },
      { "byteLength", bytes.size() } };
    view.update(more);
    this->Binary.insert(this->Binary.end(), bytes.begin(), bytes.end());
    this->Binary.resize((this->Binary.size() + 3) / 4 * 4);
    return this->Add("bufferViews", view);
  }

  template <class T>
  int AddAccessor(const char* type, int component, std::size_t count, const std::vector<T>& values,
    const Json& more = Json::object())
  {
    Json accessor = { { "bufferView", this->AddView(BytesOf(values)) }, { "type", type },
      { "componentType", component }, { "count", count } };
    accessor.update(more);
    return this->Add("accessors", accessor);
  }

  /** The triangle of (0, 0, 0), (1, 0, 0) and (0, 1, 0). */
  Json Triangle()
  {
    const std::vector<float> corners = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    return { { "attributes", { { "POSITION", this->AddAccessor("VEC3", Float, 3, corners) } } } };
  }

  int AddMesh(const Json& primitive)
  {
    return this->Add("meshes", { { "primitives", { primitive } } });
  }

  int AddNode(const Json& node) { return this->Add("nodes", node); }

  /** Returns the file as GLB. The buffer is named as its chunk has it, unless there is one already. */
  std::string Content() const
  {
    Json root = this->Root;
    if (!root.contains("buffers") && !this->Binary.empty())
    {
      root["buffers"] = { { { "byteLength", this->Binary.size() } } };
    }
    std::string text = root.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return Glb(Chunk("JSON", text) +
      Chunk(std::string("BIN\0", 4), { this->Binary.begin(), this->Binary.end() }));
  }
};

/** A triangle in a node. */
inline Gltf OneTriangle()
{
  Gltf gltf;
  gltf.AddNode({ { "mesh", gltf.AddMesh(gltf.Triangle()) } });
  return gltf;
}

inline vitrine::Assembly Read(const std::string& content, int scene = vitrine::NO_INDEX)
{
  const Folder folder;
  return vitrine::ReadGltf(folder.Write("a.gltf", content), scene);
}

inline vitrine::Assembly Read(const Gltf& gltf, int scene = vitrine::NO_INDEX)
{
  return Read(gltf.Content(), scene);
}

}

#endif
