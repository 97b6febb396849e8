#include "Core/measure/PenetrationDepth.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace vitrine
{

namespace
{

/** Where the surface of one part is in the solid of another, and how deep. */
class WitnessSearch
{
public:
  /**
   * @param places  the meetings of `part`'s triangles, ordered by triangles
   */
  WitnessSearch(const PlacedPart& part, const PlacedPart& solid,
    std::vector<std::pair<std::uint32_t, glm::dvec3>> places, DeepPoint& deepest)
    : Part(part)
    , Solid(solid)
    , Places(std::move(places))
    , Deepest(deepest)
  {
  }

  /** For surfaces that meet. */
  void Search()
  {
    this->Triangles = this->Part.TrianglesTouching(this->Solid.Bounds());
    this->JoinFreeTriangles();
    this->OfferCorners();
    this->OfferMeetingTriangles();
  }

  /** For surfaces that do not. */
  void SearchPieces(const std::vector<bool>& isInside)
  {
    const PartMesh& mesh = this->Part.Mesh();
    for (std::size_t i = 0; i < mesh.Points().size(); ++i)
    {
      if (isInside[mesh.PiecesOfPoints()[i]])
      {
        this->OfferInside(this->Part.ToWorld(mesh.Points()[i]));
      }
    }
  }

private:
  bool Meets(std::uint32_t triangle) const
  {
    const auto at = std::lower_bound(this->Places.begin(), this->Places.end(), triangle,
      [](const auto& place, std::uint32_t number) { return place.first < number; });
    return at != this->Places.end() && at->first == triangle;
  }

  /** Triangles that meet nothing and have a corner in common are on one side. */
  void JoinFreeTriangles()
  {
    for (const PlacedTriangle& triangle : this->Triangles)
    {
      const std::uint32_t* const corners = this->Part.Mesh().CornersOf(triangle.Item);
      std::array<std::size_t, 3> local;
      for (int k = 0; k < 3; ++k)
      {
        const auto [at, isNew] = this->Local.try_emplace(corners[k], this->Corners.size());
        if (isNew)
        {
          this->Corners.push_back({ triangle.Corners[k], this->Corners.size(), Sides::Unknown });
        }
        local[k] = at->second;
      }
      if (!this->Meets(triangle.Item))
      {
        this->Corners[this->RootOf(local[0])].Parent = this->RootOf(local[1]);
        this->Corners[this->RootOf(local[1])].Parent = this->RootOf(local[2]);
      }
    }
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      if (!this->Solid.Bounds().Contains(this->Corners[i].Place))
      {
        this->Corners[this->RootOf(i)].Side = Sides::Outside;
      }
    }
  }

  void OfferCorners()
  {
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      Corner& root = this->Corners[this->RootOf(i)];
      if (root.Side == Sides::Outside || this->IsShallow(this->Corners[i].Place))
      {
        continue;
      }
      if (root.Side == Sides::Unknown)
      {
        root.Side = this->Solid.Contains(this->Corners[i].Place) ? Sides::Inside : Sides::Outside;
      }
      if (root.Side == Sides::Inside)
      {
        this->OfferInside(this->Corners[i].Place);
      }
    }
  }

  void OfferMeetingTriangles()
  {
    std::vector<glm::dvec3> middles;
    for (std::size_t i = 0, end = 0; i < this->Places.size(); i = end)
    {
      const std::uint32_t item = this->Places[i].first;
      middles.clear();
      for (end = i; end < this->Places.size() && this->Places[end].first == item; ++end)
      {
        middles.push_back(this->Places[end].second);
      }
      const Triangle triangle = this->Part.TriangleAt(item);
      this->Offer((triangle[0] + triangle[1] + triangle[2]) / 3.0);
      for (int k = 0; k < 3; ++k)
      {
        this->Offer((triangle[k] + triangle[(k + 1) % 3]) / 2.0);
      }
      for (std::size_t a = 0; a < middles.size(); ++a)
      {
        this->Offer(middles[a]);
        for (const std::size_t b : NextMeetings(a, middles.size()))
        {
          this->Offer((middles[a] + middles[b]) / 2.0);
        }
      }
    }
  }

  bool IsShallow(const glm::dvec3& point) const
  {
    return this->Solid.HasWithin(point, this->Deepest.Depth);
  }

  void Offer(const glm::dvec3& point)
  {
    if (this->Solid.Bounds().Contains(point) && !this->IsShallow(point) &&
      this->Solid.Contains(point))
    {
      this->OfferInside(point);
    }
  }

  void OfferInside(const glm::dvec3& point)
  {
    if (this->IsShallow(point))
    {
      return;
    }
    if (const std::optional<NearPoint> near = this->Solid.Nearest(point);
        near && near->Distance > this->Deepest.Depth)
    {
      this->Deepest = { near->Distance, point };
    }
  }

  enum class Sides
  {
    Unknown,
    Inside,
    Outside
  };
  struct Corner
  {
    glm::dvec3 Place;
    std::size_t Parent;
    Sides Side; ///< of a root: of all that are joined
  };

  std::size_t RootOf(std::size_t i)
  {
    while (this->Corners[i].Parent != i)
    {
      this->Corners[i].Parent = this->Corners[this->Corners[i].Parent].Parent;
      i = this->Corners[i].Parent;
    }
    return i;
  }

  const PlacedPart& Part;
  const PlacedPart& Solid;
  std::vector<std::pair<std::uint32_t, glm::dvec3>> Places;
  DeepPoint& Deepest;
  std::vector<PlacedTriangle> Triangles;
  std::unordered_map<std::uint32_t, std::size_t> Local; ///< numbers in Corners
  std::vector<Corner> Corners;
};

