#include "scene/files/FileReaders.h"

#include "Core/assembly/UniqueNames.h"
#include "Errors.h"
#include "scene/files/FileBytes.h"
#include "scene/files/threemf/ThreeMfModel.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace program
{

namespace
{
const std::size_t MostUses = 200000; // of objects; a few components can multiply to any number
const std::size_t MostDepth = 256;   // of components in components
const double PlainColor[3] = { 0.8, 0.8, 0.8 };

/** Triangles of an object in one colour, or with colours at their corners. */
struct Piece
{
  std::optional<ThreeMfColor> Color; ///< none where no colour is said
  bool HasCornerColors = false;
  bool IsTranslucent = false; ///< by the colours at corners
  vtkSmartPointer<vtkPolyData> Geometry;
};

/** Collects triangles of one look. */
class PieceBuilder
{
public:
  void Add(const ThreeMfObject& object, const ThreeMfTriangle& triangle)
  {
    this->Triangles->InsertNextCell(3);
    for (const std::uint32_t corner : triangle.Corners)
    {
      const auto [found, isNew] =
        this->Numbers.try_emplace(corner, this->Points->GetNumberOfPoints());
      if (isNew)
      {
        this->Points->InsertNextPoint(object.Vertices[corner].data());
      }
      this->Triangles->InsertCellPoint(found->second);
    }
  }

  /** Points of triangles with colours at their corners are not shared. */
  void Add(const ThreeMfObject& object, const ThreeMfTriangle& triangle,
    const std::array<ThreeMfColor, 3>& colors)
  {
    this->Triangles->InsertNextCell(3);
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Triangles->InsertCellPoint(
        this->Points->InsertNextPoint(object.Vertices[triangle.Corners[i]].data()));
      this->CornerColors.push_back(colors[i].Rgba);
    }
  }

  Piece Finish(const std::optional<ThreeMfColor>& color) const
  {
    Piece piece;
    piece.Color = color;
    piece.HasCornerColors = !this->CornerColors.empty();
    piece.Geometry = vtkSmartPointer<vtkPolyData>::New();
    piece.Geometry->SetPoints(this->Points);
    piece.Geometry->SetPolys(this->Triangles);
    if (piece.HasCornerColors)
    {
      piece.IsTranslucent = std::any_of(this->CornerColors.begin(), this->CornerColors.end(),
        [](const std::array<std::uint8_t, 4>& rgba) { return rgba[3] < 255; });
      piece.Geometry->GetPointData()->SetScalars(this->MakeColors(piece.IsTranslucent ? 4 : 3));
    }
    return piece;
  }

private:
  vtkSmartPointer<vtkUnsignedCharArray> MakeColors(int components) const
  {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetName("colors");
    colors->SetNumberOfComponents(components);
    colors->SetNumberOfTuples(static_cast<vtkIdType>(this->CornerColors.size()));
    std::uint8_t* next = colors->GetPointer(0);
    for (const std::array<std::uint8_t, 4>& rgba : this->CornerColors)
    {
      next = std::copy(rgba.begin(), rgba.begin() + components, next);
    }
    return colors;
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  std::map<std::uint32_t, vtkIdType> Numbers; ///< points by vertices
  std::vector<std::array<std::uint8_t, 4>> CornerColors;
};

/** The colour of a corner, or none. Groups of other kinds are not shown. */
std::optional<ThreeMfColor> ColorAt(
  const std::string& path, const ThreeMfModel& model, int group, int number)
{
  const auto found = model.Groups.find(group);
  if (found == model.Groups.end())
  {
    return std::nullopt;
  }
  if (number < 0 || number >= static_cast<int>(found->second.size()))
  {
    throw InputError(path,
      "is damaged: group " + std::to_string(group) + " has no colour " + std::to_string(number));
  }
  return found->second[static_cast<std::size_t>(number)];
}

std::vector<Piece> MakePieces(
  const std::string& path, const ThreeMfModel& model, const ThreeMfObject& object)
{
  std::map<std::optional<ThreeMfColor>, PieceBuilder> plain;
  PieceBuilder varied;
  bool hasVaried = false;
  for (const ThreeMfTriangle& triangle : object.Triangles)
  {
    std::array<std::optional<ThreeMfColor>, 3> colors;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const bool isOwn = triangle.Group != NoGroup;
      colors[i] = ColorAt(path, model, isOwn ? triangle.Group : object.Group,
        isOwn ? triangle.Colors[i] : object.Color);
    }
    const auto differs = [&](std::size_t i)
    { return colors[i] && colors[i]->Rgba != colors[0]->Rgba; };
    if (colors[0] && (differs(1) || differs(2)))
    {
      varied.Add(object, triangle, { *colors[0], *colors[1], *colors[2] });
      hasVaried = true;
    }
    else
    {
      plain[colors[0]].Add(object, triangle);
    }
  }
  std::vector<Piece> pieces;
  for (const auto& [color, builder] : plain)
  {
    pieces.push_back(builder.Finish(color));
  }
  if (hasVaried)
  {
    pieces.push_back(varied.Finish(std::nullopt));
  }
  return pieces;
}

vtkSmartPointer<vtkMatrix4x4> MakeMatrix(const ThreeMfTransform& transform)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(column, row, transform[static_cast<std::size_t>(3 * row + column)]);
    }
  }
  return matrix;
}

std::string NameOf(const ThreeMfColor& color)
{
  if (!color.Name.empty())
  {
    return color.Name;
  }
  char text[10];
  std::snprintf(text, sizeof text, "#%02X%02X%02X%02X", color.Rgba[0], color.Rgba[1], color.Rgba[2],
    color.Rgba[3]);
  return text;
}

