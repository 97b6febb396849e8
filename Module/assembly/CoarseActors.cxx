#include "assembly/CoarseActors.h"

#include "assembly/PartLooks.h"
#include "assembly/PlacedGeometry.h"
#include "scene/Matrices.h"
#include "scene/PropertyCopy.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCulledCompositePolyDataMapper.h"
#include "vtkCulledPolyDataMapper.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace vitrine
{

namespace
{

/** Choices are a little finer than needed, so that they last for some frames. */
constexpr double ShareOfChoice = 0.9;

constexpr vtkIdType SpeckPoints = std::tuple_size<decltype(MeshSpeck::Corners)>::value;

/** How a part looks as it is drawn. */
struct PartLook
{
  bool IsVisible;
  double Opacity;
  std::array<double, 3> Color;
};

PartLook LookOf(const DrawnPlace& place)
{
  vtkProperty* const property = place.Actor->GetProperty();
  PartLook look{ place.Actor->GetVisibility() != 0, property->GetOpacity(), {} };
  property->GetColor(look.Color.data());
  vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(place.Actor);
  if (!place.Block || !attributes)
  {
    return look;
  }
  if (attributes->HasBlockVisibility(place.Block))
  {
    look.IsVisible = look.IsVisible && attributes->GetBlockVisibility(place.Block);
  }
  if (attributes->HasBlockOpacity(place.Block))
  {
    look.Opacity = attributes->GetBlockOpacity(place.Block);
  }
  if (attributes->HasBlockColor(place.Block))
  {
    attributes->GetBlockColor(place.Block, look.Color.data());
  }
  return look;
}

/** Returns by how much a matrix makes lengths longer, at most. */
double ScaleOf(const glm::dmat4& matrix)
{
  double rows[3][3], left[3][3], scales[3], right[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      rows[row][column] = matrix[column][row];
    }
  }
  vtkMath::SingularValueDecomposition3x3(rows, left, scales, right);
  return (1 + 1e-9) * std::max({ std::abs(scales[0]), std::abs(scales[1]), std::abs(scales[2]) });
}

/** Parts that may be one actor. */
using LookKey =
  std::tuple<vtkProperty*, vtkInformation*, bool, bool, double, std::array<double, 3>>;

}

/** Makes the actors of CoarseActors. */
class CoarseActors::Builder
{
public:
  Builder(CoarseActors& made, const DrawnParts& parts, const DetailOf& detailOf)
    : Made(made)
    , Parts(parts)
    , Details(detailOf)
  {
  }

  void Build()
  {
    std::map<LookKey, std::vector<int>> merged;
    for (int part = 0; part < this->Parts.Count(); ++part)
    {
      const DrawnPlace& place = this->Parts.Place(part);
      if (!this->Made.Replaced.Has(place.Actor))
      {
        continue;
      }
      const PartLook look = LookOf(place);
      const AddedPart& added = this->Parts.Part(part);
      if (!look.IsVisible)
      {
        continue;
      }
      if (!place.Block &&
        (HasColors(added.Geometry) || !IsFarForItsSize(added.Geometry, added.Place)))
      {
        this->AddAlone(part);
        continue;
      }
      merged[{ added.Property, added.Keys, added.IsTranslucent,
               added.Geometry->GetPointData()->GetNormals() != nullptr, look.Opacity, look.Color }]
        .push_back(part);
    }
    for (const auto& [key, parts] : merged)
    {
      this->AddMerged(parts);
    }
  }

private:
  /** @param isPlaced  its points in the actor are in WC */
  Piece PieceOf(int part, std::uint32_t first, bool isPlaced)
  {
    const AddedPart& added = this->Parts.Part(part);
    const DrawnPlace& place = this->Parts.Place(part);
    const glm::dmat4 matrix = added.Place ? MatrixOf(added.Place) : glm::dmat4(1.0);
    double bounds[6];
    added.Geometry->GetBounds(bounds);
    const glm::dvec3 low(bounds[0], bounds[2], bounds[4]);
    const glm::dvec3 high(bounds[1], bounds[3], bounds[5]);
    Piece piece;
    piece.Detail = this->Details(added.Geometry);
    piece.Own = place.Actor;
    piece.First = first;
    piece.IsMirrored = isPlaced && glm::determinant(glm::dmat3(matrix)) < 0;
    piece.Scale = ScaleOf(matrix);
    piece.Centre = glm::dvec3(matrix * glm::dvec4(0.5 * (low + high), 1.0)) + place.Offset;
    piece.Radius = 0.5 * piece.Scale * glm::length(high - low);
    piece.Rounding =
      std::numeric_limits<float>::epsilon() * (glm::length(piece.Centre) + piece.Radius);
    this->Made.Reach = std::max(this->Made.Reach, glm::length(piece.Centre) + piece.Radius);
    return piece;
  }

