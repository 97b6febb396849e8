#include "Core/assembly/gltf/DracoMesh.h"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstring>
#include <utility>

namespace vitrine
{

namespace
{
draco::DecoderBuffer BufferOf(const std::uint8_t* data, std::size_t size)
{
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(data), size);
  return buffer;
}
}

struct DracoMesh::Decoded
{
  std::unique_ptr<draco::Mesh> Mesh;
};

DracoMesh::DracoMesh()
  : Mesh(new Decoded)
{
}

DracoMesh::~DracoMesh() = default;

bool DracoMesh::ReadCounts(const std::uint8_t* data, std::size_t size, DracoCounts& counts)
{
  draco::DecoderBuffer buffer = BufferOf(data, size);
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() ||
    header.encoder_type != draco::TRIANGULAR_MESH || header.version_major != 2 ||
    header.version_minor != 2)
  {
    return false;
  }
  buffer.set_bitstream_version(DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor));
  draco::GeometryMetadata metadata;
  if ((header.flags & METADATA_FLAG_MASK) != 0 &&
    !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
  {
    return false;
  }
  std::uint8_t traversal = 0;
  const bool isEdgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
  return isEdgebreaker
    ? buffer.Decode(&traversal) && draco::DecodeVarint(&counts.Vertices, &buffer) &&
      draco::DecodeVarint(&counts.Faces, &buffer)
    : draco::DecodeVarint(&counts.Faces, &buffer) && draco::DecodeVarint(&counts.Vertices, &buffer);
}

bool DracoMesh::Decode(const std::uint8_t* data, std::size_t size)
{
  draco::DecoderBuffer buffer = BufferOf(data, size);
  draco::Decoder decoder;
  draco::StatusOr<std::unique_ptr<draco::Mesh>> mesh = decoder.DecodeMeshFromBuffer(&buffer);
  this->Mesh->Mesh = mesh.ok() ? std::move(mesh).value() : nullptr;
  return this->Mesh->Mesh != nullptr;
}

std::size_t DracoMesh::NumberOfVertices() const
{
  return this->Mesh->Mesh->num_points();
}

std::vector<std::uint32_t> DracoMesh::Triangles() const
{
  const draco::Mesh& mesh = *this->Mesh->Mesh;
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * std::size_t(mesh.num_faces()));
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
  {
    for (const draco::PointIndex& corner : mesh.face(face))
    {
      corners.push_back(corner.value());
    }
  }
  return corners;
}

template <class T>
bool DracoMesh::ReadAttribute(std::uint32_t id, std::size_t components, std::uint8_t* packed) const
{
  const draco::PointAttribute* const attribute = this->Mesh->Mesh->GetAttributeByUniqueId(id);
  if (!attribute)
  {
    return false;
  }
  std::vector<T> element(components);
  for (std::size_t i = 0; i < this->NumberOfVertices(); ++i)
  {
    const draco::PointIndex point(static_cast<std::uint32_t>(i));
    const draco::AttributeValueIndex value = attribute->mapped_index(point);
    if (value.value() >= attribute->size() ||
      !attribute->ConvertValue<T>(value, static_cast<std::int8_t>(components), element.data()))
    {
      return false;
    }
    std::memcpy(packed + i * components * sizeof(T), element.data(), components * sizeof(T));
  }
  return true;
}

template bool DracoMesh::ReadAttribute<std::int8_t>(
  std::uint32_t, std::size_t, std::uint8_t*) const;
template bool DracoMesh::ReadAttribute<std::uint8_t>(
  std::uint32_t, std::size_t, std::uint8_t*) const;
template bool DracoMesh::ReadAttribute<std::int16_t>(
  std::uint32_t, std::size_t, std::uint8_t*) const;
template bool DracoMesh::ReadAttribute<std::uint16_t>(
  std::uint32_t, std::size_t, std::uint8_t*) const;
template bool DracoMesh::ReadAttribute<std::uint32_t>(
  std::uint32_t, std::size_t, std::uint8_t*) const;
template bool DracoMesh::ReadAttribute<float>(std::uint32_t, std::size_t, std::uint8_t*) const;

}