void SearchWitnesses(const PlacedPart& part, const PlacedPart& solid,
  const std::vector<Meeting>& meetings, std::uint32_t Meeting::*side, DeepPoint& deepest)
{
  std::vector<std::pair<std::uint32_t, glm::dvec3>> places;
  for (const Meeting& meeting : meetings)
  {
    places.emplace_back(meeting.*side, meeting.Place);
  }
  std::stable_sort(
    places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  WitnessSearch(part, solid, std::move(places), deepest).Search();
}

void SearchInnerPoints(const PlacedPart& part, const PlacedPart& solid, DeepPoint& deepest)
{
  if (!part.IsClosed() || !solid.IsClosed())
  {
    return;
  }
  for (const InnerPoint& inner : part.Mesh().InnerPoints())
  {
    const double clearance = inner.Clearance * part.Scale();
    if (!(clearance > deepest.Depth))
    {
      return; // They are ordered.
    }
    const glm::dvec3 place = part.ToWorld(inner.Place);
    if (solid.Contains(place))
    {
      const std::optional<NearPoint> near = solid.Nearest(place);
      const double depth = near ? std::min(clearance, near->Distance) : 0.0;
      if (depth > deepest.Depth)
      {
        deepest = { depth, place };
      }
    }
  }
}

void SearchReach(const std::vector<Meeting>& meetings, DeepPoint& deepest)
{
  for (const Meeting& meeting : meetings)
  {
    if (meeting.ReachThrough > deepest.Depth)
    {
      deepest = { meeting.ReachThrough, meeting.Place };
    }
  }
}

}

std::vector<std::size_t> NextMeetings(std::size_t i, std::size_t count)
{
  std::vector<std::size_t> next;
  if (count <= 8)
  {
    next.resize(count - i - 1);
    std::iota(next.begin(), next.end(), i + 1);
    return next;
  }
  for (const std::size_t step : { count / 2, count / 3, count / 7 })
  {
    next.push_back((i + step) % count);
  }
  return next;
}

std::optional<DeepPoint> FindDepthOfMeeting(const PlacedPart& first, const PlacedPart& second,
  const std::vector<Meeting>& meetings, double above)
{
  DeepPoint deepest{ above, {} };
  SearchInnerPoints(first, second, deepest);
  SearchInnerPoints(second, first, deepest);
  if (second.IsClosed())
  {
    SearchWitnesses(first, second, meetings, &Meeting::First, deepest);
  }
  if (first.IsClosed())
  {
    SearchWitnesses(second, first, meetings, &Meeting::Second, deepest);
  }
  if (!first.IsClosed() && !second.IsClosed())
  {
    SearchReach(meetings, deepest);
  }
  return deepest.Depth > above ? std::optional<DeepPoint>(deepest) : std::nullopt;
}

PiecesInside FindPiecesInside(const PlacedPart& part, const PlacedPart& solid)
{
  PiecesInside pieces;
  const PartMesh& mesh = part.Mesh();
  if (!part.Bounds().Touches(solid.Bounds()) || !solid.IsClosed())
  {
    return pieces;
  }
  pieces.All = !mesh.Pieces().empty();
  for (const std::uint32_t triangle : mesh.Pieces())
  {
    const bool isInside = solid.Contains(part.ToWorld(mesh.Points()[*mesh.CornersOf(triangle)]));
    pieces.Inside.push_back(isInside);
    pieces.Any = pieces.Any || isInside;
    pieces.All = pieces.All && isInside;
  }
  return pieces;
}

std::optional<DeepPoint> FindDepthOfApart(const PlacedPart& first, const PlacedPart& second,
  const PiecesInside& firstInside, const PiecesInside& secondInside, double above)
{
  DeepPoint deepest{ above, {} };
  if (!firstInside.Any && !secondInside.Any)
  {
    return std::nullopt;
  }
  SearchInnerPoints(first, second, deepest);
  SearchInnerPoints(second, first, deepest);
  if (firstInside.Any)
  {
    WitnessSearch(first, second, {}, deepest).SearchPieces(firstInside.Inside);
  }
  if (secondInside.Any)
  {
    WitnessSearch(second, first, {}, deepest).SearchPieces(secondInside.Inside);
  }
  return deepest.Depth > above ? std::optional<DeepPoint>(deepest) : std::nullopt;
}

}
