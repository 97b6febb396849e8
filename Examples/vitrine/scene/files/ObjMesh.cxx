#include "scene/files/ObjMesh.h"

#include "Errors.h"
#include "scene/files/ObjLines.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace program
{

namespace
{
const std::set<std::string_view> CurvedCommands = { "curv", "curv2", "surf" };

class ObjScanner
{
public:
  void Take(const ObjLine& line)
  {
    const std::string_view command = line.Words[0];
    if (command == "v")
    {
      this->TakeVertex(line);
    }
    else if (command == "vt")
    {
      const double v = line.Words.size() > 2 ? line.NumberAt(2) : 0.0;
      this->Mesh.TextureVertices.push_back(
        { static_cast<float>(line.NumberAt(1)), static_cast<float>(v) });
    }
    else if (command == "vn")
    {
      this->Mesh.Normals.push_back(VectorAt(line, 1));
    }
    else if (command == "f" || command == "l" || command == "p")
    {
      this->TakeCell(line, command);
    }
    else if (command == "mtllib")
    {
      this->Mesh.MaterialLibraries.push_back(line.Rest());
    }
    else if (CurvedCommands.count(command) > 0)
    {
      this->HasCurves = true;
    }
    else
    {
      this->TakePlace(line, command);
    }
  }

  ObjMesh Finish(const std::string& path)
  {
    if (this->Mesh.Vertices.empty())
    {
      throw InputError(path, "has no vertices: it is empty or no OBJ file");
    }
    if (!this->Mesh.Colors.empty())
    {
      this->Mesh.Colors.resize(this->Mesh.Vertices.size(), { 1.0f, 1.0f, 1.0f });
    }
    if (this->HasCurves)
    {
      this->Mesh.Notes.emplace_back("curves and curved surfaces are not drawn");
    }
    return std::move(this->Mesh);
  }

private:
  static std::array<float, 3> VectorAt(const ObjLine& line, std::size_t word)
  {
    return { static_cast<float>(line.NumberAt(word)), static_cast<float>(line.NumberAt(word + 1)),
      static_cast<float>(line.NumberAt(word + 2)) };
  }

  void TakeVertex(const ObjLine& line)
  {
    if (line.Words.size() < 4)
    {
      line.Fail("is a vertex with fewer than three coordinates");
    }
    this->Mesh.Vertices.push_back(VectorAt(line, 1));
    if (line.Words.size() >= 7) // "v x y z r g b"
    {
      this->Mesh.Colors.resize(this->Mesh.Vertices.size() - 1, { 1.0f, 1.0f, 1.0f });
      this->Mesh.Colors.push_back(VectorAt(line, 4));
    }
  }

  void TakePlace(const ObjLine& line, std::string_view command)
  {
    if (command == "o")
    {
      this->Place.Object = line.Rest();
      this->Place.Group.clear();
    }
    else if (command == "g")
    {
      this->Place.Group = line.Rest();
    }
    else if (command == "usemtl")
    {
      this->Place.Material = line.Rest();
    }
    else
    {
      return;
    }
    this->Piece = nullptr;
  }

  ObjPiece& CurrentPiece()
  {
    if (!this->Piece)
    {
      const auto [found, isNew] = this->Numbers.try_emplace(this->Place, this->Mesh.Pieces.size());
      if (isNew)
      {
        this->Mesh.Pieces.emplace_back();
        this->Mesh.Pieces.back().Place = this->Place;
      }
      this->Piece = &this->Mesh.Pieces[found->second];
    }
    return *this->Piece;
  }

  void TakeCell(const ObjLine& line, std::string_view command)
  {
    std::vector<ObjPiece::Corner> corners;
    for (std::size_t i = 1; i < line.Words.size(); ++i)
    {
      corners.push_back(this->CornerAt(line, line.Words[i]));
    }
    const std::size_t fewest = command == "f" ? 3 : command == "l" ? 2 : 1;
    if (corners.size() < fewest)
    {
      line.Fail("has " + std::to_string(corners.size()) + " corners, and " +
        std::to_string(fewest) + " are the fewest for '" + std::string(command) + "'");
    }
    ObjPiece& piece = this->CurrentPiece();
    (command == "f"      ? piece.Faces
        : command == "l" ? piece.Lines
                         : piece.Points)
      .push_back(std::move(corners));
  }

  /** "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal". */
  ObjPiece::Corner CornerAt(const ObjLine& line, std::string_view text) const
  {
    const std::array<std::size_t, 3> counts = { this->Mesh.Vertices.size(),
      this->Mesh.TextureVertices.size(), this->Mesh.Normals.size() };
    ObjPiece::Corner corner = { -1, -1, -1 };
    const char* position = text.data();
    const char* const end = text.data() + text.size();
    for (std::size_t i = 0; i < 3 && position <= end; ++i)
    {
      long index = 0;
      const auto [last, error] = std::from_chars(position, end, index);
      const bool isEmpty = error == std::errc::invalid_argument && last == position && i > 0;
      if ((error != std::errc() && !isEmpty) || (last != end && *last != '/') ||
        (last != end && i == 2))
      {
        line.Fail("has a corner that is not understood: '" + std::string(text) + "'");
      }
      if (!isEmpty)
      {
        corner[i] = NumberOf(line, index, counts[i]);
      }
      position = last + 1;
    }
    return corner;
  }

  /** The number from 0 of what an index from 1, or from -1 back, means. */
  static int NumberOf(const ObjLine& line, long index, std::size_t count)
  {
    const long number = index < 0 ? static_cast<long>(count) + index : index - 1;
    if (index == 0 || number < 0 || number >= static_cast<long>(count))
    {
      line.Fail("has an index " + std::to_string(index) +
        " of what is not there: " + std::to_string(count) + " stand before it");
    }
    return static_cast<int>(number);
  }

  ObjMesh Mesh;
  ObjPlace Place;
  std::map<ObjPlace, std::size_t> Numbers;
  ObjPiece* Piece = nullptr; ///< of the place; null until a cell stands there
  bool HasCurves = false;
};

/** Whether the corners of a face turn both ways. VTK's mapper would draw it as a fan of triangles. */
bool IsConcave(const ObjMesh& mesh, const std::vector<ObjPiece::Corner>& face)
{
  if (face.size() < 4)
  {
    return false;
  }
  const auto vertex = [&](std::size_t i)
  {
    const auto& v = mesh.Vertices[static_cast<std::size_t>(face[i % face.size()][0])];
    return std::array<double, 3>{ v[0], v[1], v[2] };
  };
  std::vector<std::array<double, 3>> turns;
  std::array<double, 3> normal{};
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    std::array<double, 3> a, b, turn, area;
    const auto here = vertex(i), next = vertex(i + 1), after = vertex(i + 2), first = vertex(0);
    vtkMath::Subtract(next.data(), here.data(), a.data());
    vtkMath::Subtract(after.data(), next.data(), b.data());
    vtkMath::Cross(a.data(), b.data(), turn.data());
    turns.push_back(turn);
    vtkMath::Subtract(here.data(), first.data(), b.data());
    vtkMath::Cross(b.data(), a.data(), area.data());
    vtkMath::Add(normal.data(), area.data(), normal.data());
  }
  return std::any_of(turns.begin(), turns.end(),
    [&normal](const std::array<double, 3>& turn)
    {
      const double along = vtkMath::Dot(turn.data(), normal.data());
      return along < 0.0 &&
        along * along >
        1e-6 * vtkMath::Dot(turn.data(), turn.data()) * vtkMath::Dot(normal.data(), normal.data());
    });
}

/** The triangles of faces, by ears where faces are concave. */
vtkSmartPointer<vtkCellArray> Triangulate(vtkPoints* points, vtkCellArray* faces)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(points);
  polygons->SetPolys(faces);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(polygons);
  triangles->Update();
  return triangles->GetOutput()->GetPolys();
}

