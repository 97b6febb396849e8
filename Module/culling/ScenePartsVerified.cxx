// Verifies that parts are hidden wherever a device may draw them.
#include "culling/SceneParts.h"

#include "Core/culling/screen/ScreenProjection.h"
#include "Core/geometry/BoxLanes.h"
#include "culling/PartChunks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

namespace
{

/**
 * Finds parts whose boxes lie in the view and may have samples, eight at a time. Where lines are drawn, the view grows
 * boxes by more than a pixel, so that all have samples. A part that is drawn at other places than samples always
 * counts.
 */
class ViewFilter
{
public:
  ViewFilter(const ScreenProjection& view, const SampleGrid& samples, std::vector<BoxedPart>& found)
    : View(view)
    , Samples(samples)
    , Found(found)
  {
  }

  void Add(const BoxedPart& part, bool isDrawnApart)
  {
    this->Boxes.Set(this->Count, part.Bounds);
    this->Apart |= unsigned{ isDrawnApart } << this->Count;
    this->Parts[this->Count++] = part;
    if (this->Count == LaneCount)
    {
      this->Flush();
    }
  }

  /** Looks at the parts that are left. */
  void Flush()
  {
    RectangleLanes rectangles;
    this->View.Project(this->Boxes, rectangles);
    const unsigned mayShow =
      ~rectangles.Outside & (rectangles.Near | rectangles.MayHaveAny(this->Samples) | this->Apart);
    for (int lane = 0; lane < this->Count; ++lane)
    {
      if ((mayShow >> lane & 1u) != 0)
      {
        this->Found.push_back(this->Parts[lane]);
      }
    }
    this->Count = 0;
    this->Apart = 0;
  }

private:
  const ScreenProjection& View;
  const SampleGrid& Samples;
  std::vector<BoxedPart>& Found;
  BoxLanes Boxes;
  BoxedPart Parts[LaneCount];
  int Count = 0;
  unsigned Apart = 0; ///< a bit for each part that is drawn apart (ShapeSource)
};
}

/** Returns the geometry of parts, whether they hide others or not. */
class SceneParts::Shapes : public ShapeSource
{
public:
  Shapes(SceneParts& parts, const SampleGrid& samples)
    : Parts(parts)
    , Samples(samples)
  {
  }

  Occluder OccluderOf(std::uint32_t part) override { return this->Parts.ShapeOf(part); }

  PartPlanes PlanesOf(std::uint32_t part) override
  {
    const Part& known = this->Parts.Parts[part];
    return { &known.Geometry->Planes(known.Data), &known.ToWorld, &known.Drawn, &known.FromWorld };
  }

  const std::vector<MeshLine>& LinesOf(std::uint32_t part) override
  {
    const Part& known = this->Parts.Parts[part];
    return known.Geometry->Lines(known.Data);
  }

  bool IsDrawnApart(std::uint32_t part) const override
  {
    return this->Parts.IsDrawnApart(this->Parts.Parts[part], this->Samples);
  }

private:
  SceneParts& Parts;
  const SampleGrid& Samples;
};

void SceneParts::VerifyHidden(PartCuller& culler, const ScreenProjection& view,
  const std::vector<std::uint8_t>& drawn, std::vector<std::uint8_t>& visible)
{
  std::vector<BoxedPart> hidden = this->FindHiddenInView(view, culler.Samples(), drawn, visible);
  const auto firstShown = std::partition(hidden.begin(), hidden.end(),
    [&](const BoxedPart& part) { return !this->MayShowAnywhere(part, view); });
  std::for_each(
    firstShown, hidden.end(), [&](const BoxedPart& part) { visible[part.Part] = MayBeElsewhere; });
  hidden.erase(firstShown, hidden.end());
  Shapes shapes(*this, culler.Samples());
  const std::vector<std::uint8_t> stay = culler.VerifyHidden(hidden, shapes, view);
  for (std::size_t i = 0; i < stay.size(); ++i)
  {
    visible[hidden[i].Part] = stay[i] ? IsLeftOut : MayBeElsewhere;
  }
}

/**
 * Returns true if nothing can tell whether the part is hidden. Wireframes may be nearer than is known. The geometry of
 * data that change all the time is not read. Lines and points are drawn beyond the border of a viewport, where nothing
 * hides them.
 */
bool SceneParts::MayShowAnywhere(const BoxedPart& part, const ScreenProjection& view) const
{
  const Part& known = this->Parts[part.Part];
  return known.IsWireframe || known.Geometry->IsRestless(this->Looks) ||
    (known.Growth > 0.0f && view.ReachesBeyond(view.RectangleOf(part.Bounds).value_or(Everywhere)));
}

/**
 * Returns true if passes may draw the part at the centres of pixels with several samples, or at those of other pixels
 * than the window has.
 */
bool SceneParts::IsDrawnApart(const Part& part, const SampleGrid& samples) const
{
  return !samples.HasOneSamplePerPixel() && !this->IsOpaque(part);
}

/** Returns the parts that this frame draws, that were found hidden, and that may have samples in the view. */
std::vector<BoxedPart> SceneParts::FindHiddenInView(const ScreenProjection& view,
  const SampleGrid& samples, const std::vector<std::uint8_t>& drawn,
  const std::vector<std::uint8_t>& visible) const
{
  const PartChunks chunks(visible.size());
  std::vector<std::vector<BoxedPart>> ofChunks(chunks.Count());
  chunks.ForEach(
    [&](std::size_t chunk, std::size_t first, std::size_t end)
    {
      ViewFilter filter(view, samples, ofChunks[chunk]);
      for (std::size_t i = first; i < end; ++i)
      {
        if (drawn[i] && !visible[i] && this->Parts[i].Geometry)
        {
          filter.Add({ static_cast<std::uint32_t>(i), this->BoxOf[i] },
            this->IsDrawnApart(this->Parts[i], samples));
        }
      }
      filter.Flush();
    });
  std::vector<BoxedPart> found;
  for (const std::vector<BoxedPart>& ofChunk : ofChunks)
  {
    found.insert(found.end(), ofChunk.begin(), ofChunk.end());
  }
  return found;
}

}
