// The exponential slice law is from O. Olsson, M. Billeter, U. Assarsson: Clustered deferred and forward shading, High
// Performance Graphics 2012.

#include "Core/lighting/ClusterGrid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

/** Widening of a tile on each side, in pixels. */
constexpr double PixelSlack = 0.05;

/** Widening of a slice, as a share of the distance. Logarithms of shaders are accurate to about 2^-20. */
constexpr double DepthSlack = 2e-5;

/**
 * Additional widening of slices that are uniform in NDC. It grows with the distance, as rounding errors of NDC do
 * there.
 */
constexpr double NdcSlack = 1e-6;

/** Replaces a far plane at infinity: the far distance as a multiple of the near distance. */
constexpr double FarthestRatio = 1e6;

bool IsFinite(const glm::dmat4& m)
{
  bool isFinite = true;
  for (int i = 0; i < 16; ++i)
  {
    isFinite = isFinite && std::isfinite(m[i / 4][i % 4]);
  }
  return isFinite;
}

glm::dvec4 RowOf(const glm::dmat4& m, int row)
{
  return { m[0][row], m[1][row], m[2][row], m[3][row] };
}

/**
 * Returns the distance -z (VC) of a point given in NDC. It is infinite for a far plane at infinity, and minus infinity
 * for a near plane that is not in front of the eye.
 */
double DistanceOf(const glm::dmat4& fromClip, const glm::dvec3& ndc)
{
  const glm::dvec4 point = fromClip * glm::dvec4(ndc, 1.0);
  return point.w > 0.0 ? -point.z / point.w : ndc.z * Infinite;
}

/** Clamps to 0 to `count` - 1. NaN becomes 0. */
int Clamped(double value, int count)
{
  return static_cast<int>(std::min(std::max(0.0, value), count - 1.0));
}

/** Scales a plane to a normal of length 1. */
glm::vec4 Normalized(const glm::dvec4& plane)
{
  return glm::vec4(plane / glm::length(glm::dvec3(plane)));
}

float RoundedDown(double value)
{
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}

float RoundedUp(double value)
{
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}
}

ClusterGrid::ClusterGrid(
  const glm::dmat4& toClip, int width, int height, const ClusterSettings& settings)
  : ToClip(toClip)
{
  if (!this->TakeDepths())
  {
    this->MakeOneCluster(std::max({ width, height, 1 }));
    return;
  }
  const glm::dvec2 size(std::max(width, 1), std::max(height, 1));
  this->PixelsPerTile = std::max(settings.TileSize, 1);
  this->Tiles = glm::ivec2(glm::ceil(size / static_cast<double>(this->PixelsPerTile)));
  this->MakeTiles(size);
  this->MakeSlices(settings);
}

void ClusterGrid::MakeOneCluster(int size)
{
  this->PixelsPerTile = size;
  this->Scale = glm::vec2(0.5f); // one tile from -1 to 1
  this->ToClip = glm::dmat4(0.0);
  this->ToClip[3].w = 1.0;
  this->Ends = { -Infinite, Infinite };
  this->Depths = { glm::vec2(-Infinite, Infinite) };
  this->Lefts = this->Rights = this->Bottoms = this->Tops = { glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) };
  this->Terms = glm::vec4(0.0f, 0.0f, 1.0f, 0.0f);
  this->Weight = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

/**
 * Takes the near and far distances from the projection. Returns false if it is not a usable projection: w must be a
 * positive multiple of the distance, or a positive constant.
 */
bool ClusterGrid::TakeDepths()
{
  const glm::dvec4 w = RowOf(this->ToClip, 3);
  this->HasParallelRays = w.z == 0.0;
  const double scale = this->HasParallelRays ? w.w : -w.z;
  const bool isKnown =
    w.x == 0.0 && w.y == 0.0 && (this->HasParallelRays || w.w == 0.0) && scale > 0.0;
  if (!IsFinite(this->ToClip) || !isKnown)
  {
    return false;
  }
  this->ToClip /= scale;
  const glm::dmat4 fromClip = glm::inverse(this->ToClip);
  if (!IsFinite(fromClip))
  {
    return false;
  }
  double near = Infinite, far = -Infinite;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 ndc(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    const double distance = DistanceOf(fromClip, ndc);
    near = std::min(near, distance);
    far = std::max(far, distance);
  }
  const double farthest = std::isfinite(far) ? far : near * FarthestRatio;
  this->Ends = { near, farthest };
  return std::isfinite(near) && std::isfinite(farthest) && (this->HasParallelRays || near > 0.0);
}

