#include "study/faces/FaceNeighbours.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <algorithm>

namespace vitrine
{

namespace
{

// Silences OpenMesh, which writes a line to its error stream for each face that it refuses.
class QuietOpenMesh
{
public:
  QuietOpenMesh()
    : WasEnabled(omerr().is_enabled())
  {
    omerr().disable();
  }
  ~QuietOpenMesh()
  {
    if (this->WasEnabled)
    {
      omerr().enable();
    }
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

private:
  bool WasEnabled;
};

// The surface of a mesh, built face by face from the faces that fit.
class MeshSurface
{
public:
  MeshSurface(std::size_t points, const std::vector<std::uint32_t>& corners,
    const std::vector<std::uint32_t>& ends)
  {
    for (std::size_t i = 0; i < points; ++i)
    {
      this->Surface.new_vertex();
    }
    Corners polygon;
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends)
    {
      polygon.clear();
      for (; first < end; ++first)
      {
        polygon.emplace_back(static_cast<int>(corners[first]));
      }
      this->Add(polygon);
    }
  }

  bool Has(std::uint32_t face) const { return this->Handles[face].is_valid(); }

  /** Returns the face across the side from `from` to `to` of a face on the surface. */
  std::uint32_t Across(std::uint32_t from, std::uint32_t to) const
  {
    const OpenMesh::HalfedgeHandle side =
      this->Surface.find_halfedge(Corner(static_cast<int>(from)), Corner(static_cast<int>(to)));
    const OpenMesh::FaceHandle face = this->Surface.opposite_face_handle(side);
    return face.is_valid() ? this->Numbers[face.idx()] : NoNeighbour;
  }

private:
  using Corner = OpenMesh::VertexHandle;
  using Corners = std::vector<Corner>;

  void Add(const Corners& polygon)
  {
    const OpenMesh::FaceHandle face =
      this->IsPolygon(polygon) ? this->Surface.add_face(polygon) : OpenMesh::FaceHandle();
    if (face.is_valid())
    {
      this->Numbers.push_back(static_cast<std::uint32_t>(this->Handles.size()));
    }
    this->Handles.push_back(face);
  }

  bool IsPolygon(Corners corners) const
  {
    std::sort(corners.begin(), corners.end());
    return corners.size() >= 3 && corners.front().idx() >= 0 &&
      static_cast<std::size_t>(corners.back().idx()) < this->Surface.n_vertices() &&
      std::adjacent_find(corners.begin(), corners.end()) == corners.end();
  }

  OpenMesh::PolyMesh_ArrayKernelT<> Surface;
  std::vector<OpenMesh::FaceHandle> Handles; ///< Handle of each face of the mesh.
  std::vector<std::uint32_t> Numbers;        ///< Number in the mesh of each face of the surface.
};

}

std::vector<std::uint32_t> FindFaceNeighbours(std::size_t points,
  const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& ends)
{
  const QuietOpenMesh quiet;
  const MeshSurface surface(points, corners, ends);
  std::vector<std::uint32_t> neighbours(corners.size(), NoNeighbour);
  std::uint32_t first = 0;
  for (std::uint32_t face = 0; face < ends.size(); ++face)
  {
    const std::uint32_t end = ends[face];
    for (std::uint32_t i = first; i < end && surface.Has(face); ++i)
    {
      neighbours[i] = surface.Across(corners[i], corners[i + 1 < end ? i + 1 : first]);
    }
    first = end;
  }
  return neighbours;
}

}