/** Follows what is built through its components, and makes parts of it. */
class SceneBuilder
{
public:
  explicit SceneBuilder(const std::string& path)
    : Path(path)
    , Archive(path, ReadBytes(path))
  {
  }

  Scene Build()
  {
    const std::string first = FindThreeMfModel(this->Path, this->Archive);
    const ThreeMfModel& model = this->ModelOf(first);
    const double scale = model.MetersPerUnit;
    this->Result.LengthUnit = model.LengthUnit;
    vtkNew<vtkMatrix4x4> meters;
    for (int axis = 0; axis < 3; ++axis)
    {
      meters->SetElement(axis, axis, scale);
    }
    for (const ThreeMfUse& item : model.Items)
    {
      this->AddUse(item, first, meters, "");
    }
    DrawManyPartsAsBlocks(this->Result);
    for (const auto& [name, read] : this->Models)
    {
      this->Notes.insert(read.Notes.begin(), read.Notes.end());
    }
    this->Result.Notes.assign(this->Notes.begin(), this->Notes.end());
    this->Result.Placement.Up = { 0.0, 0.0, 1.0 };
    this->Result.Placement.Front = { 0.0, -1.0, 0.0 };
    return std::move(this->Result);
  }

private:
  using ObjectKey = std::pair<std::string, int>; ///< a model and an object of it

  const ThreeMfModel& ModelOf(const std::string& name)
  {
    const auto found = this->Models.find(name);
    return found != this->Models.end()
      ? found->second
      : this->Models.emplace(name, ReadThreeMfModel(this->Path, this->Archive, name)).first->second;
  }

  /** Adds an object of the model `from`, unless the use names another one. */
  void AddUse(const ThreeMfUse& use, const std::string& from, vtkMatrix4x4* parentPlace,
    const std::string& parentPath)
  {
    const ObjectKey key = { use.Model.empty() ? from : use.Model, use.Object };
    const ThreeMfModel& model = this->ModelOf(key.first);
    const auto found = model.Objects.find(use.Object);
    if (found == model.Objects.end())
    {
      throw InputError(this->Path,
        "is damaged: it refers to object " + std::to_string(use.Object) + ", which '" + key.first +
          "' does not have");
    }
    const bool isOpen = std::find(this->Open.begin(), this->Open.end(), key) != this->Open.end();
    if (isOpen || this->Open.size() >= MostDepth || ++this->Uses > MostUses)
    {
      throw InputError(this->Path,
        isOpen ? "is damaged: object " + std::to_string(use.Object) + " is a component of itself"
               : "has more components than can be drawn");
    }
    const ThreeMfObject& object = found->second;
    auto place = vtkSmartPointer<vtkMatrix4x4>::New();
    vtkMatrix4x4::Multiply4x4(parentPlace, MakeMatrix(use.Transform), place);
    const std::string name = !object.Name.empty() ? object.Name
      : !use.Name.empty()                         ? use.Name
                                                  : "object-" + std::to_string(use.Object);
    const std::string path = parentPath + PathStep(name);
    this->AddParts(key, model, object, name, path, place);
    this->Open.push_back(key);
    for (const ThreeMfUse& component : object.Components)
    {
      this->AddUse(component, key.first, place, path);
    }
    this->Open.pop_back();
  }

  void AddParts(const ObjectKey& key, const ThreeMfModel& model, const ThreeMfObject& object,
    const std::string& name, const std::string& path, const vtkSmartPointer<vtkMatrix4x4>& place)
  {
    auto [made, isNew] = this->Pieces.try_emplace(key);
    if (isNew)
    {
      made->second = MakePieces(this->Path, model, object);
    }
    for (const Piece& piece : made->second)
    {
      Part part;
      part.Name = name;
      part.MaterialName = piece.Color ? NameOf(*piece.Color) : "";
      const std::string step = made->second.size() == 1 ? ""
        : piece.Color                                   ? PathStep(part.MaterialName)
        : piece.HasCornerColors                         ? "/colors"
                                                        : "/plain";
      part.Path = this->Paths.Make(path + step);
      part.Geometry = piece.Geometry;
      part.Material = this->MaterialOf(piece.Color);
      part.Transform = place;
      part.ForceTranslucent = piece.IsTranslucent;
      this->Result.Parts.push_back(part);
    }
  }

  vtkSmartPointer<vtkProperty> MaterialOf(const std::optional<ThreeMfColor>& color)
  {
    vtkSmartPointer<vtkProperty>& material = this->Materials[color];
    if (!material)
    {
      material = vtkSmartPointer<vtkProperty>::New();
      material->SetColor(PlainColor[0], PlainColor[1], PlainColor[2]);
      if (color)
      {
        const std::array<std::uint8_t, 4>& rgba = color->Rgba;
        material->SetColor(rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0);
        material->SetOpacity(rgba[3] / 255.0);
      }
    }
    return material;
  }

  const std::string& Path;
  ZipArchive Archive;
  Scene Result;
  std::map<std::string, ThreeMfModel> Models;
  std::map<ObjectKey, std::vector<Piece>> Pieces;
  std::map<std::optional<ThreeMfColor>, vtkSmartPointer<vtkProperty>> Materials;
  vitrine::UniqueNames Paths;
  std::set<std::string> Notes;
  std::vector<ObjectKey> Open; ///< objects whose components are being followed
  std::size_t Uses = 0;
};
}

Scene ReadThreeMfFile(const std::string& path)
{
  return SceneBuilder(path).Build();
}

}
