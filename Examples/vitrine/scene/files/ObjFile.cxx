#include "scene/files/FileReaders.h"

#include "Join.h"
#include "scene/files/FileBytes.h"
#include "scene/files/ObjMaterials.h"
#include "scene/files/ObjMesh.h"

#include "vtkPointData.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace program
{

namespace
{
namespace fs = std::filesystem;

const std::size_t MostNamesOfNote = 5;

using Materials = std::map<std::string, ObjMaterial>;

/** Material libraries that the file names and that are there, or the one that is called like the file. */
std::vector<std::string> FindLibraries(
  const std::string& path, const ObjMesh& mesh, std::vector<std::string>& notes)
{
  std::vector<std::string> found;
  std::error_code error;
  for (const std::string& name : mesh.MaterialLibraries)
  {
    const fs::path library = fs::path(path).parent_path() / name;
    if (fs::is_regular_file(library, error))
    {
      found.push_back(library.string());
    }
    else
    {
      notes.push_back("its material library '" + name + "' is not there");
    }
  }
  const fs::path alike = fs::path(path).replace_extension(".mtl");
  if (found.empty() && fs::is_regular_file(alike, error))
  {
    found.push_back(alike.string());
    if (!notes.empty())
    {
      notes.back() += "; '" + alike.filename().string() + "' is read instead";
    }
  }
  return found;
}

Materials ReadLibraries(
  const std::string& path, const ObjMesh& mesh, std::vector<std::string>& notes)
{
  Materials materials;
  for (const std::string& library : FindLibraries(path, mesh, notes))
  {
    materials.merge(ReadObjMaterials(library, notes));
  }
  return materials;
}

/** A piece by its group, its object or its material, whichever the file has. */
std::string NameOf(const std::string& path, const ObjPlace& place)
{
  for (const std::string* const name : { &place.Group, &place.Object, &place.Material })
  {
    if (!name->empty())
    {
      return *name;
    }
  }
  return fs::path(path).stem().string();
}

/** Numbers pieces of one group by their materials. */
class PathsOfPieces
{
public:
  explicit PathsOfPieces(const ObjMesh& mesh)
  {
    for (const ObjPiece& piece : mesh.Pieces)
    {
      ++this->Materials[{ piece.Place.Object, piece.Place.Group }];
    }
  }

  std::string PathOf(const std::string& name, const ObjPlace& place)
  {
    const bool isShared = this->Materials[{ place.Object, place.Group }] > 1 &&
      !(place.Object.empty() && place.Group.empty()) && !place.Material.empty();
    const std::string path =
      (place.Object.empty() || place.Group.empty() ? "" : PathStep(place.Object)) + PathStep(name) +
      (isShared ? PathStep(place.Material) : "");
    const int count = ++this->Seen[path];
    return count == 1 ? path : path + " (" + std::to_string(count) + ")";
  }

private:
  std::map<std::pair<std::string, std::string>, int> Materials; ///< pieces by object and group
  std::map<std::string, int> Seen;
};

Part MakePart(const ObjMesh& mesh, const ObjPiece& piece, const Materials& materials,
  const vtkSmartPointer<vtkProperty>& plain)
{
  Part part;
  part.MaterialName = piece.Place.Material;
  part.Geometry = MakePolyData(mesh, piece);
  part.Material = plain;
  const auto material = materials.find(piece.Place.Material);
  if (material != materials.end())
  {
    part.Material = material->second.Property;
    part.Texture = material->second.Texture;
    part.Geometry->GetPointData()->SetActiveScalars(nullptr); // the material's colour goes first
  }
  return part;
}

std::string DescribeMissing(const std::set<std::string>& names)
{
  std::vector<std::string> first(names.begin(), names.end());
  first.resize(std::min(first.size(), MostNamesOfNote));
  const std::size_t more = names.size() - first.size();
  return "there are no materials " +
    Join(first, [](const std::string& name) { return "'" + name + "'"; }) +
    (more > 0 ? " and " + std::to_string(more) + " more" : "") + ": their parts are white";
}
}

Scene ReadObjFile(const std::string& path)
{
  const ObjMesh mesh = ReadObjMesh(path, ReadBytes(path));
  Scene scene;
  scene.Notes = mesh.Notes;
  const Materials materials = ReadLibraries(path, mesh, scene.Notes);
  const vtkSmartPointer<vtkProperty> plain = MakeObjProperty();
  PathsOfPieces paths(mesh);
  std::set<std::string> missing;
  for (const ObjPiece& piece : mesh.Pieces)
  {
    Part part = MakePart(mesh, piece, materials, plain);
    part.Name = NameOf(path, piece.Place);
    part.Path = paths.PathOf(part.Name, piece.Place);
    scene.Parts.push_back(std::move(part));
    if (!piece.Place.Material.empty() && materials.count(piece.Place.Material) == 0)
    {
      missing.insert(piece.Place.Material);
    }
  }
  DrawManyPartsAsBlocks(scene);
  if (!missing.empty())
  {
    scene.Notes.push_back(DescribeMissing(missing));
  }
  return scene;
}

}
