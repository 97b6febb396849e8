#ifndef VITRINE_CORE_ASSEMBLY_GLTF_GLTF_ACCESSORS_H
#define VITRINE_CORE_ASSEMBLY_GLTF_GLTF_ACCESSORS_H

#include "Core/assembly/gltf/GltfDocument.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace vitrine
{

/** Types of the components of an accessor. */
enum GltfComponent
{
  GLTF_BYTE = 5120,
  GLTF_UNSIGNED_BYTE = 5121,
  GLTF_SHORT = 5122,
  GLTF_UNSIGNED_SHORT = 5123,
  GLTF_UNSIGNED_INT = 5125,
  GLTF_FLOAT = 5126
};

/** How the elements of an accessor are stored. */
struct GltfAccessor
{
  std::size_t Count = 0;      ///< elements, at least 1
  int Component = GLTF_FLOAT; ///< a GltfComponent
  std::size_t Components = 1; ///< of an element, 1 to 16
  bool IsNormalized = false;  ///< Integers stand for [0, 1] or [-1, 1].

  std::size_t ElementBytes() const;
};

/**
 * Describes an accessor.
 * @throws  AssemblyError if it has a type that does not exist, or no elements
 */
GltfAccessor DescribeGltfAccessor(const GltfDocument& document, std::size_t index);

/**
 * Returns the number of elements of an accessor, all of which can be read: what a file claims may take no memory.
 * @throws  AssemblyError if it reaches beyond its view
 */
std::size_t CountGltfElements(const GltfDocument& document, std::size_t index);

/** Numbers of the elements that are read, in this order. Null stands for all. Each is below GltfAccessor::Count. */
using GltfChoice = const std::vector<std::uint32_t>*;

/**
 * Returns the elements of an accessor as floats, each with `components` of them. Of colours without alpha the fourth
 * is 1. Normalized integers are scaled; sparse elements are put in.
 * @param packed  elements without gaps that stand in for those of the accessor's view; none if null
 * @throws        AssemblyError if the accessor has other components, or reaches beyond its view
 */
std::vector<float> ReadGltfFloats(const GltfDocument& document, std::size_t index,
  std::size_t components, const ByteView* packed = nullptr, GltfChoice chosen = nullptr);

/**
 * Returns the elements of an accessor of unsigned integers, such as indices or joints, one after the other.
 * @throws  AssemblyError if it has other numbers, or reaches beyond its view
 */
std::vector<std::uint32_t> ReadGltfIntegers(const GltfDocument& document, std::size_t index,
  const ByteView* packed = nullptr, GltfChoice chosen = nullptr);

/** Returns the elements of an accessor as vectors or matrices of floats: glm::vec2, vec3, vec4 or mat4. */
template <class Element>
std::vector<Element> ReadGltfElements(const GltfDocument& document, std::size_t index,
  const ByteView* packed = nullptr, GltfChoice chosen = nullptr)
{
  constexpr std::size_t components = sizeof(Element) / sizeof(float);
  const std::vector<float> floats = ReadGltfFloats(document, index, components, packed, chosen);
  const auto* const first = reinterpret_cast<const Element*>(floats.data());
  return { first, first + floats.size() / components };
}

}

#endif