/** Makes points of corners, each once. */
class PiecePoints
{
public:
  PiecePoints(const ObjMesh& mesh, const ObjPiece& piece)
    : Mesh(mesh)
    , HasTexture(EachFaceHas(piece, 1))
    , HasNormals(EachFaceHas(piece, 2))
  {
  }

  vtkSmartPointer<vtkCellArray> Add(const std::vector<std::vector<ObjPiece::Corner>>& cells)
  {
    auto made = vtkSmartPointer<vtkCellArray>::New();
    for (const std::vector<ObjPiece::Corner>& cell : cells)
    {
      made->InsertNextCell(static_cast<int>(cell.size()));
      for (const ObjPiece::Corner& corner : cell)
      {
        made->InsertCellPoint(this->PointOf(corner));
      }
    }
    return made;
  }

  void GiveTo(vtkPolyData* geometry) const
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Gather("Points", 0, this->Mesh.Vertices));
    geometry->SetPoints(points);
    if (this->HasTexture)
    {
      geometry->GetPointData()->SetTCoords(
        this->Gather("TextureCoordinates", 1, this->Mesh.TextureVertices));
    }
    if (this->HasNormals)
    {
      geometry->GetPointData()->SetNormals(this->Gather("Normals", 2, this->Mesh.Normals));
    }
    if (!this->Mesh.Colors.empty())
    {
      geometry->GetPointData()->SetScalars(this->Gather("Colors", 0, this->Mesh.Colors));
    }
  }

