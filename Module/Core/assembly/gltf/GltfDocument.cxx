#include "Core/assembly/gltf/GltfDocument.h"

#include "Core/assembly/gltf/GltfReferences.h"
#include "Core/assembly/gltf/MeshoptViews.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

namespace vitrine
{

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Json = GltfDocument::Json;

constexpr std::size_t MOST_LEVELS = 500; // of lists and objects of JSON in others
constexpr std::size_t GLB_HEADER_BYTES = 12;
constexpr std::size_t CHUNK_HEADER_BYTES = 8;
constexpr std::uint32_t GLB_MAGIC = 0x46546c67;
constexpr std::uint32_t JSON_CHUNK = 0x4e4f534a;
constexpr std::uint32_t BINARY_CHUNK = 0x004e4942;
constexpr std::size_t LONGEST_LINE = 1000; // bytes
constexpr std::size_t LONGEST_VALUE = 100; // characters
constexpr std::size_t MOST_BYTES_OF_A_BYTE = 256;
constexpr std::size_t LEAST_LIMIT = std::size_t(256) << 20; // bytes

/** Extensions that files may require. What else is required is refused. */
constexpr std::array<const char*, 19> KNOWN_EXTENSIONS = { "EXT_mesh_gpu_instancing",
  "EXT_meshopt_compression", "KHR_draco_mesh_compression", "KHR_lights_punctual",
  "KHR_materials_anisotropy", "KHR_materials_clearcoat", "KHR_materials_dispersion",
  "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_iridescence",
  "KHR_materials_pbrSpecularGlossiness", "KHR_materials_sheen", "KHR_materials_specular",
  "KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_variants",
  "KHR_materials_volume", "KHR_mesh_quantization", "KHR_texture_transform" };

std::uint32_t Word(const Bytes& bytes, std::size_t offset)
{
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;)
  {
    word = word << 8 | bytes[offset + i];
  }
  return word;
}

bool IsBinary(const Bytes& bytes)
{
  return bytes.size() >= 4 && Word(bytes, 0) == GLB_MAGIC;
}

void CheckBinaryHeader(const Bytes& bytes)
{
  if (bytes.size() < GLB_HEADER_BYTES)
  {
    throw AssemblyError("is truncated: it ends within its header");
  }
  if (Word(bytes, 4) != 2)
  {
    throw AssemblyError(
      "is of version " + std::to_string(Word(bytes, 4)) + " of glTF; only 2 can be read");
  }
  if (Word(bytes, 8) != bytes.size())
  {
    throw AssemblyError("is truncated or damaged: it states " + std::to_string(Word(bytes, 8)) +
      " bytes and has " + std::to_string(bytes.size()));
  }
}

struct Chunk
{
  std::uint32_t Type;
  ByteView Content;
};

std::vector<Chunk> DivideBinary(const Bytes& bytes)
{
  CheckBinaryHeader(bytes);
  std::vector<Chunk> chunks;
  for (std::size_t begin = GLB_HEADER_BYTES; begin < bytes.size();)
  {
    const std::size_t left = bytes.size() - begin;
    if (left < CHUNK_HEADER_BYTES || left - CHUNK_HEADER_BYTES < Word(bytes, begin))
    {
      throw AssemblyError("is damaged: a chunk is longer than the file");
    }
    const std::size_t length = Word(bytes, begin);
    chunks.push_back(
      { Word(bytes, begin + 4), { bytes.data() + begin + CHUNK_HEADER_BYTES, length } });
    begin += CHUNK_HEADER_BYTES + length;
  }
  return chunks;
}

/** What goes through JSON calls itself for each level of it. */
void CheckDepth(const ByteView& text)
{
  std::size_t depth = 0;
  bool isString = false;
  for (std::size_t i = 0; i < text.Size; ++i)
  {
    const auto letter = static_cast<char>(text.Data[i]);
    if (isString)
    {
      isString = letter != '"';
      i += letter == '\\' ? 1 : 0; // What it escapes may be a quote.
    }
    else if (letter == '"')
    {
      isString = true;
    }
    else if (letter == '[' || letter == '{')
    {
      ++depth;
    }
    else if ((letter == ']' || letter == '}') && depth > 0)
    {
      --depth;
    }
    if (depth > MOST_LEVELS)
    {
      throw AssemblyError("is damaged: its JSON has more than " + std::to_string(MOST_LEVELS) +
        " levels of lists in lists");
    }
  }
}

void CheckRequiredExtensions(const Json& json)
{
  for (const Json& extension : Member(json, "extensionsRequired"))
  {
    const std::string name = extension.get<std::string>();
    const auto* const found = std::find(KNOWN_EXTENSIONS.begin(), KNOWN_EXTENSIONS.end(), name);
    if (found == KNOWN_EXTENSIONS.end())
    {
      const bool isKtx = name == "KHR_texture_basisu";
      throw AssemblyError("requires the extension " + OneLine(name) +
        (isKtx ? ": textures in KTX2 are not read; convert them to PNG" : ", which is not read"));
    }
  }
}