  /** Adds an actor for one part, with the points and the property that the part has. */
  void AddAlone(int part)
  {
    const DrawnPlace& place = this->Parts.Place(part);
    Group group;
    group.Data = vtkSmartPointer<vtkPolyData>::New();
    group.Data->SetPoints(this->Parts.Part(part).Geometry->GetPoints());
    group.Data->GetPointData()->ShallowCopy(this->Parts.Part(part).Geometry->GetPointData());
    group.Pieces.push_back(this->PieceOf(part, 0, false));
    this->AddActor(std::move(group), part, place.Actor->GetProperty());
    this->Made.Drawn.back()->SetUserMatrix(place.Actor->GetUserMatrix());
    this->Made.Drawn.back()->GetMapper()->SetScalarVisibility(
      place.Actor->GetMapper()->GetScalarVisibility());
  }

  /** Adds an actor for parts of one look, with points of its own in WC. */
  void AddMerged(const std::vector<int>& parts)
  {
    vtkIdType count = 0;
    for (const int part : parts)
    {
      count += this->Parts.Part(part).Geometry->GetNumberOfPoints();
      count += this->Details(this->Parts.Part(part).Geometry)->Speck ? SpeckPoints : 0;
    }
    const bool hasNormals =
      this->Parts.Part(parts.front()).Geometry->GetPointData()->GetNormals() != nullptr;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(3);
    places->SetNumberOfTuples(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(hasNormals ? count : 0);
    Group group;
    vtkIdType first = 0;
    for (const int part : parts)
    {
      const vtkSmartPointer<vtkPolyData> placed = this->Placed(part);
      const vtkIdType own = placed->GetNumberOfPoints();
      places->InsertTuples(first, own, 0, placed->GetPoints()->GetData());
      if (hasNormals)
      {
        normals->InsertTuples(first, own, 0, placed->GetPointData()->GetNormals());
      }
      Piece piece = this->PieceOf(part, static_cast<std::uint32_t>(first), true);
      first += own;
      first = this->AddSpeck(piece, part, first, places, normals);
      group.Pieces.push_back(std::move(piece));
    }
    vtkNew<vtkPoints> points;
    points->SetData(places);
    group.Data = vtkSmartPointer<vtkPolyData>::New();
    group.Data->SetPoints(points);
    if (hasNormals)
    {
      group.Data->GetPointData()->SetNormals(normals);
    }
    const DrawnPlace& place = this->Parts.Place(parts.front());
    const PartLook look = LookOf(place);
    const vtkSmartPointer<vtkProperty> property = CopyProperty(place.Actor->GetProperty());
    property->SetOpacity(look.Opacity);
    property->SetColor(look.Color[0], look.Color[1], look.Color[2]);
    this->AddActor(std::move(group), parts.front(), property);
  }

  /** Adds the points of a part's speck to those of its actor. */
  vtkIdType AddSpeck(
    Piece& piece, int part, vtkIdType first, vtkFloatArray* places, vtkFloatArray* normals) const
  {
    if (!piece.Detail->Speck)
    {
      return first;
    }
    const MeshSpeck& speck = *piece.Detail->Speck;
    vtkMatrix4x4* const place = this->Parts.Part(part).Place;
    const glm::dmat4 matrix = place ? MatrixOf(place) : glm::dmat4(1.0);
    const glm::dvec3 middle(matrix * glm::dvec4(speck.Middle, 1.0));
    piece.FirstOfSpeck = static_cast<std::uint32_t>(first);
    piece.BoundOfSpeck = piece.Rounding + piece.Scale * speck.Bound;
    const glm::dmat3 turn(matrix);
    const glm::dvec3 front = (piece.IsMirrored ? -1.0 : 1.0) *
      glm::cross(
        turn * (speck.Corners[1] - speck.Corners[0]), turn * (speck.Corners[2] - speck.Corners[0]));
    for (const glm::dvec3& corner : speck.Corners)
    {
      const glm::dvec3 moved(matrix * glm::dvec4(corner, 1.0));
      const glm::dvec3 point = moved + this->Parts.Place(part).Offset;
      const glm::dvec3 normal = glm::normalize(speck.IsSheet ? front : moved - middle);
      places->SetTuple(first, &point.x);
      if (normals->GetNumberOfTuples() > 0)
      {
        normals->SetTuple(first, &normal.x);
      }
      ++first;
    }
    return first;
  }

  /** Returns a part's geometry in WC. */
  vtkSmartPointer<vtkPolyData> Placed(int part) const
  {
    const DrawnPlace& place = this->Parts.Place(part);
    return place.Block ? place.Block
                       : PlaceGeometry(this->Parts.Part(part).Geometry, place.Actor->GetMatrix());
  }

  void AddActor(Group group, int part, vtkProperty* property)
  {
    const AddedPart& added = this->Parts.Part(part);
    vtkNew<vtkCulledPolyDataMapper> mapper;
    mapper->SetInputData(group.Data);
    mapper->SetColorModeToDirectScalars();
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    actor->SetForceTranslucent(added.IsTranslucent || property->GetOpacity() < 1.0);
    SetKeys(actor, added.Keys);
    actor->VisibilityOff();
    actor->PickableOff();
    this->Made.Drawn.push_back(actor);
    this->Made.Groups.push_back(std::move(group));
  }

  CoarseActors& Made;
  const DrawnParts& Parts;
  const DetailOf& Details;
};

CoarseActors::CoarseActors(const DrawnParts& parts, const DetailOf& detailOf)
  : Replaced(parts, [&](vtkPolyData* geometry) { return detailOf(geometry) != nullptr; })
{
  Builder(*this, parts, detailOf).Build();
}

void CoarseActors::BeginFrame(const std::unordered_set<vtkProp*>& exact, StandIns& standIns)
{
  this->Replaced.Hide(exact, standIns.Hidden);
  for (vtkActor* const actor : this->Drawn)
  {
    actor->VisibilityOn();
    standIns.Shown.insert(actor);
  }
}

void CoarseActors::EndFrame(const StandIns& standIns)
{
  this->Replaced.Show(standIns.Hidden);
  for (vtkActor* const actor : this->Drawn)
  {
    actor->VisibilityOff();
  }
}

void CoarseActors::Choose(LevelRequest asked)
{
  asked.Reach = this->Reach;
  if (!this->Fits(asked))
  {
    for (Group& group : this->Groups)
    {
      for (Piece& piece : group.Pieces)
      {
        piece.Choose(asked, LengthFor(piece, asked, ShareOfChoice));
      }
      Compose(group);
    }
    this->IsChosen = true;
  }
  this->Count(asked);
}

/** Returns true if the levels that were chosen before are neither too coarse nor much too fine. */
bool CoarseActors::Fits(const LevelRequest& asked) const
{
  std::size_t drawn = 0;
  std::size_t needed = 0;
  for (const Group& group : this->Groups)
  {
    for (const Piece& piece : group.Pieces)
    {
      if (!this->IsChosen || !piece.IsRightFor(asked, LengthFor(piece, asked)))
      {
        return false;
      }
      Piece best = piece;
      best.Choose(asked, LengthFor(piece, asked, ShareOfChoice));
      drawn += piece.Triangles();
      needed += best.Triangles();
    }
  }
  return 2 * drawn <= 3 * needed + 1000;
}

/** Has an actor draw what was chosen. */
void CoarseActors::Compose(Group& group)
{
  std::size_t count = 0;
  for (const Piece& piece : group.Pieces)
  {
    count += 3 * piece.Triangles();
  }
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(count));
  vtkNew<vtkTypeInt32Array> starts;
  starts->SetNumberOfValues(static_cast<vtkIdType>(count / 3 + 1));
  vtkTypeInt32* corner = corners->GetPointer(0);
  const auto add = [&](const auto& from, std::uint32_t first, bool isMirrored)
  {
    for (std::size_t i = 0; i < from.size(); i += 3)
    {
      *corner++ = static_cast<vtkTypeInt32>(first + from[i]);
      *corner++ = static_cast<vtkTypeInt32>(first + from[i + (isMirrored ? 2 : 1)]);
      *corner++ = static_cast<vtkTypeInt32>(first + from[i + (isMirrored ? 1 : 2)]);
    }
  };
  for (const Piece& piece : group.Pieces)
  {
    if (piece.By == Piece::SPECK)
    {
      add(TrianglesOf(*piece.Detail->Speck), piece.FirstOfSpeck, piece.IsMirrored);
    }
    else if (piece.By == Piece::LEVEL)
    {
      add(piece.Corners(piece.Level), piece.First, piece.IsMirrored);
    }
  }
  for (vtkIdType i = 0; i < starts->GetNumberOfValues(); ++i)
  {
    starts->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(starts, corners);
  group.Data->SetPolys(cells);
}

void CoarseActors::Count(const LevelRequest& asked)
{
  this->Chosen = {};
  for (const Group& group : this->Groups)
  {
    for (const Piece& piece : group.Pieces)
    {
      const std::size_t whole = piece.Detail->Whole.size() / 3;
      this->Chosen.WholeTriangles += whole;
      this->Chosen.Triangles += piece.By == Piece::OWN_PROP ? whole : piece.Triangles();
      const double pixel = LengthOfPixels(asked.View, 1.0, piece.Centre, piece.Radius);
      this->Chosen.GreatestPixels = std::max(this->Chosen.GreatestPixels, piece.Bound / pixel);
    }
  }
}

}
