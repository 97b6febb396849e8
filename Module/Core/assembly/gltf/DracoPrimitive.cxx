#include "Core/assembly/gltf/DracoPrimitive.h"

#include "Core/assembly/Assembly.h"
#include "Core/assembly/gltf/DracoMesh.h"
#include "Core/assembly/gltf/GltfAccessors.h"

namespace vitrine
{

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Json = GltfDocument::Json;

// Decoding takes about so many bytes for each face and each vertex.
constexpr std::size_t BYTES_OF_A_FACE = 64;
constexpr std::size_t BYTES_OF_A_VERTEX = 64;

void Decode(const GltfDocument& document, ByteView bytes, DracoMesh& mesh)
{
  DracoCounts counts;
  if (!DracoMesh::ReadCounts(bytes.Data, bytes.Size, counts))
  {
    throw AssemblyError("is damaged: data that Draco compressed is no mesh of its version 2.2");
  }
  document.Spend(BYTES_OF_A_FACE * counts.Faces + BYTES_OF_A_VERTEX * counts.Vertices);
  if (!mesh.Decode(bytes.Data, bytes.Size))
  {
    throw AssemblyError("is damaged: data that Draco compressed cannot be decoded");
  }
}

bool Convert(
  const DracoMesh& mesh, std::uint32_t id, const GltfAccessor& accessor, std::uint8_t* packed)
{
  const std::size_t components = accessor.Components;
  switch (accessor.Component)
  {
    case GLTF_BYTE:
      return mesh.ReadAttribute<std::int8_t>(id, components, packed);
    case GLTF_UNSIGNED_BYTE:
      return mesh.ReadAttribute<std::uint8_t>(id, components, packed);
    case GLTF_SHORT:
      return mesh.ReadAttribute<std::int16_t>(id, components, packed);
    case GLTF_UNSIGNED_SHORT:
      return mesh.ReadAttribute<std::uint16_t>(id, components, packed);
    case GLTF_UNSIGNED_INT:
      return mesh.ReadAttribute<std::uint32_t>(id, components, packed);
    default:
      return mesh.ReadAttribute<float>(id, components, packed);
  }
}

Bytes ReadAttribute(const DracoMesh& mesh, std::uint32_t id, const GltfAccessor& accessor)
{
  if (accessor.Count == mesh.NumberOfVertices())
  {
    Bytes packed(accessor.Count * accessor.ElementBytes());
    if (Convert(mesh, id, accessor, packed.data()))
    {
      return packed;
    }
  }
  throw AssemblyError(
    "is damaged: data that Draco compressed has other vertices than its accessors");
}
}

DracoPrimitive DecompressDracoPrimitive(const GltfDocument& document, const Json& primitive)
{
  const Json& extension = *Extension(primitive, "KHR_draco_mesh_compression");
  DracoMesh mesh;
  Decode(document, document.View(extension.at("bufferView").get<std::size_t>()), mesh);
  DracoPrimitive decompressed;
  decompressed.Indices = mesh.Triangles();
  for (const auto& [name, id] : Member(extension, "attributes").items())
  {
    const std::size_t accessor = primitive.at("attributes").at(name).get<std::size_t>();
    decompressed.Attributes[name] =
      ReadAttribute(mesh, id.get<std::uint32_t>(), DescribeGltfAccessor(document, accessor));
  }
  return decompressed;
}

}