void CheckVersion(const Json& json)
{
  const Json& asset = Member(json, "asset");
  const std::string version = asset.is_object() ? asset.value("version", "") : "";
  if (version.substr(0, 2) != "2.")
  {
    throw AssemblyError(
      "is of version '" + OneLine(version.substr(0, 20)) + "' of glTF; only 2 can be read");
  }
}

/** Returns the value of each digit by its character, and -1 for what is none. */
std::array<std::int8_t, 256> Base64Digits()
{
  static constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::int8_t, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
  {
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
  }
  return values;
}

Bytes DecodeBase64(std::string_view text)
{
  static const std::array<std::int8_t, 256> digits = Base64Digits();
  while (!text.empty() && text.back() == '=')
  {
    text.remove_suffix(1);
  }
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text)
  {
    const int digit = digits[static_cast<unsigned char>(c)];
    if (digit < 0)
    {
      throw UriError("is damaged: a data URI holds no base64");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
  }
  return bytes;
}

/** Puts bytes in place of their percent codes (RFC 3986, 2.1). */
std::string DecodePercent(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const auto isDigit = [&uri](std::size_t place)
    { return place < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[place])) != 0; };
    if (uri[i] == '%' && isDigit(i + 1) && isDigit(i + 2))
    {
      text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    }
    else
    {
      text += uri[i];
    }
  }
  return text;
}

/** Whether an URI begins with a scheme, such as "https:" (RFC 3986, 3.1). */
bool HasScheme(const std::string& uri)
{
  const std::size_t end = uri.find_first_of(":/?#");
  return end != std::string::npos && uri[end] == ':';
}

bool IsInside(const std::filesystem::path& folder, const std::filesystem::path& file)
{
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(file, error);
  return !error &&
    std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end()).first == folder.end();
}

std::filesystem::path FolderOf(const std::filesystem::path& file)
{
  std::error_code error;
  return std::filesystem::weakly_canonical(
    file.has_parent_path() ? file.parent_path() : ".", error);
}

/** Some writers fill up the chunk of JSON by zeros instead of spaces. */
ByteView WithoutZerosAtEnd(ByteView text)
{
  while (text.Size > 0 && text.Data[text.Size - 1] == 0)
  {
    --text.Size;
  }
  return text;
}

/** Whether a buffer only stands in for compressed data (EXT_meshopt_compression, "Fallback buffers"). */
bool IsFallback(const Json& buffer)
{
  return !buffer.contains("uri") && Extension(buffer, "EXT_meshopt_compression");
}
}

const Json& Member(const Json& json, const char* key)
{
  static const Json none = Json::array();
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found != json.end() && found->is_structured() ? *found : none;
}

const Json* Extension(const Json& json, const char* name)
{
  const Json& extensions = Member(json, "extensions");
  const auto found = extensions.is_object() ? extensions.find(name) : extensions.end();
  return found != extensions.end() && found->is_object() ? &*found : nullptr;
}

std::size_t Number(const Json& json, const char* key, std::size_t preset)
{
  const auto found = json.find(key);
  if (found == json.end())
  {
    return preset;
  }
  // Sums and products of such numbers stay far below 2^64.
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 0xffffffffu)
  {
    throw AssemblyError(std::string("is damaged: a ") + key + " is " + Shown(*found));
  }
  return found->get<std::size_t>();
}

std::string OneLine(const std::string& text)
{
  std::size_t length = std::min(text.size(), LONGEST_LINE);
  const auto isWithinCharacter = [&text](std::size_t place)
  { return place < text.size() && (static_cast<unsigned char>(text[place]) & 0xc0) == 0x80; };
  while (length > 0 && isWithinCharacter(length))
  {
    --length;
  }
  std::string line = text.substr(0, length);
  std::replace_if(
    line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return line;
}

std::string Shown(const Json& json)
{
  // Arrays may be nested deeper than a recursive writer can follow.
  return json.is_structured()
    ? json.type_name()
    : json.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, LONGEST_VALUE);
}

std::string NameOf(const Json& json)
{
  const auto found = json.find("name");
  return found != json.end() && found->is_string() ? OneLine(found->get_ref<const std::string&>())
                                                   : std::string();
}

GltfDocument::GltfDocument(const std::filesystem::path& file, std::size_t largest)
  : Folder(FolderOf(file))
  , LargestFile(largest)
{
  this->Parse(file);
  CheckVersion(this->Text);
  CheckRequiredExtensions(this->Text);
  CheckGltfReferences(this->Text);
  this->ReadBuffers();
  CheckGltfViews(*this);
  this->Decompressed = DecompressMeshoptViews(*this);
}