private:
  static bool EachFaceHas(const ObjPiece& piece, std::size_t index)
  {
    const auto has = [index](const std::vector<ObjPiece::Corner>& cell)
    {
      return std::all_of(cell.begin(), cell.end(),
        [index](const ObjPiece::Corner& corner) { return corner[index] >= 0; });
    };
    return !piece.Faces.empty() && std::all_of(piece.Faces.begin(), piece.Faces.end(), has);
  }

  vtkIdType PointOf(ObjPiece::Corner corner)
  {
    corner[1] = this->HasTexture ? corner[1] : -1;
    corner[2] = this->HasNormals ? corner[2] : -1;
    const auto [found, isNew] =
      this->Numbers.try_emplace(corner, static_cast<vtkIdType>(this->Used.size()));
    if (isNew)
    {
      this->Used.push_back(corner);
    }
    return found->second;
  }

  /** Values of the used corners. Corners of lines and points may have none, which is 0. */
  template <std::size_t N>
  vtkSmartPointer<vtkFloatArray> Gather(
    const char* name, std::size_t index, const std::vector<std::array<float, N>>& values) const
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(N));
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Used.size()));
    float* next = array->GetPointer(0);
    for (const ObjPiece::Corner& corner : this->Used)
    {
      const std::array<float, N> value = corner[index] < 0
        ? std::array<float, N>{}
        : values[static_cast<std::size_t>(corner[index])];
      next = std::copy(value.begin(), value.end(), next);
    }
    return array;
  }

  const ObjMesh& Mesh;
  bool HasTexture;
  bool HasNormals;
  std::map<ObjPiece::Corner, vtkIdType> Numbers;
  std::vector<ObjPiece::Corner> Used;
};
}

ObjMesh ReadObjMesh(const std::string& path, const std::string& bytes)
{
  ObjScanner scanner;
  for (ObjLines lines(path, bytes); lines.Next();)
  {
    scanner.Take(lines.Line());
  }
  return scanner.Finish(path);
}

vtkSmartPointer<vtkPolyData> MakePolyData(const ObjMesh& mesh, const ObjPiece& piece)
{
  auto geometry = vtkSmartPointer<vtkPolyData>::New();
  PiecePoints points(mesh, piece);
  geometry->SetVerts(points.Add(piece.Points));
  geometry->SetLines(points.Add(piece.Lines));
  geometry->SetPolys(points.Add(piece.Faces));
  points.GiveTo(geometry);
  const bool hasConcave = std::any_of(piece.Faces.begin(), piece.Faces.end(),
    [&mesh](const std::vector<ObjPiece::Corner>& face) { return IsConcave(mesh, face); });
  if (hasConcave)
  {
    geometry->SetPolys(Triangulate(geometry->GetPoints(), geometry->GetPolys()));
  }
  return geometry;
}

}
