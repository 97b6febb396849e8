/**
 * The grid of clusters in the view frustum.
 */
#ifndef VITRINE_CORE_LIGHTING_CLUSTER_GRID_H
#define VITRINE_CORE_LIGHTING_CLUSTER_GRID_H

#include "Core/geometry/Box.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine
{

/** The positions of slice ends along the view. */
enum class SliceLaw
{
  /** Slice k ends at near * (1 + 2 tan(theta) / rows)^(k + 1): clusters are about as deep as high. */
  Exponential,
  Uniform,   ///< equal depths
  NdcUniform ///< equal steps of normalised device coordinates (NDC)
};

struct ClusterSettings
{
  int TileSize = 64; ///< side of a tile in pixels
  int Slices = 16;   ///< maximum number of slices
  SliceLaw Law = SliceLaw::Exponential;
};

/**
 * Divides the view frustum into clusters: tiles of pixels and slices of distance (O. Olsson, M. Billeter, U. Assarsson:
 * Clustered deferred and forward shading, HPG 2012). If the paper's slices do not reach the far plane, they are made
 * deeper until they do. In parallel projection slices are uniform.
 *
 * A cluster's bounds are slightly wider than the cluster that a shader computes, so rounding loses no light. The
 * outermost tiles extend outwards by half a tile, for wide lines and points. The first slice extends to the eye and the
 * last one to infinity.
 *
 * A projection that is not finite, or flat, yields one cluster that is all of space.
 */
class ClusterGrid
{
public:
  /**
   * @param toClip  the matrix from view coordinates (VC) to OpenGL's clip coordinates, for column vectors
   * @param width   the width of the picture in pixels
   * @param height  the height of the picture in pixels
   */
  ClusterGrid(
    const glm::dmat4& toClip, int width, int height, const ClusterSettings& settings = {});

  int Columns() const { return this->Tiles.x; }
  int Rows() const { return this->Tiles.y; }
  int Slices() const { return static_cast<int>(this->Depths.size()); }

  std::uint32_t Count() const
  {
    return static_cast<std::uint32_t>(this->Columns() * this->Rows() * this->Slices());
  }

  std::uint32_t ClusterAt(int column, int row, int slice) const
  {
    return static_cast<std::uint32_t>((slice * this->Tiles.y + row) * this->Tiles.x + column);
  }

  /** Returns the cluster of a point (VC), computed as in a shader but in doubles. */
  int ClusterOf(const glm::dvec3& point) const;

  /** Returns the slice that contains the distance -z (VC). */
  int SliceOf(double distance) const;

  int TileSize() const { return this->PixelsPerTile; }
  bool IsParallel() const { return this->HasParallelRays; }

  SliceLaw Law() const { return this->SlicesBy; }

  /**
   * Returns the terms (x, y, z) from which a shader computes the slice of a distance d = -z. The slice is
   * int(clamp(f(d), 0, z - 1)), where f depends on the law:
   * - Exponential: log(d * x) * y
   * - Uniform: (d - x) * y
   * - NdcUniform: x + y / d
   */
  glm::vec4 SliceTerms() const { return this->Terms; }

  /**
   * Returns the scale (x, y) from which a shader computes the tile. The column of n = clip.x / clip.w is
   * int(clamp((n + 1) * x, 0, Columns() - 1)). Rows use y in the same way.
   */
  glm::vec2 TileScale() const { return this->Scale; }

  double Near() const { return this->Ends.front(); }
  double Far() const { return this->Ends.back(); }

  /**
   * Returns the distance at which a slice begins, without widening. The argument Slices() gives the end of the last
   * slice.
   */
  double EndOf(int slice) const { return this->Ends[slice]; }

  /** Returns true if window depth grows with the distance and is the same at all pixels of a distance. */
  bool HasLevelDepths() const;

  /** Returns the window depth of a distance on the view axis: 0 at the near plane and 1 at the far plane. */
  double WindowDepthAt(double distance) const;

  /** Returns the least and the greatest distance of a slice, widened. */
  glm::vec2 DepthsOf(int slice) const { return this->Depths[slice]; }

  /**
   * Return the side planes (VC) of tiles, widened. dot(side, (point, 1)) is the signed distance from the side. It is
   * negative outside.
   */
  const glm::vec4& LeftOf(int column) const { return this->Lefts[column]; }
  const glm::vec4& RightOf(int column) const { return this->Rights[column]; }
  const glm::vec4& BottomOf(int row) const { return this->Bottoms[row]; }
  const glm::vec4& TopOf(int row) const { return this->Tops[row]; }

  /** Returns the outer planes of all clusters together: the picture's four sides and the plane of the eye. */
  std::array<glm::vec4, 5> OuterSides() const
  {
    return { this->Lefts.front(), this->Rights.back(), this->Bottoms.front(), this->Tops.back(),
      glm::vec4(0.0f, 0.0f, -1.0f, -this->Depths.front().x) };
  }

  /** Returns the bounding box (VC) of a cluster, widened. */
  Box BoundsOf(std::uint32_t cluster) const;

  /**
   * Returns the bounding ball of the corners of each cluster, widened: centre (VC) and radius. The balls of the last
   * slice are infinite.
   */
  std::vector<glm::vec4> BallsAround() const;

  /** Returns the column and row of a point (VC), which may be outside the grid. */
  glm::dvec2 TileOf(const glm::dvec3& point) const;

  /**
   * Returns the column of a point (VC) as a real number. It is outside 0 to Columns() for points outside the grid, and
   * may be NaN at the eye.
   */
  float ColumnAt(const glm::vec3& point) const
  {
    const glm::vec4 place(point, 1.0f);
    return Dot(this->ColumnTerms, place) / Dot(this->Weight, place);
  }

  /** Returns the row of a point (VC) as a real number, like ColumnAt(). */
  float RowAt(const glm::vec3& point) const
  {
    const glm::vec4 place(point, 1.0f);
    return Dot(this->RowTerms, place) / Dot(this->Weight, place);
  }

  static float Dot(const glm::vec4& a, const glm::vec4& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
  }

private:
  struct Ray
  {
    glm::dvec3 Origin;
    glm::dvec3 Slope; ///< change of the point per unit of distance

    glm::dvec3 At(double distance) const { return this->Origin + distance * this->Slope; }
  };

  using TileRays = std::array<Ray, 4>;

  void MakeOneCluster(int size);
  bool TakeDepths();
  void MakeSlices(const ClusterSettings& settings);
  void MakeExponential(int slices);
  void SetTerms(double x, double y);
  double SlackAt(double end) const;
  void MakeTiles(const glm::dvec2& size);
  glm::dvec4 SideAt(int axis, double ndc) const;
  Ray RayAt(double ndcX, double ndcY) const;
  TileRays RaysAround(int column, int row) const;

  glm::dmat4 ToClip;
  bool HasParallelRays = false;
  int PixelsPerTile = 1;
  SliceLaw SlicesBy = SliceLaw::Uniform;
  glm::ivec2 Tiles{ 1 };
  glm::vec2 Scale{ 0.0f };
  glm::vec4 Terms{ 0.0f };
  glm::vec4 ColumnTerms{ 0.0f };
  glm::vec4 RowTerms{ 0.0f };
  glm::vec4 Weight{ 0.0f };
  std::vector<double> Ends;
  std::vector<glm::vec2> Depths;
  std::vector<glm::vec4> Lefts, Rights, Bottoms, Tops;
  std::vector<double> LeftEnds, RightEnds, BottomEnds, TopEnds; ///< positions of these sides in NDC
};

}

#endif
