// Parts with faces that are seen from their edge, whose depth on a device is unknown.
#include "culling/SceneParts.h"

#include "Core/culling/BoxLanes.h"
#include "Core/culling/ScreenProjection.h"
#include "culling/PartChunks.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

namespace
{

// Of what rasterisers snap by, 1/256 pixel. What they draw of a thinner face may have any depth: snapped corners lie beside it, where its plane is as steep as it is thin.
const double ThinnestFace = 1.0;

/** The longest that an axis becomes, squared. */
double LongestAxisOf(const glm::dmat4& m)
{
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  return std::max({ glm::dot(x, x), glm::dot(y, y), glm::dot(z, z) });
}

/** Whether axes stay at right angles, but for what doubles round. */
bool IsOrthogonal(const glm::dmat4& m)
{
  const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
  const double most = 1e-9 * LongestAxisOf(m);
  return std::abs(glm::dot(x, y)) <= most && std::abs(glm::dot(y, z)) <= most &&
    std::abs(glm::dot(z, x)) <= most;
}

/** How much longer a model transform may make some lengths than others, squared. No length becomes longer than the three axes together. */
double UnevennessOf(const glm::dmat4& toWorld, const glm::dmat4& fromWorld)
{
  const double most = IsOrthogonal(toWorld) ? 1.0 : 9.0;
  return most * LongestAxisOf(toWorld) * LongestAxisOf(glm::transpose(fromWorld));
}

/**
 * Collects numbers below a count in threads.
 * @param find  adds those from a first one up to an end to a list; of several chunks at a time
 * @returns     all of them, in order
 */
template <class Find>
std::vector<std::uint32_t> FindInThreads(std::size_t count, const Find& find)
{
  const PartChunks chunks(count);
  std::vector<std::vector<std::uint32_t>> ofChunks(chunks.Count());
  chunks.ForEach([&](std::size_t chunk, std::size_t first, std::size_t end)
    { find(first, end, ofChunks[chunk]); });
  std::vector<std::uint32_t> found;
  for (const std::vector<std::uint32_t>& ofChunk : ofChunks)
  {
    found.insert(found.end(), ofChunk.begin(), ofChunk.end());
  }
  return found;
}

/** Finds parts whose boxes lie in the view, and may have samples, eight at a time. Where lines are drawn, the view's boxes grow by a pixel and more, so that all have. */
class ViewFilter
{
public:
  ViewFilter(
    const ScreenProjection& view, const SampleGrid& samples, std::vector<std::uint32_t>& found)
    : View(view)
    , Samples(samples)
    , Found(found)
  {
  }

  void Add(std::uint32_t part, const Box& box)
  {
    this->Boxes.Set(this->Count, box);
    this->Parts[this->Count++] = part;
    if (this->Count == LaneCount)
    {
      this->Flush();
    }
  }

  /** Looks at those that are left. */
  void Flush()
  {
    RectangleLanes rectangles;
    this->View.Project(this->Boxes, rectangles);
    const unsigned mayShow =
      ~rectangles.Outside & (rectangles.Near | rectangles.MayHaveAny(this->Samples));
    for (int lane = 0; lane < this->Count; ++lane)
    {
      if ((mayShow >> lane & 1u) != 0)
      {
        this->Found.push_back(this->Parts[lane]);
      }
    }
    this->Count = 0;
  }

private:
  const ScreenProjection& View;
  const SampleGrid& Samples;
  std::vector<std::uint32_t>& Found;
  BoxLanes Boxes;
  std::uint32_t Parts[LaneCount];
  int Count = 0;
};
}

void SceneParts::ShowEdgeOn(PartCuller& culler, const ScreenProjection& view,
  const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible)
{
  std::vector<std::uint32_t> hidden =
    this->FindHiddenInView(view, culler.Samples(), drawn, visible);
  const auto firstWireframe = std::partition(
    hidden.begin(), hidden.end(), [this](std::uint32_t i) { return !this->Parts[i].IsWireframe; });
  std::for_each(firstWireframe, hidden.end(), [&](std::uint32_t i) { visible[i] = 1; });
  hidden.erase(firstWireframe, hidden.end());
  for (const std::uint32_t i : hidden)
  {
    this->Parts[i].Geometry->Planes(this->Parts[i].Data); // built here, not by several threads
  }
  const std::vector<std::uint32_t> edgeOn = this->FindEdgeOn(view, hidden);
  std::vector<PartCuller::BoxedPart> parts;
  for (const std::uint32_t i : edgeOn)
  {
    parts.push_back({ this->ShapeOf(i), this->BoxOf[i] });
  }
  const std::vector<std::uint8_t> hides = culler.HideThinFacesOf(parts, view);
  for (std::size_t i = 0; i < edgeOn.size(); ++i)
  {
    visible[edgeOn[i]] = hides[i] ? 0 : 1;
  }
}

/** Parts that are drawn, were found hidden, and may have samples in the view. */
std::vector<std::uint32_t> SceneParts::FindHiddenInView(const ScreenProjection& view,
  const SampleGrid& samples, const std::vector<std::uint8_t>& drawn,
  const std::vector<std::uint8_t>& visible) const
{
  return FindInThreads(visible.size(),
    [&](std::size_t first, std::size_t end, std::vector<std::uint32_t>& found)
    {
      ViewFilter filter(view, samples, found);
      for (std::size_t i = first; i < end; ++i)
      {
        if (drawn[i] && !visible[i] && this->Parts[i].Geometry)
        {
          filter.Add(static_cast<std::uint32_t>(i), this->BoxOf[i]);
        }
      }
      filter.Flush();
    });
}

/** Of some parts those with a face that the eye sees from its edge. Their planes are known. */
std::vector<std::uint32_t> SceneParts::FindEdgeOn(
  const ScreenProjection& view, const std::vector<std::uint32_t>& of) const
{
  const glm::dvec4 eye = view.Eye();
  const double thickness = ThinnestFace *
    static_cast<double>(std::min(view.Snapping().Column, view.Snapping().Line)) /
    view.LargestScale();
  return FindInThreads(of.size(),
    [&](std::size_t first, std::size_t end, std::vector<std::uint32_t>& found)
    {
      for (std::size_t i = first; i < end; ++i)
      {
        const Part& part = this->Parts[of[i]];
        if (part.Geometry->Planes(part.Data).IsAnyEdgeOn(
              part.FromWorld * eye, thickness * UnevennessOf(part.ToWorld, part.FromWorld)))
        {
          found.push_back(of[i]);
        }
      }
    });
}

}
