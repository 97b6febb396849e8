#ifndef VITRINE_CORE_ASSEMBLY_GLTF_DRACO_MESH_H
#define VITRINE_CORE_ASSEMBLY_GLTF_DRACO_MESH_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace vitrine
{

/** The numbers of faces and vertices that compressed data states. */
struct DracoCounts
{
  std::uint32_t Faces = 0;
  std::uint32_t Vertices = 0;
};

/**
 * A mesh that Draco decompresses.
 *
 * Its source file alone includes Draco. It is compiled for the string ABI of Debian's library, which need not be that
 * of VTK. So there are no strings and no exceptions here.
 */
class DracoMesh
{
public:
  DracoMesh();
  ~DracoMesh();
  DracoMesh(const DracoMesh&) = delete;
  void operator=(const DracoMesh&) = delete;

  /**
   * Reads the counts, by the bitstream of Draco 2.2, which glTF demands. Returns false if it is another. The decoder
   * allocates memory for so many before it comes to data that it does not find.
   */
  static bool ReadCounts(const std::uint8_t* data, std::size_t size, DracoCounts& counts);

  /** Decompresses data. Returns false if it is damaged. */
  bool Decode(const std::uint8_t* data, std::size_t size);

  std::size_t NumberOfVertices() const;

  /** Returns the corners of all triangles. */
  std::vector<std::uint32_t> Triangles() const;

  /**
   * Converts an attribute into `packed`, with `components` numbers of T for each vertex. Returns false if there is no
   * such attribute, or if it is damaged. T is a type of glTF: an integer of at most 32 bits, or float.
   */
  template <class T>
  bool ReadAttribute(std::uint32_t id, std::size_t components, std::uint8_t* packed) const;

private:
  struct Decoded;
  std::unique_ptr<Decoded> Mesh;
};

}

#endif