void ClusterGrid::MakeSlices(const ClusterSettings& settings)
{
  const double near = this->Near(), far = this->Far();
  const int slices = far > near ? std::max(settings.Slices, 1) : 1;
  this->SlicesBy = this->HasParallelRays ? SliceLaw::Uniform : settings.Law;
  this->Ends = { near };
  if (slices == 1)
  {
    this->SetTerms(this->SlicesBy == SliceLaw::Exponential ? 1.0 / near : 0.0, 0.0);
    this->Ends.push_back(far);
  }
  else if (this->SlicesBy == SliceLaw::Exponential)
  {
    this->Ends.push_back(far);
    this->MakeExponential(slices);
  }
  else if (this->SlicesBy == SliceLaw::Uniform)
  {
    this->SetTerms(near, slices / (far - near));
    for (int k = 1; k <= slices; ++k)
    {
      this->Ends.push_back(near + (far - near) * k / slices);
    }
  }
  else
  {
    const double share = slices * (far / (far - near));
    this->SetTerms(share, -share * near);
    for (int k = 1; k <= slices; ++k)
    {
      this->Ends.push_back(k == slices ? far : share * near / (share - k));
    }
  }
  this->Terms.z = static_cast<float>(this->Ends.size() - 1);
  for (std::size_t k = 0; k + 1 < this->Ends.size(); ++k)
  {
    const double least = this->Ends[k], greatest = this->Ends[k + 1];
    this->Depths.emplace_back(
      RoundedDown(least - this->SlackAt(least)), RoundedUp(greatest + this->SlackAt(greatest)));
  }
  this->Depths.front().x = this->HasParallelRays ? -std::numeric_limits<float>::infinity() : 0.0f;
  this->Depths.back().y = std::numeric_limits<float>::infinity();
}

void ClusterGrid::MakeExponential(int slices)
{
  const double near = this->Near(), ratio = this->Far() / near;
  const double height = glm::length(this->RayAt(0.0, 1.0).Slope - this->RayAt(0.0, -1.0).Slope);
  const double paper = 1.0 + height / this->Tiles.y;
  const double needed = std::ceil(std::log(ratio) / std::log(paper) - 1e-9);
  const bool areEnough = needed <= slices;
  const int count = areEnough ? std::max(1, static_cast<int>(needed)) : slices;
  const double step = areEnough ? paper : std::pow(ratio, 1.0 / slices);
  this->SetTerms(1.0 / near, 1.0 / std::log(step));
  this->Ends = { near };
  for (int k = 1; k <= count; ++k)
  {
    this->Ends.push_back(near * std::pow(step, k));
  }
}

void ClusterGrid::SetTerms(double x, double y)
{
  this->Terms.x = static_cast<float>(x);
  this->Terms.y = static_cast<float>(y);
}

/** Returns the widening of a slice at one of its ends, in VC. */
double ClusterGrid::SlackAt(double end) const
{
  const double largest = std::max(std::abs(this->Near()), std::abs(this->Far()));
  const double from = this->HasParallelRays ? largest : std::abs(end);
  const double ndc = this->SlicesBy == SliceLaw::NdcUniform ? NdcSlack * end / this->Near() : 0.0;
  return from * (DepthSlack + ndc);
}

void ClusterGrid::MakeTiles(const glm::dvec2& size)
{
  const double tileSize = this->PixelsPerTile;
  this->Scale = glm::vec2(0.5 * size / tileSize);
  const glm::dvec4 w = RowOf(this->ToClip, 3);
  this->Weight = glm::vec4(w);
  this->ColumnTerms = glm::vec4(0.5 * size.x / tileSize * (RowOf(this->ToClip, 0) + w));
  this->RowTerms = glm::vec4(0.5 * size.y / tileSize * (RowOf(this->ToClip, 1) + w));
  for (int axis = 0; axis < 2; ++axis)
  {
    std::vector<double>& starts = axis == 0 ? this->LeftEnds : this->BottomEnds;
    std::vector<double>& stops = axis == 0 ? this->RightEnds : this->TopEnds;
    std::vector<glm::vec4>& lows = axis == 0 ? this->Lefts : this->Bottoms;
    std::vector<glm::vec4>& highs = axis == 0 ? this->Rights : this->Tops;
    const int count = this->Tiles[axis];
    for (int tile = 0; tile < count; ++tile)
    {
      const double before = tile == 0 ? 0.5 * tileSize : PixelSlack;
      const double after = tile == count - 1 ? 0.5 * tileSize : PixelSlack;
      const double last = std::min(size[axis], (tile + 1) * tileSize);
      starts.push_back(2.0 * (tile * tileSize - before) / size[axis] - 1.0);
      stops.push_back(2.0 * (last + after) / size[axis] - 1.0);
      lows.push_back(Normalized(this->SideAt(axis, starts.back())));
      highs.push_back(Normalized(-this->SideAt(axis, stops.back())));
    }
  }
}

/** Returns the plane (VC) on which an NDC coordinate equals `ndc`. The coordinate is greater on the positive side. */
glm::dvec4 ClusterGrid::SideAt(int axis, double ndc) const
{
  return RowOf(this->ToClip, axis) - ndc * RowOf(this->ToClip, 3);
}

