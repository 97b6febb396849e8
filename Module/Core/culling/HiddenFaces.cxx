#include "Core/culling/HiddenFaces.h"

#include "Core/culling/DepthPlane.h"
#include "Core/culling/LineExtent.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{
// Pieces of lines that have samples anywhere are halved down to less.
const float ShortestPiece = 1.0f;

bool IsOf(HiddenFaces::Sides sides, MeshProjection::Facing facing)
{
  return (facing == MeshProjection::Facing::Front) == (sides == HiddenFaces::Sides::Front);
}
}

/** What a face may touch of lines. */
class HiddenFaces::Outlined
{
public:
  Outlined(const MeshProjection& projection, const MeshFace& face, const ScreenRectangle& around,
    const DepthPlane& plane)
    : Around(around)
    , Edges{ { projection.Point(face[0]), projection.Point(face[1]) },
      { projection.Point(face[1]), projection.Point(face[2]) },
      { projection.Point(face[2]), projection.Point(face[0]) } }
    , Own(std::max({ Edges[0].OwnRounding(), Edges[1].OwnRounding(), Edges[2].OwnRounding() }))
    , Aside(projection.Margin().Column + Own)
    , Above(projection.Margin().Line + Own)
    , Plane(plane)
  {
  }

  LineRange LinesOf(const SBuffer& buffer) const
  {
    return LinesBetween(
      this->Around.Bottom - this->Own, this->Around.Top + this->Own, { 0, buffer.Lines() - 1 });
  }

  /** Around the samples that it touches between two lines; Left exceeds Right if there are none. */
  ScreenRectangle Between(float bottom, float top, const SBuffer& buffer) const
  {
    LineExtent touched;
    for (const ScreenEdge& edge : this->Edges)
    {
      touched.Add(edge, bottom - this->Above, top + this->Above);
    }
    return this->Within(std::max(touched.Left - this->Aside, 0.0f),
      std::min(touched.Right + this->Aside, static_cast<float>(buffer.Columns())), bottom, top,
      buffer.Samples());
  }

  /** Around the samples of what it has in a rectangle, which it may touch all of. */
  ScreenRectangle Within(
    float left, float right, float bottom, float top, const SampleGrid& samples) const
  {
    const float first = samples.From(left), last = samples.UpTo(right);
    return { first, last, bottom, top,
      this->Plane.NearestWithin(
        first, last, std::max(bottom, this->Around.Bottom), std::min(top, this->Around.Top)) };
  }

private:
  const ScreenRectangle& Around;
  ScreenEdge Edges[3];
  float Own;
  float Aside, Above;
  const DepthPlane& Plane;
};

bool HiddenFaces::AreAll(const MeshProjection& projection, Sides sides)
{
  const std::vector<MeshFace>& faces = projection.Faces();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (IsOf(sides, projection.FacingOf(i)) && !this->IsHidden(projection, faces[i]))
    {
      return false;
    }
  }
  return true;
}

bool HiddenFaces::AreThinOnes(const MeshProjection& projection)
{
  const std::vector<MeshFace>& faces = projection.Faces();
  return std::all_of(faces.begin(), faces.end(),
    [&](const MeshFace& face)
    {
      return !this->Lines.MayHaveSamplesIn(this->View.Grown(projection.RectangleOf(face))) ||
        !IsThin(projection, face) || this->IsHidden(projection, face);
    });
}

/** Whether what a device moves points by may be as much as a face is thick; or nothing is known of it. */
bool HiddenFaces::IsThin(const MeshProjection& projection, const MeshFace& face)
{
  const ScreenPoint a = projection.Point(face[0]), b = projection.Point(face[1]),
                    c = projection.Point(face[2]);
  const float columns = std::max(std::abs(b.Column - a.Column), std::abs(c.Column - a.Column));
  const float lines = std::max(std::abs(b.Line - a.Line), std::abs(c.Line - a.Line));
  const float area =
    (b.Column - a.Column) * (c.Line - a.Line) - (c.Column - a.Column) * (b.Line - a.Line);
  const float moved = projection.Margin().Column * lines + projection.Margin().Line * columns;
  return !(std::abs(area) > 2.0f * moved);
}

void HiddenFaces::Drop(MeshProjection& projection, MeshProjection::Facing facing) const
{
  const std::vector<MeshFace>& faces = projection.Faces();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    if (projection.FacingOf(i) == facing && this->Lines.Hides(projection.RectangleOf(faces[i])))
    {
      projection.Drop(i);
    }
  }
}

/** What is drawn wider than it is has no more than a rectangle. */
bool HiddenFaces::IsHidden(const MeshProjection& projection, const MeshFace& face)
{
  const DepthPlane plane(projection.Point(face[0]), projection.Point(face[1]),
    projection.Point(face[2]), projection.Margin(), projection.Snapping());
  ScreenRectangle around = projection.RectangleOf(face);
  around.Nearest = plane.NearestOfAll();
  const bool isWider = this->View.Grows();
  this->Shown = isWider ? this->View.Grown(around) : around;
  if (this->Lines.Hides(this->Shown))
  {
    return true;
  }
  if (isWider)
  {
    return false;
  }
  const Outlined outlined(projection, face, around, plane);
  const LineRange lines = outlined.LinesOf(this->Lines);
  return lines.First <= lines.Last && this->IsHidden(outlined, lines);
}

/** Of what it has of some lines: half of them by half, down to one. */
bool HiddenFaces::IsHidden(const Outlined& face, const LineRange& lines)
{
  const float inset = this->Lines.Samples().Inset();
  const ScreenRectangle around = face.Between(static_cast<float>(lines.First) + inset,
    static_cast<float>(lines.Last + 1) - inset, this->Lines);
  if (lines.First == lines.Last)
  {
    return this->IsPieceHidden(face, around);
  }
  if (around.Left > around.Right || this->Lines.Hides(around))
  {
    return true;
  }
  const int middle = lines.First + (lines.Last - lines.First) / 2;
  return this->IsHidden(face, { lines.First, middle }) &&
    this->IsHidden(face, { middle + 1, lines.Last });
}

/** Of what it has of a line: half of the columns by half, down to one sample: its depth and what stands there may slant alike. */
bool HiddenFaces::IsPieceHidden(const Outlined& face, const ScreenRectangle& piece)
{
  if (piece.Left > piece.Right || this->Lines.Hides(piece))
  {
    return true;
  }
  const SampleGrid& samples = this->Lines.Samples();
  const float shortest = samples.Inset() > 0.0f ? 2.0f * samples.Inset() : ShortestPiece;
  if (!(piece.Right - piece.Left >= shortest))
  {
    this->Shown = piece;
    return false;
  }
  const float middle = 0.5f * (piece.Left + piece.Right);
  return this->IsPieceHidden(
           face, face.Within(piece.Left, middle, piece.Bottom, piece.Top, samples)) &&
    this->IsPieceHidden(face, face.Within(middle, piece.Right, piece.Bottom, piece.Top, samples));
}

}
