#include "Core/culling/cover/ScreenPatches.h"

#include "Core/culling/steady/DepthPlane.h"

#include <algorithm>
#include <cmath>

namespace vitrine
{

namespace
{

// The least width of a set of corners, relative to its length, for a plane to be fitted. Corners in a row have none.
const double LeastWidthOfFit = 1e-6;

// A face stands alone if the error of its depth exceeds its extent in depth plus this multiple of the margin of depth.
const float MostSlack = 4.0f;
}

void ScreenPatches::Find(
  const MeshProjection& projection, MeshProjection::Facing facing, const SampleGrid& samples)
{
  this->Projection = &projection;
  this->Faces.clear();
  this->Patches.clear();
  this->Fits.clear();
  this->PatchOf.assign(projection.Faces().size(), None);
  this->NumberOf.assign(projection.Mesh().Faces().size(), None);
  this->Cuts.Begin(projection, samples);
  this->FindFaces(facing);
  this->FitPlanes();
}

void ScreenPatches::FindFaces(MeshProjection::Facing facing)
{
  const std::vector<MeshFace>& faces = this->Projection->Faces();
  const ScreenMargin& margin = this->Projection->Margin();
  for (std::uint32_t i = 0; i < faces.size(); ++i)
  {
    const ScreenPoint a = this->Projection->Point(faces[i][0]);
    const ScreenPoint b = this->Projection->Point(faces[i][1]);
    const ScreenPoint c = this->Projection->Point(faces[i][2]);
    if (this->Projection->FacingOf(i) != facing ||
      !std::isfinite(a.Depth + b.Depth + c.Depth + margin.Depth))
    {
      continue;
    }
    DepthPlane plane(a, b, c, margin, this->Projection->Snapping());
    plane.Unsettle(this->Cuts.UnsteadyOf(i));
    const float difference =
      std::max({ a.Depth, b.Depth, c.Depth }) - std::min({ a.Depth, b.Depth, c.Depth });
    const bool isKnown = plane.Bound().Slack <= difference + MostSlack * margin.Depth;
    const std::uint32_t patch = this->NumberFor(i, !isKnown);
    this->Faces.push_back({ i, plane.Bound() });
    this->AddFace(this->Faces.back(), patch);
  }
}

/** Returns the patch of a face. Makes a new one if the face is the first or stands alone. */
std::uint32_t ScreenPatches::NumberFor(std::uint32_t face, bool isAlone)
{
  std::uint32_t& known = this->NumberOf[this->Projection->PatchOf(face)];
  if (!isAlone && known != None)
  {
    return known;
  }
  const auto patch = static_cast<std::uint32_t>(this->Patches.size());
  this->Patches.emplace_back();
  this->Fits.emplace_back();
  if (!isAlone)
  {
    known = patch;
  }
  return patch;
}

void ScreenPatches::AddFace(const CountedFace& counted, std::uint32_t number)
{
  const MeshFace& face = this->Projection->Faces()[counted.Face];
  Patch& patch = this->Patches[number];
  Fit& fit = this->Fits[number];
  this->PatchOf[counted.Face] = number;
  if (fit.Faces == 0)
  {
    fit.Origin = this->Projection->Point(face[0]);
    patch.Bound = counted.Bound;
  }
  ++fit.Faces;
  const float aside = this->Projection->Margin().Column;
  const float above = this->Projection->Margin().Line;
  for (const std::uint32_t corner : face)
  {
    const ScreenPoint point = this->Projection->Point(corner);
    fit.Add(point);
    patch.Left = std::min(patch.Left, point.Column - aside);
    patch.Right = std::max(patch.Right, point.Column + aside);
    patch.Bottom = std::min(patch.Bottom, point.Line - above);
    patch.Top = std::max(patch.Top, point.Line + above);
  }
}

void ScreenPatches::Fit::Add(const ScreenPoint& point)
{
  const double column = double{ point.Column } - this->Origin.Column;
  const double line = double{ point.Line } - this->Origin.Line;
  const double depth = double{ point.Depth } - this->Origin.Depth;
  this->Columns += column;
  this->Lines += line;
  this->Depths += depth;
  this->ColumnColumns += column * column;
  this->ColumnLines += column * line;
  this->LineLines += line * line;
  this->ColumnDepths += column * depth;
  this->LineDepths += line * depth;
}

/** Returns the plane that fits best by least squares, in front of all depths. */
SlantedDepth ScreenPatches::Fit::BestPlane() const
{
  const double share = 1.0 / (3.0 * this->Faces);
  const double xx = this->ColumnColumns - share * this->Columns * this->Columns;
  const double xy = this->ColumnLines - share * this->Columns * this->Lines;
  const double yy = this->LineLines - share * this->Lines * this->Lines;
  const double xd = this->ColumnDepths - share * this->Columns * this->Depths;
  const double yd = this->LineDepths - share * this->Lines * this->Depths;
  const double area = xx * yy - xy * xy;
  SlantedDepth plane;
  plane.Origin = { this->Origin.Column, this->Origin.Line, 2.0f };
  plane.Farthest = 2.0f;
  if (area > LeastWidthOfFit * xx * yy)
  {
    plane.ByColumn = static_cast<float>((xd * yy - yd * xy) / area);
    plane.ByLine = static_cast<float>((yd * xx - xd * xy) / area);
  }
  return plane;
}

/** Finds the planes of patches of several faces. A face that is alone has its own plane. */
void ScreenPatches::FitPlanes()
{
  for (std::size_t i = 0; i < this->Patches.size(); ++i)
  {
    if (this->Fits[i].Faces > 1)
    {
      this->Patches[i].Bound = this->Fits[i].BestPlane();
    }
  }
  for (const CountedFace& counted : this->Faces)
  {
    const std::uint32_t patch = this->PatchOf[counted.Face];
    if (this->Fits[patch].Faces > 1)
    {
      this->MoveBehind(counted, this->Patches[patch]);
    }
  }
}

/**
 * Moves the plane of a patch behind a face. Beside the face a device may follow the own plane of the face. So the slack
 * of both planes counts, as if the distance between them grew by both slopes.
 */
void ScreenPatches::MoveBehind(const CountedFace& counted, Patch& patch) const
{
  const ScreenMargin& margin = this->Projection->Margin();
  SlantedDepth& bound = patch.Bound;
  const float beside =
    std::abs(bound.ByColumn) * margin.Column + std::abs(bound.ByLine) * margin.Line;
  for (const std::uint32_t corner : this->Projection->Faces()[counted.Face])
  {
    const ScreenPoint point = this->Projection->Point(corner);
    const float byColumn = (point.Column - bound.Origin.Column) * bound.ByColumn;
    const float byLine = (point.Line - bound.Origin.Line) * bound.ByLine;
    const float terms = std::abs(point.Depth) + std::abs(byColumn) + std::abs(byLine);
    bound.Slack = std::max(bound.Slack, beside + 2.0f * RoundingOfFloats * terms);
    bound.Origin.Depth =
      std::min(bound.Origin.Depth, point.Depth - byColumn - byLine - counted.Bound.Slack);
  }
  bound.Farthest = std::min(bound.Farthest, counted.Bound.Farthest);
}

}
