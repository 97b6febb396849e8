#include "Core/culling/hidden/HiddenFaces.h"

#include "Core/culling/hidden/FaceOnLines.h"
#include "Core/culling/screen/LineExtent.h"
#include "Core/culling/steady/DepthPlane.h"
#include "Core/culling/steady/FaceBlock.h"
#include "Core/culling/steady/SideCuts.h"
#include "Core/culling/steady/SliverDepth.h"
#include "Core/geometry/BeyondAll.h"

#include <algorithm>
#include <iterator>

namespace vitrine
{

namespace
{

// A bound of depth. If SideCuts leaves more doubt about a face, CutFaces looks at it more closely.
const float MostUnsteady = 0x1p-14f;

// The number of faces that are searched for samples at once. Most parts that show are found to by their first faces.
const std::size_t FacesAtOnce = 64;

}

bool HiddenFaces::AreAll(const MeshProjection& projection)
{
  this->BeginSampling(projection);
  return this->AreFrontsHidden(projection) && this->AreAllHidden(projection, this->Others) &&
    this->AreCutFacesHidden(projection, {}, BeyondAll);
}

void HiddenFaces::BeginSampling(const MeshProjection& projection)
{
  this->Sampled.clear();
  this->WithSamples.Begin(projection, this->Lines.Samples(), this->View.GrowthOnScreen());
}

/** Returns true if all front faces are hidden. Finds the other faces that may have samples. */
bool HiddenFaces::AreFrontsHidden(const MeshProjection& projection)
{
  const std::vector<MeshFace>& faces = projection.Faces();
  this->Others.clear();
  for (std::size_t first = 0; first < faces.size(); first += FacesAtOnce)
  {
    this->Sampled.clear();
    this->Fronts.clear();
    this->WithSamples.Add(first, std::min(first + FacesAtOnce, faces.size()), this->Sampled);
    for (const std::uint32_t face : this->Sampled)
    {
      const bool isFront = projection.TurnOf(faces[face]) == MeshProjection::Facing::Front;
      (isFront ? this->Fronts : this->Others).push_back(face);
    }
    if (!this->AreAllHidden(projection, this->Fronts))
    {
      return false;
    }
  }
  return true;
}

bool HiddenFaces::AreAllHidden(
  const MeshProjection& projection, const std::vector<std::uint32_t>& faces)
{
  for (std::size_t first = 0; first < faces.size(); first += LaneCount)
  {
    const FaceBlock block(projection, faces, first);
    if (!this->AreHidden(projection, block, block.All()))
    {
      return false;
    }
  }
  return true;
}

/**
 * Returns true if all faces are hidden that a device may cut at the sides of the view, and may draw nearer for that.
 */
bool HiddenFaces::AreCutFacesHidden(
  const MeshProjection& projection, const std::vector<std::uint32_t>& thin, float nearest)
{
  if (!projection.MayBeCut())
  {
    return true;
  }
  this->MaybeCut.clear();
  for (std::uint32_t i = 0; i < projection.Faces().size(); ++i)
  {
    if (projection.MayBeCut(projection.WholeOf(i)))
    {
      this->MaybeCut.push_back(i);
    }
  }
  this->Cuts.Begin(projection, this->Lines.Samples());
  const SideCuts cuts(projection);
  for (std::size_t first = 0; first < this->MaybeCut.size(); first += LaneCount)
  {
    FaceBlock block(projection, this->MaybeCut, first);
    const unsigned faces = block.MayHaveAny(this->Lines.Samples(), this->View.GrowthOnScreen());
    const FacetDepths known = faces ? cuts.UnsteadyOf(block) : FacetDepths{};
    for (unsigned bits = faces; bits != 0; bits &= bits - 1)
    {
      const int lane = LowestBit(bits);
      const std::uint32_t face = this->MaybeCut[first + static_cast<std::size_t>(lane)];
      if (!std::binary_search(thin.begin(), thin.end(), face))
      {
        block.LimitNearest(lane, nearest);
      }
      block.Unsettle(lane, known[lane] < MostUnsteady ? known[lane] : this->Cuts.UnsteadyOf(face));
    }
    if (!this->AreHidden(projection, block, faces))
    {
      return false;
    }
  }
  return true;
}

/** Returns true if some faces of a block are hidden. Tests them together first, then one by one. */
bool HiddenFaces::AreHidden(
  const MeshProjection& projection, const FaceBlock& block, unsigned faces)
{
  if (this->AreHiddenTogether(block, faces))
  {
    return true;
  }
  for (int lane = 0; faces >> lane != 0; ++lane)
  {
    if ((faces >> lane & 1u) != 0 && !this->IsHidden(projection, block, lane))
    {
      return false;
    }
  }
  return true;
}

bool HiddenFaces::AreHiddenTogether(const FaceBlock& block, unsigned faces) const
{
  return faces == 0 || this->Lines.Hides(this->View.Grown(block.RectangleAround(faces)));
}

bool HiddenFaces::AreAllOfAnyThickness(const MeshProjection& projection)
{
  this->BeginSampling(projection);
  this->WithSamples.Add(0, projection.Faces().size(), this->Sampled);
  return this->AreSampledHiddenOfAnyThickness(projection) &&
    this->AreCutFacesHidden(projection, {}, BeyondAll);
}

bool HiddenFaces::AreSomeOfAnyThickness(
  const MeshProjection& projection, const std::vector<std::uint32_t>& faces, float nearest)
{
  this->Sampled.clear();
  if (!faces.empty())
  {
    this->BeginSampling(projection);
    this->WithSamples.Add(faces, this->Sampled);
  }
  return this->AreSampledHiddenOfAnyThickness(projection) &&
    this->AreCutFacesHidden(projection, faces, nearest);
}

bool HiddenFaces::AreSampledHiddenOfAnyThickness(const MeshProjection& projection)
{
  for (std::size_t first = 0; first < this->Sampled.size(); first += LaneCount)
  {
    if (!this->AreHiddenOfAnyThickness(projection, FaceBlock(projection, this->Sampled, first)))
    {
      return false;
    }
  }
  return true;
}

/**
 * Returns true if the faces of a block are hidden. Slivers of which floats tell nothing get depths that are found in
 * doubles.
 */
bool HiddenFaces::AreHiddenOfAnyThickness(const MeshProjection& projection, FaceBlock block)
{
  const unsigned faces = block.MayHaveAny(this->Lines.Samples(), this->View.GrowthOnScreen());
  for (unsigned bits = faces; bits != 0; bits &= bits - 1)
  {
    const int lane = LowestBit(bits);
    if (projection.IsBehindNear() && block.RectangleOf(lane).Nearest > 1.0f)
    {
      block.LimitNearest(lane, NearestInDoubles(projection, block.Face(lane)));
    }
  }
  return this->AreHidden(projection, block, faces);
}

void HiddenFaces::ExcludeHidden(MeshProjection& projection, MeshProjection::Facing facing) const
{
  const std::vector<MeshFace>& faces = projection.Faces();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (projection.FacingOf(i) == facing && this->Lines.Hides(projection.RectangleOf(faces[i])))
    {
      projection.Exclude(i);
    }
  }
}

