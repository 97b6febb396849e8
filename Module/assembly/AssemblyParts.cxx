#include "assembly/AssemblyParts.h"

#include "Core/assembly/UniqueNames.h"
#include "Core/threads/ForEachInThreads.h"
#include "assembly/PartPoints.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cstring>

namespace
{
using namespace vitrine;

// Of what parts take beside their geometry: a part, a letter of a path, which is kept some times, and all.
constexpr std::size_t BYTES_OF_A_PART = 500;
constexpr std::size_t BYTES_OF_A_LETTER = 4;
constexpr std::size_t MOST_BYTES = std::size_t{ 2 } << 30;

template <class Element>
vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, const std::vector<Element>& elements)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(sizeof(Element) / sizeof(float)));
  array->SetNumberOfTuples(static_cast<vtkIdType>(elements.size()));
  std::memcpy(array->GetPointer(0), elements.data(), elements.size() * sizeof(Element));
  return array;
}

/** RGB where all alphas are 1, so that an opaque part is not taken for a translucent one. */
vtkSmartPointer<vtkFloatArray> MakeColors(const std::vector<glm::vec4>& colors)
{
  if (std::any_of(
        colors.begin(), colors.end(), [](const glm::vec4& color) { return color.a < 1.0f; }))
  {
    return MakeArray("COLOR_0", colors);
  }
  return MakeArray("COLOR_0", std::vector<glm::vec3>(colors.begin(), colors.end()));
}

vtkSmartPointer<vtkCellArray> MakeCells(const AssemblyGeometry& geometry)
{
  const auto size = static_cast<int>(geometry.Kind);
  const auto corners = static_cast<vtkIdType>(geometry.Indices.size());
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(corners);
  std::memcpy(connectivity->GetPointer(0), geometry.Indices.data(),
    geometry.Indices.size() * sizeof(std::int32_t));
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(corners / size + 1);
  std::generate_n(offsets->GetPointer(0), corners / size + 1,
    [next = -size, size]() mutable { return next += size; });
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

vtkSmartPointer<vtkPolyData> MakePolyData(const AssemblyGeometry& geometry)
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<PartPoints> points;
  points->SetData(MakeArray("Points", geometry.Positions));
  polyData->SetPoints(points);
  vtkPointData* const data = polyData->GetPointData();
  if (!geometry.Normals.empty())
  {
    data->SetNormals(MakeArray("NORMAL", geometry.Normals));
  }
  if (!geometry.Tangents.empty())
  {
    data->SetTangents(MakeArray(
      "TANGENT", std::vector<glm::vec3>(geometry.Tangents.begin(), geometry.Tangents.end())));
  }
  if (!geometry.Colors.empty())
  {
    data->SetScalars(MakeColors(geometry.Colors));
  }
  if (!geometry.TexCoords[0].empty())
  {
    data->SetTCoords(MakeArray("TEXCOORD_0", geometry.TexCoords[0]));
  }
  const vtkSmartPointer<vtkCellArray> cells = MakeCells(geometry);
  switch (geometry.Kind)
  {
    case CellKind::Points:
      polyData->SetVerts(cells);
      break;
    case CellKind::Lines:
      polyData->SetLines(cells);
      break;
    case CellKind::Triangles:
      polyData->SetPolys(cells);
      break;
  }
  return polyData;
}

/** The geometries of each mesh, each made once. */
std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> MakeMeshes(Assembly& assembly)
{
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> meshes(assembly.Meshes.size());
  ForEachInThreads(meshes.size(),
    [&](std::size_t i)
    {
      for (AssemblyGeometry& geometry : assembly.Meshes[i].Geometries)
      {
        meshes[i].push_back(MakePolyData(geometry));
        geometry = { geometry.Kind, geometry.Material, {}, {}, {}, {}, {}, {} };
      }
    });
  return meshes;
}

vtkSmartPointer<vtkMatrix4x4> MakePlace(const glm::dmat4& place)
{
  if (place == glm::dmat4(1.0))
  {
    return nullptr;
  }
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const glm::dmat4 rows = glm::transpose(place);
  matrix->DeepCopy(&rows[0][0]);
  return matrix;
}

