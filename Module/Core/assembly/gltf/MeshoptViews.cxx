#include "Core/assembly/gltf/MeshoptViews.h"

#include "Core/assembly/Assembly.h"
#include "Core/threads/ForEachInThreads.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <string>

namespace vitrine
{

namespace
{
using Bytes = std::vector<std::uint8_t>;
using Json = GltfDocument::Json;

// A byte of compressed data makes at most so many: a group of 16 values takes at least two bits a byte of them.
constexpr std::size_t MOST_BYTES_OF_A_CODE = 1024;

struct Compressed
{
  std::size_t Count;
  std::size_t Stride; ///< bytes of an element
  std::string Mode;
  std::string Filter;
  ByteView Data;
};

Compressed Describe(const GltfDocument& document, const Json& extension)
{
  const ByteView buffer = document.Buffer(extension.at("buffer").get<std::size_t>());
  return { Number(extension, "count", 0), Number(extension, "byteStride", 0),
    extension.value("mode", ""), extension.value("filter", "NONE"),
    { buffer.Data + Number(extension, "byteOffset", 0), Number(extension, "byteLength", 0) } };
}

bool IsPossible(const Compressed& view)
{
  const std::size_t stride = view.Stride;
  const bool hasStride = view.Mode == "ATTRIBUTES" ? stride % 4 == 0 && stride >= 4 && stride <= 256
                                                   : stride == 2 || stride == 4;
  const bool hasCount = view.Mode != "TRIANGLES" || view.Count % 3 == 0;
  return hasStride && hasCount && view.Count * stride <= view.Data.Size * MOST_BYTES_OF_A_CODE;
}

int Decode(const Compressed& view, Bytes& bytes)
{
  if (view.Mode == "ATTRIBUTES")
  {
    return meshopt_decodeVertexBuffer(
      bytes.data(), view.Count, view.Stride, view.Data.Data, view.Data.Size);
  }
  if (view.Mode == "TRIANGLES")
  {
    return meshopt_decodeIndexBuffer(
      bytes.data(), view.Count, view.Stride, view.Data.Data, view.Data.Size);
  }
  return view.Mode == "INDICES" ? meshopt_decodeIndexSequence(bytes.data(), view.Count, view.Stride,
                                    view.Data.Data, view.Data.Size)
                                : -1;
}

/** Undoes the filter of the attributes. Returns false if there is no such filter for elements of this size. */
bool Unfilter(const Compressed& view, Bytes& bytes)
{
  if (view.Filter == "NONE")
  {
    return true;
  }
  const bool isFourOrEight = view.Stride == 4 || view.Stride == 8;
  if (view.Filter == "OCTAHEDRAL" && isFourOrEight)
  {
    meshopt_decodeFilterOct(bytes.data(), view.Count, view.Stride);
    return true;
  }
  if (view.Filter == "QUATERNION" && view.Stride == 8)
  {
    meshopt_decodeFilterQuat(bytes.data(), view.Count, view.Stride);
    return true;
  }
  if (view.Filter == "EXPONENTIAL")
  {
    meshopt_decodeFilterExp(bytes.data(), view.Count, view.Stride);
    return true;
  }
  return false;
}

Bytes Decompress(const GltfDocument& document, const Compressed& view)
{
  if (!IsPossible(view))
  {
    throw AssemblyError("is damaged: a compressed bufferView cannot hold what it states");
  }
  document.Spend(view.Count * view.Stride);
  Bytes bytes(std::max(view.Count * view.Stride, std::size_t(1)));
  if (Decode(view, bytes) != 0 || !Unfilter(view, bytes))
  {
    throw AssemblyError("is damaged: a compressed bufferView cannot be decoded");
  }
  return bytes;
}
}

std::vector<Bytes> DecompressMeshoptViews(const GltfDocument& document)
{
  const Json& views = document.Objects("bufferViews");
  std::vector<std::size_t> compressed;
  for (std::size_t i = 0; i < views.size(); ++i)
  {
    if (Extension(views[i], "EXT_meshopt_compression"))
    {
      compressed.push_back(i);
    }
  }
  std::vector<Bytes> decompressed(compressed.empty() ? 0 : views.size());
  ForEachInThreads(compressed.size(),
    [&](std::size_t i)
    {
      const Json& extension = *Extension(views[compressed[i]], "EXT_meshopt_compression");
      Bytes& bytes = decompressed[compressed[i]];
      bytes = Decompress(document, Describe(document, extension));
      if (bytes.size() < Number(views[compressed[i]], "byteLength", 0))
      {
        throw AssemblyError(
          "is damaged: bufferView " + std::to_string(compressed[i]) + " is longer than its data");
      }
    });
  return decompressed;
}

}
