#include "section/Interference.h"

#include "Core/section/PartSums.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <cstddef>
#include <optional>

namespace vitrine
{

void DrawnSums::Keep(const CutParts& parts, const std::vector<CutPlane>& planes)
{
  this->Planes = planes;
  this->Generation = parts.Generation();
  if (this->Changes != parts.Changes())
  {
    this->Changes = parts.Changes();
    this->Parts = parts.Parts();
  }
}

namespace
{

/** Calls `visit` with each different sum of several parts of a plane, and a point of the plane where it stands. */
template <class Visit>
void ForEachInterference(
  CutSums& sums, std::size_t plane, const CutPlane& cutPlane, const Visit& visit)
{
  const CutSums::Pixels pixels = sums.Read(static_cast<int>(plane));
  const glm::dmat4 toWorld = glm::inverse(sums.ToClip());
  const CutPlane inClip = cutPlane.In(toWorld);
  std::set<PartSum> seen;
  for (std::size_t i = 0; i < pixels.Sums.size(); ++i)
  {
    const PartSum& sum = pixels.Sums[i];
    if (IsOfOnePart(sum) || !seen.insert(sum).second)
    {
      continue;
    }
    const auto width = static_cast<std::size_t>(pixels.Width);
    const double x = (static_cast<double>(i % width) + 0.5) / pixels.Width * 2.0 - 1.0;
    const double y = (static_cast<double>(i / width) + 0.5) / pixels.Height * 2.0 - 1.0;
    const double z = -(inClip.Normal.x * x + inClip.Normal.y * y + inClip.Offset) / inClip.Normal.z;
    const glm::dvec4 point = toWorld * glm::dvec4(x, y, z, 1.0);
    visit(sum, glm::dvec3(point) / point.w);
  }
}

/** The closed parts that may contain a point of a plane, by their boxes. */
std::vector<const CutPart*> CandidatesAt(
  const std::vector<CutPart>& parts, std::size_t plane, const glm::dvec3& point)
{
  std::vector<const CutPart*> candidates;
  for (const CutPart& part : parts)
  {
    const glm::dvec3 reach = 1e-3 * (part.Max - part.Min);
    const bool hasPoint = glm::all(glm::lessThanEqual(part.Min - reach, point)) &&
      glm::all(glm::lessThanEqual(point, part.Max + reach));
    if (part.IsClosed && (part.Cuts >> plane & 1u) != 0 && hasPoint)
    {
      candidates.push_back(&part);
    }
  }
  return candidates;
}

/** Finds the parts of a sum at a point: a few, or those that contain the point but for a few that end there. */
std::optional<PartSlots> PartsAt(const PartSum& sum, const glm::dvec3& point,
  const std::vector<const CutPart*>& candidates, const CutParts* geometry)
{
  PartSlots known;
  for (const CutPart* const part : candidates)
  {
    known.insert(part->Slot);
  }
  const std::optional<PartSlots> few = PartsOf(sum, known);
  if (few || !geometry)
  {
    return few;
  }
  PartSlots inside;
  for (const CutPart* const part : candidates)
  {
    if (geometry->Contains(*part, point))
    {
      inside.insert(part->Slot);
    }
  }
  return PartsNear(sum, inside, known);
}
}

Interference FindInterference(CutSums& sums, const CutParts& parts, const DrawnSums& drawn)
{
  const CutParts* const geometry = drawn.Generation == parts.Generation() ? &parts : nullptr;
  Interference found;
  for (std::size_t plane = 0; plane < drawn.Planes.size(); ++plane)
  {
    ForEachInterference(sums, plane, drawn.Planes[plane],
      [&](const PartSum& sum, const glm::dvec3& point)
      {
        const std::optional<PartSlots> slots =
          PartsAt(sum, point, CandidatesAt(drawn.Parts, plane, point), geometry);
        found.IsComplete = found.IsComplete && slots;
        for (const std::uint32_t a : slots ? *slots : PartSlots())
        {
          for (auto b = slots->upper_bound(a); b != slots->end(); ++b)
          {
            found.Pairs.insert({ a, *b });
          }
        }
      });
  }
  return found;
}

}