/** Returns true if a face is hidden. A face that is drawn wider than it is can only be tested by its rectangle. */
bool HiddenFaces::IsHidden(const MeshProjection& projection, const FaceBlock& block, int lane)
{
  this->Shown = this->View.Grown(block.RectangleOf(lane));
  if (this->Lines.Hides(this->Shown))
  {
    return true;
  }
  if (this->View.Grows())
  {
    return false;
  }
  const FaceOnLines face(projection, block, lane);
  const LineRange lines = face.Lines(this->Lines.Lines());
  return lines.First <= lines.Last && this->IsHidden(face, lines);
}

/** Returns true if a face is hidden on some lines. Halves them, down to at most eight. */
bool HiddenFaces::IsHidden(const FaceOnLines& face, const LineRange& lines)
{
  if (lines.Last - lines.First < LaneCount)
  {
    return this->AreLinesHidden(face, lines);
  }
  const float inset = this->Lines.Samples().Inset();
  const ScreenRectangle around = face.RectangleBetween(static_cast<float>(lines.First) + inset,
    static_cast<float>(lines.Last + 1) - inset, this->Lines);
  if (around.Left > around.Right || this->Lines.Hides(around))
  {
    return true;
  }
  const int middle = lines.First + (lines.Last - lines.First) / 2;
  return this->IsHidden(face, { lines.First, middle }) &&
    this->IsHidden(face, { middle + 1, lines.Last });
}

