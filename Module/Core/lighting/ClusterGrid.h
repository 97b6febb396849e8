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

/** Where slices end along the view. */
enum class SliceLaw
{
  Exponential, ///< near (1 + 2 tan(theta) / rows)^k: clusters are about as deep as they are high
  Uniform,     ///< equally deep
  NdcUniform   ///< equal steps of normalised device coordinates (NDC)
};

struct ClusterSettings
{
  int TileSize = 64; ///< in pixels
  int Slices = 16;   ///< at most
  SliceLaw Law = SliceLaw::Exponential;
};

/**
 * What a view shows, cut into tiles of pixels and slices of distance (O. Olsson, M. Billeter, U. Assarsson: Clustered deferred and forward shading,
 * HPG 2012). Where the paper's slices do not reach the far plane, they are made deeper so that they do. In parallel projection slices are uniform.
 *
 * Clusters are a little wider than a shader finds them, so that rounding costs no light; the outermost tiles go on outwards for half a tile, for
 * wide lines and points, the first slice to the eye, the last one to infinity.
 *
 * A projection that is none (not finite, or flat) gives one cluster that is all of space.
 */
class ClusterGrid
{
public:
  /**
   * @param toClip  from view coordinates (VC) to OpenGL's clip coordinates, for column vectors
   * @param width   of the picture in pixels
   * @param height  likewise
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

  /** Where a point is, as a shader finds it, but in doubles. */
  int ClusterOf(const glm::dvec3& point) const;

  /** Which slice a distance -z is in. */
  int SliceOf(double distance) const;

  int TileSize() const { return this->PixelsPerTile; }
  bool IsParallel() const { return this->HasParallelRays; }

  SliceLaw Law() const { return this->SlicesBy; }

  /**
   * What a shader needs to find the slice of a distance d = -z: int(clamp(f(d), 0, z - 1)), where f is
   * Exponential: log(d * x) * y;
   * Uniform: (d - x) * y;
   * NdcUniform: x + y / d.
   */
  glm::vec4 SliceTerms() const { return this->Terms; }

  /** What a shader needs to find the column of clip.x / clip.w = n: int(clamp((n + 1) * x, 0, Columns() - 1)); rows likewise with y. */
  glm::vec2 TileScale() const { return this->Scale; }

  double Near() const { return this->Ends.front(); }
  double Far() const { return this->Ends.back(); }

  /** Where a slice begins, not widened; that of Slices() is where the last one ends. */
  double EndOf(int slice) const { return this->Ends[slice]; }

  /** Whether window depths grow with the distance, and are the same all over the picture. */
  bool HasLevelDepths() const;

  /** From 0 at the near plane to 1 at the far one; where it is not the same all over, in the midst. */
  double WindowDepthAt(double distance) const;

  /** A slice's least and greatest distance, widened. */
  glm::vec2 DepthsOf(int slice) const { return this->Depths[slice]; }

  /** Sides of tiles, widened: what dot(side, (point, 1)) is not negative for lies within; it is the distance from the side. */
  const glm::vec4& LeftOf(int column) const { return this->Lefts[column]; }
  const glm::vec4& RightOf(int column) const { return this->Rights[column]; }
  const glm::vec4& BottomOf(int row) const { return this->Bottoms[row]; }
  const glm::vec4& TopOf(int row) const { return this->Tops[row]; }

  /** The outer sides of all clusters together: four of the picture, and the one that the eye is on. */
  std::array<glm::vec4, 5> OuterSides() const
  {
    return { this->Lefts.front(), this->Rights.back(), this->Bottoms.front(), this->Tops.back(),
      glm::vec4(0.0f, 0.0f, -1.0f, -this->Depths.front().x) };
  }

  /** Around a cluster, widened. */
  Box BoundsOf(std::uint32_t cluster) const;

  /** Around the corners of each cluster: centre and radius, widened. The last slice's are infinite. */
  std::vector<glm::vec4> BallsAround() const;

  /** In which column and row a point is, which may be outside. */
  glm::dvec2 TileOf(const glm::dvec3& point) const;

  /** Which column a point is in, from 0 on; what is outside is less, or more. It may be no number where the point is the eye. */
  float ColumnAt(const glm::vec3& point) const
  {
    const glm::vec4 place(point, 1.0f);
    return Dot(this->ColumnTerms, place) / Dot(this->Weight, place);
  }

  /** The same of rows. */
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
    glm::dvec3 Slope; ///< by distance

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
  std::vector<double> LeftEnds, RightEnds, BottomEnds, TopEnds; ///< the same in NDC
};

}

#endif