const Json& GltfDocument::Objects(const char* kind) const
{
  return Member(this->Text, kind);
}

void GltfDocument::Parse(const std::filesystem::path& file)
{
  this->File = this->ReadFile(file);
  ByteView text{ this->File.data(), this->File.size() };
  if (IsBinary(this->File))
  {
    text = {};
    for (const Chunk& chunk : DivideBinary(this->File))
    {
      if (chunk.Type == JSON_CHUNK && !text.Data)
      {
        text = chunk.Content;
      }
      else if (chunk.Type == BINARY_CHUNK && !this->HasBinaryChunk)
      {
        this->BinaryChunk = chunk.Content;
        this->HasBinaryChunk = true;
      }
    }
  }
  text = WithoutZerosAtEnd(text);
  CheckDepth(text);
  this->Text =
    Json::parse(text.Data, text.Data + text.Size, nullptr, /* allow_exceptions= */ false);
  if (!this->Text.is_object())
  {
    throw AssemblyError("is no glTF file: its JSON is damaged or not there");
  }
}

void GltfDocument::ReadBuffers()
{
  const Json& buffers = this->Objects("buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i)
  {
    const bool isChunk = i == 0 && this->HasBinaryChunk && !buffers[i].contains("uri");
    const bool isEmpty = isChunk || IsFallback(buffers[i]);
    this->OwnBuffers.push_back(
      isEmpty ? Bytes() : this->ReadUri(buffers[i].at("uri").get<std::string>()));
    const std::size_t length = Number(buffers[i], "byteLength", 0);
    const std::size_t has = isChunk ? this->BinaryChunk.Size : this->OwnBuffers.back().size();
    if (!IsFallback(buffers[i]) && has < length)
    {
      throw AssemblyError("is truncated: buffer " + std::to_string(i) + " should have " +
        std::to_string(length) + " bytes and has " + std::to_string(has));
    }
  }
}

ByteView GltfDocument::Buffer(std::size_t index) const
{
  const bool isChunk = index == 0 && this->HasBinaryChunk && this->OwnBuffers[0].empty();
  return isChunk ? this->BinaryChunk
                 : ByteView{ this->OwnBuffers[index].data(), this->OwnBuffers[index].size() };
}

ByteView GltfDocument::View(std::size_t index) const
{
  if (!this->Decompressed.empty() && !this->Decompressed[index].empty())
  {
    return { this->Decompressed[index].data(), this->Decompressed[index].size() };
  }
  const Json& view = this->Object("bufferViews", index);
  const ByteView buffer = this->Buffer(view.at("buffer").get<std::size_t>());
  return { buffer.Data + Number(view, "byteOffset", 0), Number(view, "byteLength", 0) };
}

void GltfDocument::Spend(std::size_t bytes) const
{
  const std::size_t limit = LEAST_LIMIT + MOST_BYTES_OF_A_BYTE * this->BytesRead;
  if (bytes > limit || this->BytesSpent.fetch_add(bytes) > limit - bytes)
  {
    throw AssemblyError(
      "is damaged: what it states would take more than " + std::to_string(limit >> 20) + " MB");
  }
}

Bytes GltfDocument::ReadFile(const std::filesystem::path& file) const
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error)
  {
    throw AssemblyError("cannot be read: " + error.message());
  }
  if (size > this->LargestFile - this->BytesRead)
  {
    throw AssemblyError("has " + std::to_string(this->BytesRead + size) +
      " bytes with what it names; at most " + std::to_string(this->LargestFile) + " are read");
  }
  Bytes bytes(static_cast<std::size_t>(size));
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(
        reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
  {
    throw UriError("cannot be read to its end");
  }
  this->BytesRead += bytes.size();
  return bytes;
}

Bytes GltfDocument::ReadUri(const std::string& uri) const
{
  if (uri.compare(0, 5, "data:") == 0)
  {
    const std::size_t comma = std::min(uri.find(','), uri.size());
    if (uri.rfind(";base64", comma) == std::string::npos || comma == uri.size())
    {
      throw UriError("is damaged: a data URI holds no base64");
    }
    return DecodeBase64(std::string_view(uri).substr(comma + 1));
  }
  const std::string name = DecodePercent(uri);
  if (HasScheme(uri) || name.empty() || OneLine(name) != name)
  {
    throw AssemblyError("names '" + OneLine(name) + "'; only files in its folder are read");
  }
  const std::filesystem::path file = this->Folder / name;
  if (!IsInside(this->Folder, file))
  {
    throw AssemblyError("names the file " + name + ", which is outside of its folder");
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
  {
    throw UriError("needs the file " + name + ", which is not there");
  }
  return this->ReadFile(file);
}

}