/**
 * Returns true if a face is hidden on up to eight lines. Compares depths that may slant, as those in the s-buffer do.
 */
bool HiddenFaces::AreLinesHidden(const FaceOnLines& face, const LineRange& lines)
{
  return this->Lines.BySample() ? this->AreSamplesHidden(face, lines)
                                : this->AreSpansHidden(face, lines);
}

/** Tests all lines at once, in an s-buffer of samples. */
bool HiddenFaces::AreSamplesHidden(const FaceOnLines& face, const LineRange& lines)
{
  const float inset = this->Lines.Samples().Inset();
  FaceOnLines::ExtentLanes extents = face.Extents(lines.First, inset);
  std::fill(extents.Right + (lines.Last + 1 - lines.First), std::end(extents.Right), -BeyondAll);
  const HideableSegmentLanes pieces = face.Pieces(lines.First, inset);
  float shown;
  const unsigned open =
    this->Lines.BySample()->FindOpen(lines.First, extents.Left, extents.Right, pieces, shown);
  if (open == 0)
  {
    return true;
  }
  const float line = static_cast<float>(lines.First + LowestBit(open));
  const float bottom = line + inset, top = line + 1.0f - inset;
  this->Shown = { shown, shown, bottom, top,
    face.Piece(shown, shown, bottom, top).NearestAt(shown) };
  return false;
}

/** Tests lines one by one, in an s-buffer of spans. */
bool HiddenFaces::AreSpansHidden(const FaceOnLines& face, const LineRange& lines)
{
  const float inset = this->Lines.Samples().Inset();
  const FaceOnLines::ExtentLanes extents = face.Extents(lines.First, inset);
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    const int lane = line - lines.First;
    const float bottom = static_cast<float>(line) + inset;
    const float top = static_cast<float>(line + 1) - inset;
    if (!(extents.Left[lane] <= extents.Right[lane]))
    {
      continue;
    }
    const HideableSegment piece = face.Piece(extents.Left[lane], extents.Right[lane], bottom, top);
    float shown;
    if (!this->Lines.Hides(line, piece, shown))
    {
      this->Shown = { shown, shown, bottom, top, piece.NearestAt(shown) };
      return false;
    }
  }
  return true;
}

float NearestOnScreen(const MeshProjection& mesh, int columns, int lines)
{
  float nearest = -1.0f;
  for (const MeshFace& face : mesh.Faces())
  {
    const ScreenRectangle around = mesh.RectangleOf(face);
    const float left = std::max(around.Left, 0.0f), bottom = std::max(around.Bottom, 0.0f);
    const float right = std::min(around.Right, static_cast<float>(columns));
    const float top = std::min(around.Top, static_cast<float>(lines));
    if (left < right && bottom < top)
    {
      const DepthPlane plane(mesh.Point(face[0]), mesh.Point(face[1]), mesh.Point(face[2]),
        mesh.Margin(), mesh.Snapping());
      nearest = std::max(nearest, plane.NearestIn(left, right, bottom, top));
    }
  }
  return std::min(nearest, 1.0f);
}

}
