// Puts random convex faces into an s-buffer, with or without statements on their order, and asks whether others show.
// All faces at the middles of all lines are the judge.

#include "FuzzBytes.h"

#include "../Core/FaceScenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace faces;

constexpr unsigned MostFaces = 16;

/** What is finite is not too large for doubles to tell parts of a column. */
float CoordinateOf(FuzzBytes& bytes, float scale, float middle)
{
  const float number = bytes.Number() * scale + middle;
  return std::isfinite(number) && std::abs(number) > 1e5f ? std::remainder(number, 64.0f) : number;
}

ScreenPoint PointOf(FuzzBytes& bytes)
{
  const float column = CoordinateOf(bytes, 8.0f, 20.0f);
  const float line = CoordinateOf(bytes, 3.0f, 6.0f);
  const float depth = CoordinateOf(bytes, 0.125f, 0.5f);
  return { column, line, std::isfinite(depth) ? std::min(std::abs(depth), 1.0f) : depth };
}

/** A triangle, or a parallelogram, or all of one depth. */
Polygon PolygonOf(FuzzBytes& bytes)
{
  Polygon polygon{ PointOf(bytes), PointOf(bytes), PointOf(bytes) };
  const unsigned kind = bytes.Below(4);
  if (kind == 0)
  {
    const ScreenPoint &a = polygon[0], &b = polygon[1], &c = polygon[2];
    const float depth = a.Depth + (c.Depth - b.Depth);
    if (!(depth < 0.0f)) // behind the far plane
    {
      polygon.push_back({ a.Column + (c.Column - b.Column), a.Line + (c.Line - b.Line), depth });
    }
  }
  if (kind == 1)
  {
    polygon[1].Depth = polygon[2].Depth = polygon[0].Depth;
  }
  return polygon;
}

/** Each triangle shares a side with the last one. */
void AddStrip(FaceScene& scene, FuzzBytes& bytes)
{
  std::vector<ScreenPoint> points{ PointOf(bytes), PointOf(bytes) };
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 1 + bytes.Below(6); i > 0; --i)
  {
    const std::uint32_t last = static_cast<std::uint32_t>(points.size());
    const bool isTurned = last % 2 == 1;
    corners.insert(corners.end(), { last - (isTurned ? 1 : 2), last - (isTurned ? 2 : 1), last });
    points.push_back(PointOf(bytes));
  }
  scene.AddMesh(points, corners);
}

/** Whether any two keep a distance in depth, the same one in front everywhere. */
bool AreApart(const Polygon& a, const Polygon& b)
{
  int front = 0;
  for (int line = 0; line < Lines; ++line)
  {
    const std::vector<Stretch> both = StretchesOf({ a, b }, line);
    const double left = both.size() < 2 ? 0.0 : std::max(both[0].Left, both[1].Left);
    const double right = both.size() < 2 ? 0.0 : std::min(both[0].Right, both[1].Right);
    for (const double x : { left, right })
    {
      const double nearer = left < right ? both[0].DepthAt(x) - both[1].DepthAt(x) : 0.0;
      const int sign = nearer > 0.01 ? 1 : -1;
      if (left < right && (std::abs(nearer) < 0.01 || front == -sign))
      {
        return false;
      }
      front = left < right ? sign : front;
    }
  }
  return true;
}

bool AreAllApart(const std::vector<Polygon>& polygons)
{
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (!AreApart(polygons[i], polygons[j]))
      {
        return false;
      }
    }
  }
  return true;
}

void AskWhatIsHidden(const SBuffer& buffer, const FaceScene& scene, FuzzBytes& bytes)
{
  const Polygon asked = PolygonOf(bytes);
  if (!vitrine::HidesFace(buffer, { asked.data(), asked.size(), 0 }, 0.0f))
  {
    return;
  }
  Require(IsFinite(asked), "what is no face is hidden");
  for (int line = 0; line < Lines; ++line)
  {
    std::vector<Stretch> stretches = StretchesOf(scene.Polygons, line);
    const Stretch own = StretchOf(asked, line + 0.5);
    stretches.push_back(own);
    for (const double x : PlacesBetween(stretches, Columns))
    {
      if (own.Left < x && x < own.Right)
      {
        const Stretch nearest = NearestAt(stretches, x);
        Require(nearest.DepthAt(x) > own.DepthAt(x), "what is hidden is in front");
      }
    }
  }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzBytes bytes(data, size);
  const unsigned switches = bytes.Below(9);
  FaceScene scene;
  while (scene.Polygons.size() < MostFaces && bytes.AreLeft())
  {
    if (bytes.Below(3) == 0)
    {
      AddStrip(scene, bytes);
    }
    else
    {
      scene.Add(PolygonOf(bytes));
    }
  }
  SBuffer buffer(Columns, Lines, {}, 1u << 14);
  if (switches == 8)
  {
    scene.InsertInto(buffer);
  }
  else
  {
    FaceOrder order(AllStatements()[switches]);
    scene.InsertInto(buffer, order);
  }
  const Differences differences = Compare(buffer, scene.Polygons);
  Require(differences.Nearer == 0, "a span is nearer than all faces");
  Require(differences.Uncovered == 0, "a face is not there");
  Require(
    differences.Farther == 0 || !AreAllApart(scene.Polygons), "the nearest face is not there");
  AskWhatIsHidden(buffer, scene, bytes);
  return 0;
}
