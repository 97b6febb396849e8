#include "scene/files/GltfAccessors.h"

#include "Errors.h"

#include <algorithm>
#include <map>

namespace program
{

namespace
{
using Json = nlohmann::json;

const std::size_t LargestNumber = 0x7fffffff; // VTK's importer counts bytes in int

std::size_t ComponentBytes(int component)
{
  switch (component)
  {
    case GLTF_BYTE:
    case GLTF_UNSIGNED_BYTE:
      return 1;
    case GLTF_SHORT:
    case GLTF_UNSIGNED_SHORT:
      return 2;
    case GLTF_UNSIGNED_INT:
    case GLTF_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool IsUnsigned(int component)
{
  return component == GLTF_UNSIGNED_BYTE || component == GLTF_UNSIGNED_SHORT ||
    component == GLTF_UNSIGNED_INT;
}

std::size_t TypeComponents(const std::string& type)
{
  static const std::map<std::string, std::size_t> components = { { "SCALAR", 1 }, { "VEC2", 2 },
    { "VEC3", 3 }, { "VEC4", 4 }, { "MAT2", 4 }, { "MAT3", 9 }, { "MAT4", 16 } };
  const auto found = components.find(type);
  return found == components.end() ? 0 : found->second;
}

struct ViewDescription
{
  std::size_t Buffer;
  std::size_t Offset;
  std::size_t Length;
  std::size_t Stride; ///< 0 if elements follow each other
};

/** A number of bytes or elements; refuses what does not fit into VTK's int. */
std::size_t Number(
  const GltfDocument& document, const Json& json, const char* key, std::size_t preset)
{
  if (!json.contains(key))
  {
    return preset;
  }
  const Json& value = json.at(key);
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > LargestNumber)
  {
    throw InputError(document.Path,
      std::string("is damaged: a ") + key + " is " +
        value.dump(-1, ' ', true, Json::error_handler_t::replace));
  }
  return value.get<std::size_t>();
}

ViewDescription DescribeView(const GltfDocument& document, std::size_t index)
{
  const Json& view = document.Json.at("bufferViews").at(index);
  return { view.at("buffer").get<std::size_t>(), Number(document, view, "byteOffset", 0),
    Number(document, view, "byteLength", 0), Number(document, view, "byteStride", 0) };
}

void CheckView(const GltfDocument& document, std::size_t index)
{
  const ViewDescription view = DescribeView(document, index);
  if (view.Offset + view.Length > document.Buffers[view.Buffer].size())
  {
    throw InputError(document.Path,
      "is damaged: bufferView " + std::to_string(index) + " reaches beyond its buffer");
  }
}

std::uint32_t ReadIndex(const char* bytes, std::size_t count)
{
  std::uint32_t index = 0;
  for (std::size_t i = count; i-- > 0;)
  {
    index = index << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return index;
}

/** Whether `count` elements of `bytes` bytes, the first at `offset`, lie in the view. */
bool FitsView(const ViewDescription& view, std::size_t offset, std::size_t count, std::size_t bytes)
{
  const std::size_t stride = view.Stride == 0 ? bytes : view.Stride;
  return count > 0 && stride >= bytes && offset + stride * (count - 1) + bytes <= view.Length;
}

void CheckSparse(const GltfDocument& document, const std::string& name, const Json& sparse,
  const GltfAccessor& accessor, std::size_t elementBytes)
{
  const std::size_t count = Number(document, sparse, "count", 0);
  const Json& indices = sparse.at("indices");
  const Json& values = sparse.at("values");
  const int component = indices.at("componentType").get<int>();
  const ViewDescription indexView =
    DescribeView(document, indices.at("bufferView").get<std::size_t>());
  const std::size_t indexOffset = Number(document, indices, "byteOffset", 0);
  if (!IsUnsigned(component) ||
    !FitsView(indexView, indexOffset, count, ComponentBytes(component)) ||
    !FitsView(DescribeView(document, values.at("bufferView").get<std::size_t>()),
      Number(document, values, "byteOffset", 0), count, elementBytes))
  {
    throw InputError(document.Path, "is damaged: " + name + " is sparse beyond its buffer");
  }
  const std::string& bytes = document.Buffers[indexView.Buffer];
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t place = indexView.Offset + indexOffset + i * ComponentBytes(component);
    const std::uint32_t index = ReadIndex(bytes.data() + place, ComponentBytes(component));
    if (index >= accessor.Count)
    {
      throw InputError(document.Path, "is damaged: " + name + " replaces an element it has not");
    }
  }
}

void CheckAccessor(const GltfDocument& document, std::size_t index)
{
  const std::string name = "accessor " + std::to_string(index);
  const Json& json = document.Json.at("accessors").at(index);
  const GltfAccessor accessor = DescribeGltfAccessor(document, index);
  const std::size_t bytes = ComponentBytes(accessor.Component) * TypeComponents(accessor.Type);
  if (bytes == 0 || accessor.Count == 0)
  {
    throw InputError(document.Path, "is damaged: " + name + " has no type or no elements");
  }
  if (!json.contains("bufferView"))
  {
    throw InputError(
      document.Path, name + " has no bufferView, and VTK's importer cannot read that");
  }
  if (!FitsView(DescribeView(document, json.at("bufferView").get<std::size_t>()),
        Number(document, json, "byteOffset", 0), accessor.Count, bytes))
  {
    throw InputError(document.Path, "is damaged: " + name + " reaches beyond its bufferView");
  }
  if (accessor.IsSparse)
  {
    CheckSparse(document, name, json.at("sparse"), accessor, bytes);
  }
}
}

GltfAccessor DescribeGltfAccessor(const GltfDocument& document, std::size_t index)
{
  const Json& json = document.Json.at("accessors").at(index);
  GltfAccessor accessor;
  accessor.Count = Number(document, json, "count", 0);
  accessor.Component = json.at("componentType").get<int>();
  accessor.Type = json.at("type").get<std::string>();
  accessor.IsNormalized = json.value("normalized", false);
  accessor.IsSparse = json.contains("sparse");
  return accessor;
}

void CheckGltfAccessors(const GltfDocument& document)
{
  const auto count = [&document](const char* array)
  { return document.Json.contains(array) ? document.Json.at(array).size() : 0; };
  for (std::size_t i = 0; i < count("bufferViews"); ++i)
  {
    CheckView(document, i);
  }
  for (std::size_t i = 0; i < count("accessors"); ++i)
  {
    CheckAccessor(document, i);
  }
}

std::uint32_t LargestGltfIndex(const GltfDocument& document, std::size_t index)
{
  const GltfAccessor accessor = DescribeGltfAccessor(document, index);
  const Json& json = document.Json.at("accessors").at(index);
  const ViewDescription view = DescribeView(document, json.at("bufferView").get<std::size_t>());
  const std::size_t bytes = ComponentBytes(accessor.Component);
  const std::size_t stride = view.Stride == 0 ? bytes : view.Stride;
  const char* data =
    document.Buffers[view.Buffer].data() + view.Offset + Number(document, json, "byteOffset", 0);
  std::uint32_t largest = 0;
  for (std::size_t i = 0; i < accessor.Count; ++i)
  {
    largest = std::max(largest, ReadIndex(data + i * stride, bytes));
  }
  return largest;
}

std::string GltfViewBytes(const GltfDocument& document, std::size_t index)
{
  const ViewDescription view = DescribeView(document, index);
  return document.Buffers[view.Buffer].substr(view.Offset, view.Length);
}

}
