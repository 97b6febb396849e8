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
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTypeInt32Array.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace vitrine
{

namespace
{

/** How a part looks as it is drawn. */
struct PartLook
{
  bool IsVisible;
  double Opacity;
  std::array<double, 3> Color;
};

vtkCompositeDataDisplayAttributes* AttributesOf(vtkActor* actor)
{
  auto* const mapper = vtkCulledCompositePolyDataMapper::SafeDownCast(actor->GetMapper());
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}

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

/** Returns when the looks or places of the parts of an actor, which shows `data`, changed last. */
vtkMTimeType LooksTimeOf(vtkActor* actor, vtkDataObject* data)
{
  vtkMTimeType newest =
    std::max(actor->GetProperty()->GetMTime(), actor->GetShaderProperty()->GetMTime());
  if (vtkCompositeDataDisplayAttributes* const attributes = AttributesOf(actor))
  {
    newest = std::max(newest, attributes->GetMTime());
  }
  if (data)
  {
    newest = std::max(newest, data->GetMTime());
  }
  if (vtkMatrix4x4* const matrix = actor->GetUserMatrix())
  {
    newest = std::max(newest, matrix->GetMTime());
  }
  return newest;
}

/** Returns true if an actor is drawn as assemblies make it, but for the looks of its parts. */
bool IsAsMade(vtkActor* actor)
{
  const auto isAll = [](const double* numbers, double value)
  { return numbers[0] == value && numbers[1] == value && numbers[2] == value; };
  vtkMapper* const mapper = actor->GetMapper();
  vtkPolyData* const alone = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return isAll(actor->GetPosition(), 0) && isAll(actor->GetOrientation(), 0) &&
    isAll(actor->GetScale(), 1) && !actor->GetTexture() && !actor->GetBackfaceProperty() &&
    actor->GetProperty()->GetNumberOfTextures() == 0 &&
    actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0 &&
    (!mapper->GetClippingPlanes() || mapper->GetClippingPlanes()->GetNumberOfItems() == 0) &&
    (!mapper->GetScalarVisibility() || (alone && HasColors(alone)));
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
    this->FindReplaced();
    std::map<LookKey, std::vector<int>> merged;
    for (int part = 0; part < this->Parts.Count(); ++part)
    {
      const DrawnPlace& place = this->Parts.Place(part);
      if (!this->IsReplaced[place.Actor])
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
  void FindReplaced()
  {
    for (const vtkSmartPointer<vtkActor>& actor : this->Parts.Actors())
    {
      this->Made.States.push_back(StateOf(actor));
      const ActorState& state = this->Made.States.back();
      this->Made.LooksTime = std::max(this->Made.LooksTime, LooksTimeOf(actor, state.Data));
      this->IsReplaced[actor] = state.IsPlain;
    }
    for (int part = 0; part < this->Parts.Count(); ++part)
    {
      vtkPolyData* const geometry = this->Parts.Part(part).Geometry;
      if (!this->Details(geometry))
      {
        this->IsReplaced[this->Parts.Place(part).Actor] = false;
      }
    }
    for (ActorState& state : this->Made.States)
    {
      state.IsReplaced = this->IsReplaced[state.Actor];
    }
  }

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
      group.Pieces.push_back(this->PieceOf(part, static_cast<std::uint32_t>(first), true));
      first += own;
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
  std::unordered_map<vtkActor*, bool> IsReplaced;
};

CoarseActors::CoarseActors(const DrawnParts& parts, const DetailOf& detailOf)
{
  Builder(*this, parts, detailOf).Build();
}

bool CoarseActors::AreOutdated(const DrawnParts& parts) const
{
  const auto& actors = parts.Actors();
  return !std::equal(actors.begin(), actors.end(), this->States.begin(), this->States.end(),
    [&](vtkActor* actor, const ActorState& state)
    {
      if (state.IsUntouched())
      {
        return LooksTimeOf(actor, state.Data) <= this->LooksTime;
      }
      const ActorState now = StateOf(actor);
      return now == state && LooksTimeOf(actor, now.Data) <= this->LooksTime;
    });
}

CoarseActors::ActorState CoarseActors::StateOf(vtkActor* actor)
{
  vtkMapper* const mapper = actor->GetMapper();
  return { actor, actor->vtkObject::GetMTime(), mapper, mapper->vtkObject::GetMTime(),
    mapper->GetInputDataObject(0, 0), actor->GetProperty(), actor->GetVisibility() != 0,
    IsAsMade(actor) };
}

bool CoarseActors::ActorState::IsUntouched() const
{
  return this->Actor->vtkObject::GetMTime() == this->Time &&
    this->Actor->GetMapper() == this->Mapper &&
    this->Mapper->vtkObject::GetMTime() == this->MapperTime;
}

/** Shows or hides the actor for a part of a frame, which is no change of it. */
void CoarseActors::ActorState::Show(bool isShown)
{
  const bool isUntouched = this->IsUntouched();
  this->Actor->SetVisibility(isShown);
  this->Time = isUntouched ? this->Actor->vtkObject::GetMTime() : this->Time;
}

bool CoarseActors::AreReplacedIn(vtkRenderer* renderer) const
{
  return std::all_of(this->States.begin(), this->States.end(),
    [&](const ActorState& state)
    { return !state.IsReplaced || state.Actor->IsConsumer(renderer); });
}

void CoarseActors::BeginFrame(const std::unordered_set<vtkProp*>& exact, StandIns& standIns)
{
  for (ActorState& state : this->States)
  {
    if (state.IsReplaced && state.IsVisible && exact.count(state.Actor) == 0)
    {
      state.Show(false);
      standIns.Hidden.insert(state.Actor);
    }
  }
  for (vtkActor* const actor : this->Drawn)
  {
    actor->VisibilityOn();
    standIns.Shown.insert(actor);
  }
}

void CoarseActors::EndFrame(const StandIns& standIns)
{
  for (ActorState& state : this->States)
  {
    if (standIns.Hidden.count(state.Actor) > 0)
    {
      state.Show(true);
    }
  }
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
      ChooseLevels(group.Pieces, asked);
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
      const double length = LengthFor(piece, asked);
      if (!this->IsChosen || !piece.IsRightFor(asked, length))
      {
        return false;
      }
      if (piece.By == Piece::LEVEL)
      {
        drawn += piece.Triangles();
        needed += piece.Corners(piece.CoarsestFor(asked, 0.9 * length)).size() / 3;
      }
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
  for (const Piece& piece : group.Pieces)
  {
    if (piece.By != Piece::LEVEL)
    {
      continue;
    }
    const std::vector<std::uint32_t>& from = piece.Corners(piece.Level);
    for (std::size_t i = 0; i < from.size(); i += 3)
    {
      *corner++ = static_cast<vtkTypeInt32>(piece.First + from[i]);
      *corner++ = static_cast<vtkTypeInt32>(piece.First + from[i + (piece.IsMirrored ? 2 : 1)]);
      *corner++ = static_cast<vtkTypeInt32>(piece.First + from[i + (piece.IsMirrored ? 1 : 2)]);
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