/** Goes through the tree in its order and makes the parts of each node. */
class PartMaker
{
public:
  explicit PartMaker(Assembly& assembly)
    : Source(assembly)
    , Meshes(MakeMeshes(assembly))
  {
  }

  std::vector<AssemblyPart> Make()
  {
    struct Open
    {
      int Node;
      glm::dmat4 Parent;
      std::string Path;
    };
    std::vector<Open> open;
    const auto push =
      [&open](const std::vector<int>& nodes, const glm::dmat4& parent, const std::string& path)
    {
      std::for_each(nodes.rbegin(), nodes.rend(),
        [&](int node) {
          open.push_back({ node, parent, path });
        });
    };
    push(this->Source.Roots, glm::dmat4(1.0), "");
    while (!open.empty())
    {
      const Open next = open.back();
      open.pop_back();
      const AssemblyNode& node = this->Source.Nodes[static_cast<std::size_t>(next.Node)];
      const glm::dmat4 world = next.Parent * node.Transform;
      const std::string path =
        this->Paths.Make(next.Path + "/" + NodeName(this->Source, next.Node));
      this->Spend(path);
      this->AddParts(next.Node, world, path);
      push(node.Children, world, path);
    }
    return std::move(this->Parts);
  }

private:
  /** A small file may state many instances of many pieces, each with a path of its own. */
  void Spend(const std::string& path)
  {
    this->Bytes += BYTES_OF_A_PART + BYTES_OF_A_LETTER * path.size();
    if (this->Bytes > MOST_BYTES)
    {
      throw AssemblyError(
        "has more parts than are read: more than " + std::to_string(this->Parts.size()));
    }
  }

  void AddParts(int number, const glm::dmat4& world, const std::string& path)
  {
    const AssemblyNode& node = this->Source.Nodes[static_cast<std::size_t>(number)];
    if (node.Mesh == NO_INDEX)
    {
      return;
    }
    static const std::vector<glm::dmat4> atOrigin = { glm::dmat4(1.0) };
    const std::vector<glm::dmat4>& places = node.Instances.empty() ? atOrigin : node.Instances;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const std::string suffix = places.size() > 1 ? "/" + std::to_string(i) : "";
      this->AddGeometries(number, MakePlace(world * places[i]), path + suffix);
    }
  }

  void AddGeometries(int number, vtkMatrix4x4* place, const std::string& path)
  {
    const auto mesh =
      static_cast<std::size_t>(this->Source.Nodes[static_cast<std::size_t>(number)].Mesh);
    const std::vector<AssemblyGeometry>& geometries = this->Source.Meshes[mesh].Geometries;
    for (std::size_t i = 0; i < geometries.size(); ++i)
    {
      this->Spend(path);
      AssemblyPart part;
      part.Path = geometries.size() > 1 ? path + "/" + std::to_string(i) : path;
      part.Name = this->Names.Make(this->ShortName(part.Path, number));
      part.Node = number;
      part.Material = geometries[i].Material;
      part.Geometry = this->Meshes[mesh][i];
      part.Place = place;
      this->Parts.push_back(std::move(part));
    }
  }

  /** The node's name, with what follows it in the path. */
  std::string ShortName(const std::string& path, int number) const
  {
    const std::string name = NodeName(this->Source, number);
    const std::size_t found = path.rfind("/" + name);
    return found == std::string::npos ? name : path.substr(found + 1);
  }

  Assembly& Source;
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> Meshes;
  UniqueNames Paths, Names;
  std::size_t Bytes = 0;
  std::vector<AssemblyPart> Parts;
};
}

std::string NodeName(const Assembly& assembly, int node)
{
  const AssemblyNode& named = assembly.Nodes[static_cast<std::size_t>(node)];
  std::string name = named.Name;
  if (name.empty() && named.Mesh != NO_INDEX)
  {
    name = assembly.Meshes[static_cast<std::size_t>(named.Mesh)].Name;
  }
  if (name.empty())
  {
    name = "node-" + std::to_string(node);
  }
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

std::vector<AssemblyPart> MakeAssemblyParts(Assembly& assembly)
{
  return PartMaker(assembly).Make();
}
