#include "Core/assembly/gltf/GltfAccessors.h"

#include "Core/assembly/Assembly.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace vitrine
{

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Json = GltfDocument::Json;

// An accessor without a view takes no bytes of the file, whatever its number of elements.
constexpr std::size_t MOST_BYTES_WITHOUT_VIEW = std::size_t(64) << 20;

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

std::size_t ComponentsOf(const std::string& type)
{
  static const std::pair<const char*, std::size_t> types[] = { { "SCALAR", 1 }, { "VEC2", 2 },
    { "VEC3", 3 }, { "VEC4", 4 }, { "MAT2", 4 }, { "MAT3", 9 }, { "MAT4", 16 } };
  for (const auto& [name, components] : types)
  {
    if (type == name)
    {
      return components;
    }
  }
  return 0;
}

std::string AccessorName(std::size_t index)
{
  return "accessor " + std::to_string(index);
}

[[noreturn]] void FailBeyond(std::size_t index)
{
  throw AssemblyError("is damaged: " + AccessorName(index) + " reaches beyond its bufferView");
}

/** Elements of equal size, whose first bytes are `Step` bytes apart. */
struct SpacedElements
{
  const std::uint8_t* First = nullptr;
  std::size_t Step = 0;
  std::size_t Count = 0;
  std::size_t ElementBytes = 0;
};

/** Returns elements of a view, of which all must be within. @param stride  0 for no gaps */
SpacedElements ElementsOf(ByteView view, std::size_t offset, std::size_t stride, std::size_t count,
  std::size_t elementBytes, std::size_t index)
{
  const std::size_t step = stride == 0 ? elementBytes : stride;
  if (step < elementBytes || offset + step * (count - 1) + elementBytes > view.Size)
  {
    FailBeyond(index);
  }
  return { view.Data + offset, step, count, elementBytes };
}

/** Returns all elements, or those that are chosen, without gaps. */
Bytes Pack(const SpacedElements& elements, GltfChoice chosen)
{
  const std::size_t bytes = elements.ElementBytes;
  if (!chosen && elements.Step == bytes)
  {
    return { elements.First, elements.First + elements.Count * bytes };
  }
  const std::size_t count = chosen ? chosen->size() : elements.Count;
  Bytes packed(count * bytes);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t element = chosen ? (*chosen)[i] : i;
    std::memcpy(packed.data() + i * bytes, elements.First + element * elements.Step, bytes);
  }
  return packed;
}

template <class T>
T Component(const std::uint8_t* bytes, std::size_t place)
{
  T value;
  std::memcpy(&value, bytes + place * sizeof(T), sizeof(T));
  return value;
}

std::uint32_t UnsignedComponent(const std::uint8_t* bytes, std::size_t place, int component)
{
  switch (component)
  {
    case GLTF_UNSIGNED_BYTE:
      return bytes[place];
    case GLTF_UNSIGNED_SHORT:
      return Component<std::uint16_t>(bytes, place);
    case GLTF_UNSIGNED_INT:
      return Component<std::uint32_t>(bytes, place);
    default:
      throw AssemblyError("is damaged: it has indices that are no unsigned integers");
  }
}

/** Puts the sparse elements into packed bytes. */
void ReplaceSparse(const GltfDocument& document, std::size_t index, const GltfAccessor& accessor,
  const Json& sparse, Bytes& packed)
{
  const std::size_t count = Number(sparse, "count", 0);
  if (count == 0 || count > accessor.Count)
  {
    throw AssemblyError("is damaged: " + AccessorName(index) + " is sparse in " +
      std::to_string(count) + " elements");
  }
  const Json& places = sparse.at("indices");
  const Json& values = sparse.at("values");
  const int component = places.at("componentType").get<int>();
  const std::size_t bytes = accessor.ElementBytes();
  const SpacedElements placed = ElementsOf(
    document.View(places.at("bufferView").get<std::size_t>()), Number(places, "byteOffset", 0), 0,
    count, std::max(ComponentBytes(component), std::size_t(1)), index);
  const SpacedElements replacing =
    ElementsOf(document.View(values.at("bufferView").get<std::size_t>()),
      Number(values, "byteOffset", 0), 0, count, bytes, index);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t place = UnsignedComponent(placed.First, i, component);
    if (place >= accessor.Count)
    {
      throw AssemblyError(
        "is damaged: " + AccessorName(index) + " replaces an element that it does not have");
    }
    std::memcpy(packed.data() + place * bytes, replacing.First + i * bytes, bytes);
  }
}

/** Returns the elements of an accessor's view. There is none where all are zeros (glTF 2.0, 3.6.2.1), of few bytes. */
std::optional<SpacedElements> FindElements(
  const GltfDocument& document, std::size_t index, const GltfAccessor& accessor)
{
  const Json& json = document.Object("accessors", index);
  const std::size_t bytes = accessor.ElementBytes();
  if (json.contains("bufferView"))
  {
    const std::size_t number = json.at("bufferView").get<std::size_t>();
    const std::size_t stride = Number(document.Object("bufferViews", number), "byteStride", 0);
    return ElementsOf(
      document.View(number), Number(json, "byteOffset", 0), stride, accessor.Count, bytes, index);
  }
  if (accessor.Count > MOST_BYTES_WITHOUT_VIEW / bytes)
  {
    throw AssemblyError(
      "is damaged: " + AccessorName(index) + " has too many elements for one without a bufferView");
  }
  return std::nullopt;
}

