#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_DOCUMENT_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_DOCUMENT_H

#include "Core/assembly/Assembly.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine
{

/** Bytes that somebody else holds. */
struct ByteView
{
  const std::uint8_t* Data = nullptr;
  std::size_t Size = 0;
};

/** A URI whose file is missing or unreadable, or whose data is damaged. */
class UriError : public AssemblyError
{
public:
  using AssemblyError::AssemblyError;
};

/**
 * A glTF 2.0 file (.gltf or .glb) with the buffers that it names. All references between its objects, and all ranges of
 * its views of buffers, were checked, so they may be followed without a further check.
 */
class GltfDocument
{
public:
  using Json = nlohmann::json;

  /**
   * Reads a file. Files that it names are read if they are in its folder or in folders there.
   * @param largest  largest size in bytes of the file and those that it names, in all
   * @throws         AssemblyError
   */
  explicit GltfDocument(
    const std::filesystem::path& file, std::size_t largest = std::size_t(4) << 30);
  GltfDocument(const GltfDocument&) = delete;
  void operator=(const GltfDocument&) = delete;

  const Json& Root() const { return this->Text; }

  /** Returns the objects of a kind, such as "meshes". */
  const Json& Objects(const char* kind) const;

  /** Returns an object of a kind by its number, which is known to be there. */
  const Json& Object(const char* kind, std::size_t index) const
  {
    return this->Objects(kind)[index];
  }

  /** Returns the bytes of a buffer. They are none where a buffer only stands in for compressed data. */
  ByteView Buffer(std::size_t index) const;

  /** Returns the bytes of a view of a buffer, which are decompressed if they were compressed. */
  ByteView View(std::size_t index) const;

  /**
   * Returns the bytes that an URI stands for: a file beside this one, or data within the URI.
   * @throws  UriError, or AssemblyError if the URI leads out of the folder or to too many bytes
   */
  std::vector<std::uint8_t> ReadUri(const std::string& uri) const;

  /**
   * Counts bytes that are about to be made of the file's data. Small files can claim, or repeat, more than any memory
   * holds. The limit is 256 MB and 256 times the bytes that were read, which is beyond what compression reaches.
   * Several threads may call this.
   * @throws  AssemblyError if all bytes together exceed the limit
   */
  void Spend(std::size_t bytes) const;

private:
  void Parse(const std::filesystem::path& file);
  void ReadBuffers();
  std::vector<std::uint8_t> ReadFile(const std::filesystem::path& file) const;

  std::filesystem::path Folder;
  std::size_t LargestFile;
  mutable std::size_t BytesRead = 0; // of all files
  mutable std::atomic<std::size_t> BytesSpent{ 0 };
  std::vector<std::uint8_t> File;
  Json Text;
  ByteView BinaryChunk;
  bool HasBinaryChunk = false;
  std::vector<std::vector<std::uint8_t>> OwnBuffers; // empty for the binary chunk
  std::vector<std::vector<std::uint8_t>>
    Decompressed; // by view; empty where that is not compressed
};

/** Returns a member that is an array or an object, or an empty array. */
const GltfDocument::Json& Member(const GltfDocument::Json& json, const char* key);

/** Returns an extension of an object, or null if it has none of that name. */
const GltfDocument::Json* Extension(const GltfDocument::Json& json, const char* name);

/** Returns a number that is not negative, such as a count or an index, or a preset if there is none. */
std::size_t Number(const GltfDocument::Json& json, const char* key, std::size_t preset);

/** Returns text of a file as it may stand in one line: no control characters, and not longer than 1000 bytes. */
std::string OneLine(const std::string& text);

/** Returns a value as it may stand in a message: a short text in ASCII. */
std::string Shown(const GltfDocument::Json& json);

/** Returns the name of an object in one line, or nothing. */
std::string NameOf(const GltfDocument::Json& json);

}

#endif
