// Lines on which patches may cover something, held to a look at each place.
#include "OccluderScenes.h"

#include "Core/culling/cover/OpenLines.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using coverage::Random;
using coverage::Triangles;
using vitrine::LineRange;
using vitrine::MeshProjection;
using vitrine::OccluderMesh;
using vitrine::OpenLines;
using vitrine::SBuffer;
using vitrine::ScreenMatrix;
using vitrine::ScreenPatches;

const int Columns = 40;
const int Lines = 30;

/** A mesh on the screen; its points are columns, lines and reversed depths. */
struct Shown
{
  explicit Shown(const Triangles& triangles)
    : Mesh(triangles.Mesh())
  {
    const ScreenMatrix toScreen{ glm::dmat4(1.0), glm::vec4(0.0f), { 1e-3f, 1e-3f, 1e-6f },
      { Columns, Lines } };
    this->Projection.Project(this->Mesh, toScreen);
    this->Projection.FindFacings();
    this->Patches.Find(
      this->Projection, MeshProjection::Facing::Front, vitrine::SampleGrid::AtCentres(1));
  }

  OccluderMesh Mesh;
  MeshProjection Projection;
  ScreenPatches Patches;
};

/** Slants from 0.3 on the left to 0.7 on the right. */
Triangles SlantedWall()
{
  Triangles wall;
  wall.AddQuad({ 2, 5, 0.3 }, { 38, 5, 0.7 }, { 38, 25, 0.7 }, { 2, 25, 0.3 });
  return wall;
}

/** All columns of some lines, by what slants as the wall does and is so much nearer. */
SBuffer CoveredBy(float nearer, int first, int last)
{
  SBuffer buffer(Columns, Lines);
  const float slope = 0.4f / 36.0f;
  for (int line = first; line <= last; ++line)
  {
    buffer.Insert(
      line, { 0.0f, Columns, 0.3f - 2.0f * slope + nearer, 0.7f + 2.0f * slope + nearer, 1 });
  }
  return buffer;
}

int CountOpen(const SBuffer& buffer, const Shown& shown, const LineRange& lines)
{
  OpenLines open;
  open.Find(buffer, shown.Patches, lines);
  int count = 0;
  for (int line = lines.First; line <= lines.Last; ++line)
  {
    count += open.IsOpen(line);
  }
  EXPECT_EQ(open.HasAny(), count > 0);
  return count;
}

}

TEST(OpenLines, AreThoseThatAPatchReachesOfAnEmptyBuffer)
{
  const Shown wall(SlantedWall());
  const SBuffer empty(Columns, Lines);
  EXPECT_EQ(CountOpen(empty, wall, { 0, Lines - 1 }), 22) << "from a bit below 5 to a bit above 25";
  EXPECT_EQ(CountOpen(empty, wall, { 7, 17 }), 11) << "of those that are asked for";
  EXPECT_EQ(CountOpen(empty, wall, { 26, Lines - 1 }), 0);
}

// The nearest place of the wall is nearer than the farthest of what covers it.
TEST(OpenLines, AreNoneBehindWhatSlantsAlike)
{
  const Shown wall(SlantedWall());
  EXPECT_EQ(CountOpen(CoveredBy(0.06f, 0, Lines - 1), wall, { 0, Lines - 1 }), 0);
  EXPECT_EQ(CountOpen(CoveredBy(-0.01f, 0, Lines - 1), wall, { 0, Lines - 1 }), 22);
  EXPECT_EQ(CountOpen(CoveredBy(0.06f, 10, 12), wall, { 0, Lines - 1 }), 19);
}

TEST(OpenLines, AreThoseWithAHole)
{
  const Shown wall(SlantedWall());
  SBuffer buffer(Columns, Lines);
  for (int line = 0; line < Lines; ++line)
  {
    const bool hasHole = line == 11;
    buffer.Insert(line, { 0.0f, hasHole ? 33.0f : 40.0f, 0.9f, 0.9f, 1 });
    buffer.Insert(line, { 33.5f, 40.0f, 0.9f, 0.9f, 1 });
  }
  OpenLines open;
  open.Find(buffer, wall.Patches, { 0, Lines - 1 });
  for (int line = 0; line < Lines; ++line)
  {
    EXPECT_EQ(open.IsOpen(line), line == 11) << line;
  }
}

TEST(OpenLines, AreAllWhereAnythingCouldBeInserted)
{
  Random random(21);
  int closed = 0;
  for (int round = 0; round < 300; ++round)
  {
    Triangles faces;
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec3 scale(40.0, 30.0, 1.0);
      faces.Add(scale * random.Point(0.0, 1.0), scale * random.Point(0.0, 1.0),
        scale * random.Point(0.0, 1.0));
    }
    const Shown shown(faces);
    SBuffer buffer(Columns, Lines);
    for (int line = 0; line < Lines; ++line)
    {
      const auto depth = [&] { return static_cast<float>(random.Between(0.4, 1.2)); };
      buffer.Insert(line, { 0.0f, Columns, depth(), depth(), 1 });
    }
    OpenLines open;
    open.Find(buffer, shown.Patches, { 0, Lines - 1 });
    for (int line = 0; line < Lines; ++line)
    {
      closed += !open.IsOpen(line);
      for (std::uint32_t i = 0; i < shown.Patches.Count() && !open.IsOpen(line); ++i)
      {
        const ScreenPatches::Patch& patch = shown.Patches[i];
        const float bottom = std::max(static_cast<float>(line), patch.Bottom);
        const float top = std::min(static_cast<float>(line + 1), patch.Top);
        for (float x = std::max(patch.Left, 0.0f); bottom < top && x < std::min(patch.Right, 40.0f);
             x += 0.25f)
        {
          const vitrine::DepthBound bound = patch.Bound.BoundIn(x, x, bottom, top);
          EXPECT_TRUE(buffer.IsCoveredBefore(
            line, static_cast<int>(x) / SBuffer::TileWidth, bound.Left - 1e-6f))
            << round;
        }
      }
    }
  }
  EXPECT_GT(closed, 300);
}
