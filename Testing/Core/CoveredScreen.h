/**
 * What one mesh covers of a small screen. Its points are columns, lines and reversed depths themselves.
 */
#ifndef VITRINE_TESTING_COVERED_SCREEN_H
#define VITRINE_TESTING_COVERED_SCREEN_H

#include "CoverageWays.h"
#include "OccluderScenes.h"

#include <gtest/gtest.h>

#include <vector>

namespace coverage
{

using vitrine::SBuffer;
using vitrine::Span;
const int WideColumns = 40;
const int WideLines = 20;
const double Fine = 1e-3; // columns; many times what floats round

inline ScreenMatrix AsItStands(const ScreenMargin& margin = {})
{
  return { glm::dmat4(1.0), glm::vec4(0.0f), margin, { WideColumns, WideLines } };
}

class Covered
{
public:
  explicit Covered(const Way& way, const Triangles& triangles, Facing facing = Facing::Front,
    const ScreenMargin& margin = {})
    : Buffer(WideColumns, WideLines, way.Samples(), MostTestSpans)
  {
    const OccluderMesh mesh = triangles.Mesh();
    MeshProjection projection;
    projection.Project(mesh, AsItStands(margin));
    projection.FindFacings();
    vitrine::FaceCoverage().Insert(this->Buffer, projection, facing, 7);
  }

  double Area() const { return CoveredArea(this->Buffer); }

  bool IsAt(int line, double column) const { return this->DepthAt(line, column) >= 0.0; }

  /** Or -1 where nothing is covered. */
  double DepthAt(int line, double column) const
  {
    for (const Span& span : this->Buffer.SpansOf(line))
    {
      if (span.Left <= column && column < span.Right)
      {
        return span.DepthAt(static_cast<float>(column));
      }
    }
    return -1.0;
  }

  /** At the first sample from a column on. */
  double DepthAtSample(int line, double column) const
  {
    return this->DepthAt(line, this->Buffer.Samples().From(static_cast<float>(column)));
  }

  /** Expects one stretch of spans without a gap in which there are samples, or nothing where `left` equals `right`. */
  void ExpectFromTo(int line, double left, double right) const
  {
    SCOPED_TRACE(line);
    const std::vector<Span> spans = this->Buffer.SpansOf(line);
    if (left == right)
    {
      EXPECT_TRUE(spans.empty());
      return;
    }
    ASSERT_FALSE(spans.empty());
    EXPECT_NEAR(spans.front().Left, left, Fine);
    EXPECT_NEAR(spans.back().Right, right, Fine);
    EXPECT_GE(spans.front().Left, left);
    EXPECT_LE(spans.back().Right, right);
    for (std::size_t i = 0; i + 1 < spans.size(); ++i)
    {
      EXPECT_LE(spans[i].Right, spans[i + 1].Left);
      EXPECT_GE(this->Buffer.Samples().From(spans[i].Right), spans[i + 1].Left);
      EXPECT_EQ(spans[i].Face, 7u);
    }
  }

  SBuffer Buffer;
};

/** Upright, at one depth. */
inline void AddRectangle(
  Triangles& triangles, const glm::dvec2& low, const glm::dvec2& high, double depth)
{
  triangles.AddQuad(
    { low, depth }, { high.x, low.y, depth }, { high, depth }, { low.x, high.y, depth });
}

inline Triangles RectangleOf(const glm::dvec2& low, const glm::dvec2& high, double depth = 0.5)
{
  Triangles triangles;
  AddRectangle(triangles, low, high, depth);
  return triangles;
}

}

#endif