/** Returns all elements or the chosen ones without gaps; zeros where no view holds them. */
Bytes PackElements(
  const GltfDocument& document, std::size_t index, const GltfAccessor& accessor, GltfChoice chosen)
{
  const Json& json = document.Object("accessors", index);
  const std::size_t bytes = accessor.ElementBytes();
  const bool isSparse = json.contains("sparse");
  const GltfChoice packedFirst = isSparse ? nullptr : chosen;
  const std::optional<SpacedElements> elements = FindElements(document, index, accessor);
  Bytes packed = elements ? Pack(*elements, packedFirst)
                          : Bytes((packedFirst ? chosen->size() : accessor.Count) * bytes);
  if (isSparse)
  {
    ReplaceSparse(document, index, accessor, json.at("sparse"), packed);
    packed = chosen ? Pack({ packed.data(), bytes, accessor.Count, bytes }, chosen) : packed;
  }
  return packed;
}

/** glTF 2.0, 3.6.2.2: c / 127, 255, 32767 or 65535, and at least -1. */
template <class T>
float ToFloat(T value, bool isNormalized)
{
  if constexpr (std::is_integral_v<T>)
  {
    if (isNormalized)
    {
      const float scaled =
        static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
      return std::max(scaled, -1.0f);
    }
  }
  return static_cast<float>(value);
}

template <class T>
std::vector<float> ToFloats(
  const std::uint8_t* bytes, const GltfAccessor& accessor, std::size_t components)
{
  std::vector<float> floats(accessor.Count * components, 1.0f);
  for (std::size_t i = 0; i < accessor.Count; ++i)
  {
    float* const element = floats.data() + i * components;
    for (std::size_t c = 0; c < accessor.Components; ++c)
    {
      element[c] = ToFloat(Component<T>(bytes, i * accessor.Components + c), accessor.IsNormalized);
    }
  }
  return floats;
}

std::vector<float> ToFloats(
  const std::uint8_t* bytes, const GltfAccessor& accessor, std::size_t components)
{
  switch (accessor.Component)
  {
    case GLTF_BYTE:
      return ToFloats<std::int8_t>(bytes, accessor, components);
    case GLTF_UNSIGNED_BYTE:
      return ToFloats<std::uint8_t>(bytes, accessor, components);
    case GLTF_SHORT:
      return ToFloats<std::int16_t>(bytes, accessor, components);
    case GLTF_UNSIGNED_SHORT:
      return ToFloats<std::uint16_t>(bytes, accessor, components);
    case GLTF_UNSIGNED_INT:
      return ToFloats<std::uint32_t>(bytes, accessor, components);
    default:
      return ToFloats<float>(bytes, accessor, components);
  }
}

/** The same of what was given in place of the accessor's view, if anything was. Has the accessor count the elements. */
Bytes TakeElements(const GltfDocument& document, std::size_t index, GltfAccessor& accessor,
  const ByteView* given, GltfChoice chosen)
{
  Bytes packed = given
    ? Pack(ElementsOf(*given, 0, 0, accessor.Count, accessor.ElementBytes(), index), chosen)
    : PackElements(document, index, accessor, chosen);
  accessor.Count = chosen ? chosen->size() : accessor.Count;
  return packed;
}
}

std::size_t GltfAccessor::ElementBytes() const
{
  return ComponentBytes(this->Component) * this->Components;
}

GltfAccessor DescribeGltfAccessor(const GltfDocument& document, std::size_t index)
{
  const Json& json = document.Object("accessors", index);
  GltfAccessor accessor;
  accessor.Count = Number(json, "count", 0);
  accessor.Component = json.at("componentType").get<int>();
  accessor.Components = ComponentsOf(json.at("type").get<std::string>());
  accessor.IsNormalized = json.value("normalized", false);
  if (accessor.ElementBytes() == 0 || accessor.Count == 0)
  {
    throw AssemblyError("is damaged: " + AccessorName(index) + " has no type or no elements");
  }
  return accessor;
}

std::size_t CountGltfElements(const GltfDocument& document, std::size_t index)
{
  const GltfAccessor accessor = DescribeGltfAccessor(document, index);
  FindElements(document, index, accessor);
  return accessor.Count;
}

std::vector<float> ReadGltfFloats(const GltfDocument& document, std::size_t index,
  std::size_t components, const ByteView* packed, GltfChoice chosen)
{
  GltfAccessor accessor = DescribeGltfAccessor(document, index);
  const bool isColor = components == 4 && accessor.Components == 3;
  if (accessor.Components != components && !isColor)
  {
    throw AssemblyError("is damaged: " + AccessorName(index) + " has " +
      std::to_string(accessor.Components) + " numbers to an element where " +
      std::to_string(components) + " are needed");
  }
  const Bytes elements = TakeElements(document, index, accessor, packed, chosen);
  return ToFloats(elements.data(), accessor, components);
}

std::vector<std::uint32_t> ReadGltfIntegers(
  const GltfDocument& document, std::size_t index, const ByteView* packed, GltfChoice chosen)
{
  GltfAccessor accessor = DescribeGltfAccessor(document, index);
  const Bytes elements = TakeElements(document, index, accessor, packed, chosen);
  std::vector<std::uint32_t> integers(accessor.Count * accessor.Components);
  for (std::size_t i = 0; i < integers.size(); ++i)
  {
    integers[i] = UnsignedComponent(elements.data(), i, accessor.Component);
  }
  return integers;
}

}