/** Returns the view ray of a position in NDC. */
ClusterGrid::Ray ClusterGrid::RayAt(double ndcX, double ndcY) const
{
  const glm::dvec4 x = this->SideAt(0, ndcX), y = this->SideAt(1, ndcY);
  const double determinant = x.x * y.y - x.y * y.x;
  const auto solved = [&](double right, double above)
  { return glm::dvec2(right * y.y - above * x.y, above * x.x - right * y.x) / determinant; };
  return { glm::dvec3(solved(-x.w, -y.w), 0.0), glm::dvec3(solved(x.z, y.z), -1.0) };
}

int ClusterGrid::SliceOf(double distance) const
{
  const int slices = this->Slices();
  if (slices == 1)
  {
    return 0;
  }
  const auto end = std::upper_bound(this->Ends.begin() + 1, this->Ends.end() - 1, distance);
  return static_cast<int>(end - this->Ends.begin()) - 1;
}

bool ClusterGrid::HasLevelDepths() const
{
  const glm::dvec4 z = RowOf(this->ToClip, 2);
  return z.x == 0.0 && z.y == 0.0 &&
    this->WindowDepthAt(this->Near()) < this->WindowDepthAt(this->Far());
}

double ClusterGrid::WindowDepthAt(double distance) const
{
  const glm::dvec4 clip = this->ToClip * glm::dvec4(0.0, 0.0, -distance, 1.0);
  return 0.5 * clip.z / clip.w + 0.5;
}

glm::dvec2 ClusterGrid::TileOf(const glm::dvec3& point) const
{
  const glm::dvec4 clip = this->ToClip * glm::dvec4(point, 1.0);
  return (glm::dvec2(clip) / clip.w + 1.0) * glm::dvec2(this->Scale);
}

int ClusterGrid::ClusterOf(const glm::dvec3& point) const
{
  const glm::dvec2 tile = this->TileOf(point);
  return static_cast<int>(this->ClusterAt(
    Clamped(tile.x, this->Tiles.x), Clamped(tile.y, this->Tiles.y), this->SliceOf(-point.z)));
}

/** Returns the rays along a tile's four edges. */
ClusterGrid::TileRays ClusterGrid::RaysAround(int column, int row) const
{
  TileRays rays;
  for (int edge = 0; edge < 4; ++edge)
  {
    rays[edge] = this->RayAt(edge & 1 ? this->RightEnds[column] : this->LeftEnds[column],
      edge & 2 ? this->TopEnds[row] : this->BottomEnds[row]);
  }
  return rays;
}

std::vector<glm::vec4> ClusterGrid::BallsAround() const
{
  std::vector<glm::vec4> balls(
    this->Count(), glm::vec4(0.0f, 0.0f, 0.0f, std::numeric_limits<float>::infinity()));
  const int tiles = this->LeftEnds.empty() ? 0 : this->Tiles.x * this->Tiles.y;
  for (int tile = 0; tile < tiles; ++tile)
  {
    const TileRays rays = this->RaysAround(tile % this->Tiles.x, tile / this->Tiles.x);
    for (int slice = 0; slice < this->Slices(); ++slice)
    {
      const glm::dvec2 depths(this->Depths[slice]);
      if (depths.x > -Infinite && depths.y < Infinite)
      {
        glm::dvec3 sum(0.0);
        double square = 0.0;
        for (int corner = 0; corner < 8; ++corner)
        {
          sum += rays[corner & 3].At(depths[corner >> 2]);
        }
        const glm::dvec3 centre = sum / 8.0;
        for (int corner = 0; corner < 8; ++corner)
        {
          const glm::dvec3 away = rays[corner & 3].At(depths[corner >> 2]) - centre;
          square = std::max(square, glm::dot(away, away));
        }
        balls[slice * tiles + tile] = glm::vec4(centre, RoundedUp(std::sqrt(square)));
      }
    }
  }
  return balls;
}

Box ClusterGrid::BoundsOf(std::uint32_t cluster) const
{
  if (this->LeftEnds.empty())
  {
    return Box::Everything();
  }
  const int column = static_cast<int>(cluster) % this->Tiles.x;
  const int row = static_cast<int>(cluster) / this->Tiles.x % this->Tiles.y;
  const glm::dvec2 depths(this->Depths[static_cast<int>(cluster) / this->Tiles.x / this->Tiles.y]);
  glm::dvec3 low(Infinite), high(-Infinite);
  for (const Ray& ray : this->RaysAround(column, row))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int end = 0; end < 2; ++end)
      {
        // An infinite distance times a slope of 0 would be NaN; it counts as 0.
        const double along = ray.Slope[axis] == 0.0 ? 0.0 : ray.Slope[axis] * depths[end];
        low[axis] = std::min(low[axis], ray.Origin[axis] + along);
        high[axis] = std::max(high[axis], ray.Origin[axis] + along);
      }
    }
  }
  return Box::Around(low, high);
}

}
