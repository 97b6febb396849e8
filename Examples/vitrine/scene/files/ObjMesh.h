/**
 * The geometry of an OBJ file by its groups and materials.
 */
#ifndef VITRINE_OBJ_MESH_H
#define VITRINE_OBJ_MESH_H

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace program
{

/** What an OBJ file says before a cell: its object, its group and its material, each of which may be empty. */
struct ObjPlace
{
  std::string Object;
  std::string Group;
  std::string Material;

  bool operator<(const ObjPlace& other) const
  {
    return std::tie(this->Object, this->Group, this->Material) <
      std::tie(other.Object, other.Group, other.Material);
  }
};

/** All cells of one place. A corner has numbers from 0 of a vertex, a texture vertex and a normal; -1 for none. */
struct ObjPiece
{
  using Corner = std::array<int, 3>;

  ObjPlace Place;
  std::vector<std::vector<Corner>> Faces;
  std::vector<std::vector<Corner>> Lines;
  std::vector<std::vector<Corner>> Points;
};

struct ObjMesh
{
  std::vector<std::array<float, 3>> Vertices;
  std::vector<std::array<float, 3>> Colors; ///< of vertices, in [0, 1]; empty if no vertex has one
  std::vector<std::array<float, 2>> TextureVertices;
  std::vector<std::array<float, 3>> Normals;
  std::vector<ObjPiece> Pieces; ///< in the order of their first cells
  std::vector<std::string> MaterialLibraries;
  std::vector<std::string> Notes;
};

/** Read an OBJ file's bytes. Throws InputError, with the line, if they cannot be. */
ObjMesh ReadObjMesh(const std::string& path, const std::string& bytes);

/** A piece with the points that it uses. */
vtkSmartPointer<vtkPolyData> MakePolyData(const ObjMesh& mesh, const ObjPiece& piece);

}
#endif
