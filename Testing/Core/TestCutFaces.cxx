// Tests what is known of faces that a device cuts at the sides of the view, against a device that cuts, rounds and
// snaps as llvmpipe does.
#include "FloatDevice.h"
#include "OccluderScenes.h"

#include "Core/culling/hidden/FaceOnLines.h"
#include "Core/culling/steady/CutFaces.h"
#include "Core/culling/steady/DepthPlane.h"
#include "Core/culling/steady/FaceBlock.h"
#include "Core/culling/steady/SideCuts.h"
#include "Core/culling/steady/SliverDepth.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using coverage::FloatDevice;
using coverage::Random;
using vitrine::DepthPlane;
using vitrine::FaceBlock;
using vitrine::FaceOnLines;
using vitrine::MeshProjection;
using vitrine::ScreenProjection;

constexpr glm::dvec2 CutViewSize(480, 270);
constexpr double CutNear = 1.0, CutFar = 100.0;

/** Column, line and distance from the eye of each corner. */
using FaceInView = std::array<glm::dvec3, 3>;

double TinyLength(Random& random)
{
  return std::pow(10.0, random.Between(-6.0, -1.0));
}

/** Halfway between two places of the grid that corners are snapped to. */
double HalfAStep(double place)
{
  return (std::floor(place * 256.0) + 0.5) / 256.0;
}

/** One corner lies just beyond the right side, so that two are left there, close together. */
FaceInView JustBeyond(Random& random)
{
  const double line = random.Between(10, CutViewSize.y - 10),
               length = std::pow(10.0, random.Between(0, 2.5));
  const double beyond = TinyLength(random);
  return { glm::dvec3(CutViewSize.x + beyond, HalfAStep(line) + random.Between(-1, 1) * beyond, 0),
    glm::dvec3(CutViewSize.x - length, line + random.Between(-length, length), 0),
    glm::dvec3(
      CutViewSize.x - length * random.Between(0.1, 1), line + random.Between(-length, length), 0) };
}

FaceInView AcrossTheView(Random& random)
{
  const glm::dvec3 from(-random.Between(1, 300), random.Between(0, CutViewSize.y), 0);
  const glm::dvec3 to(CutViewSize.x + random.Between(1, 300), random.Between(0, CutViewSize.y), 0);
  const glm::dvec3 beside(random.Between(-1, 1), random.Between(-1, 1), 0);
  return { from, to,
    from + random.Between(0.1, 0.9) * (to - from) + 30.0 * TinyLength(random) * beside };
}

FaceInView AtACornerOfTheView(Random& random)
{
  const double length = std::pow(10.0, random.Between(0, 2.5)), off = 10.0 * TinyLength(random);
  const glm::dvec3 corner(CutViewSize, 0);
  return { corner + off * glm::dvec3(random.Between(-1, 1), random.Between(-1, 1), 0),
    corner + length * glm::dvec3(random.Between(-1, 1), random.Between(-1, 1), 0),
    corner - length * glm::dvec3(random.Between(-1, 1), random.Between(-1, 1), 0) };
}

FaceInView AnywhereInView(Random& random)
{
  FaceInView face;
  for (glm::dvec3& corner : face)
  {
    corner = { random.Between(-200, CutViewSize.x + 200), random.Between(-200, CutViewSize.y + 200),
      0 };
  }
  return face;
}

/** Long and thin, through centres of pixels. */
FaceInView SliverOf(double width, Random& random)
{
  const auto centre = [&](double size) { return std::floor(random.Between(1, size - 1)) + 0.5; };
  const glm::dvec3 from(centre(CutViewSize.x), centre(CutViewSize.y), 0),
    to(centre(CutViewSize.x), centre(CutViewSize.y), 0);
  const double length = glm::length(to - from) + 1e-3;
  const glm::dvec3 along = (to - from) / length, beside(-along.y, along.x, 0);
  return { from - along + random.Between(-0.3, 0.3) * width * beside,
    to + along + random.Between(-0.3, 0.3) * width * beside,
    from + along * random.Between(0, length) + width * beside };
}

FaceInView LongSliver(Random& random)
{
  return SliverOf(std::pow(10.0, random.Between(-3.0, -0.5)), random);
}

struct CutKind
{
  const char* Name;
  FaceInView (*Make)(Random&);
  bool IsCutOften;    ///< so that slivers are left that are drawn off the face's plane
  int LeastOfOneSide; ///< of 40,000 so many that one side cuts, and not close to a corner
};

void PrintTo(const CutKind& kind, std::ostream* stream)
{
  *stream << kind.Name;
}

const CutKind CutKinds[] = { { "JustBeyond", JustBeyond, true, 1000 },
  { "AcrossTheView", AcrossTheView, false, -1 },
  { "AtACornerOfTheView", AtACornerOfTheView, true, -1 },
  { "Anywhere", AnywhereInView, true, 1000 }, { "LongSliver", LongSliver, false, -1 } };

/** A face in a view, in floats, as VTK keeps it; of one in three a corner lies just beyond the far plane. */
struct CutScene
{
  bool IsParallel;
  glm::dmat4 ToClip;
  std::vector<glm::dvec3> Points;

  CutScene(FaceInView face, Random& random)
    : IsParallel(random.OneIn(2))
  {
    double farthest = 0.0;
    for (glm::dvec3& corner : face)
    {
      corner.z = random.Between(2, 60);
      farthest = std::max(farthest, corner.z);
    }
    this->SetFar(random.OneIn(3) ? farthest - TinyLength(random) : CutFar);
    const bool isMirrored = random.OneIn(2), isTurned = random.OneIn(2);
    for (const glm::dvec3& corner : face)
    {
      const glm::dvec2 share = glm::dvec2(corner) / CutViewSize;
      const glm::dvec2 turned = isTurned ? glm::dvec2(share.y, share.x) : share;
      this->Points.push_back(this->PointAt(isMirrored ? 1.0 - turned : turned, corner.z));
    }
  }

  void SetFar(double far)
  {
    const glm::dvec2 half = 0.5 * CutViewSize;
    this->ToClip = this->IsParallel
      ? glm::ortho(-half.x, half.x, -half.y, half.y, CutNear, far)
      : glm::perspective(glm::radians(60.0), half.x / half.y, CutNear, far);
  }

  /** @param share  of the view's width and height */
  glm::dvec3 PointAt(const glm::dvec2& share, double ahead) const
  {
    const double w = this->IsParallel ? 1.0 : ahead;
    return glm::vec3((share.x * 2 - 1) * w / this->ToClip[0][0],
      (share.y * 2 - 1) * w / this->ToClip[1][1], -ahead);
  }

  vitrine::DeviceCoordinates Drawn() const
  {
    glm::dvec3 farthest(0.0);
    for (const glm::dvec3& point : this->Points)
    {
      farthest = glm::max(farthest, glm::abs(point));
    }
    return { glm::dvec3(0.0), farthest, farthest };
  }

  ScreenProjection Projection() const
  {
    const glm::dvec3 reach = this->Drawn().Farthest;
    const float ofColumns = 0.6f / 256 + 0x1p-21f * 480, ofLines = 0.6f / 256 + 0x1p-21f * 270;
    return ScreenProjection(
      this->ToClip, CutViewSize.x, CutViewSize.y, reach, { ofColumns, ofLines, 0x1p-21f });
  }
};

/** What a device draws of many faces of a kind. */
struct DrawnOfKind
{
  int Faces = 0;   ///< of which anything is known
  int Samples = 0; ///< of those
  int FarOff = 0;  ///< nearer than the face is as a whole
};

/** Of a face, by how much cuts may have a device draw it elsewhere; AnyDepth if it is left out. */
using UnsteadyOfFace = float (*)(const MeshProjection&, const FaceBlock&);

float NearestAt(const FaceOnLines& face, const glm::dvec3& drawn, float most)
{
  const auto x = static_cast<float>(drawn.x), y = static_cast<float>(drawn.y);
  return std::min(face.Piece(x, x, y, y).NearestAt(x), most);
}

/** Expects that all that is drawn of a face is known. */
void HoldToDevice(const CutScene& scene, UnsteadyOfFace unsteadyOf, DrawnOfKind& sum)
{
  const vitrine::OccluderMesh mesh(scene.Points, { 0, 1, 2 });
  MeshProjection projection;
  if (!projection.Project(mesh, scene.Projection().Of(glm::dmat4(1.0), scene.Drawn())))
  {
    return;
  }
  FaceBlock block(projection, { 0 }, 0);
  DepthPlane plane(projection, block.Face(0));
  const float unsteady = unsteadyOf(projection, block);
  if (unsteady == vitrine::AnyDepth)
  {
    return;
  }
  const float nearest = block.RectangleOf(0).Nearest;
  const FaceOnLines whole(projection, block, 0);
  block.Unsettle(0, unsteady);
  plane.Unsettle(unsteady);
  const FaceOnLines face(projection, block, 0);
  ++sum.Faces;
  for (const glm::dvec3& drawn : FloatDevice(scene.ToClip, CutViewSize).Draw(scene.Points))
  {
    const auto x = static_cast<float>(drawn.x), y = static_cast<float>(drawn.y);
    ASSERT_LE(drawn.z, NearestAt(face, drawn, block.RectangleOf(0).Nearest) + 1e-7);
    ASSERT_GE(drawn.z, std::min(plane.BoundIn(x, x, y, y).Left, 1.0f) - 1e-7);
    ++sum.Samples;
    sum.FarOff += drawn.z > NearestAt(whole, drawn, nearest) + 1e-7;
  }
}

DrawnOfKind DrawKind(const CutKind& kind, UnsteadyOfFace unsteadyOf)
{
  Random random(11);
  DrawnOfKind sum;
  for (int i = 0; i < 40000 && !testing::Test::HasFatalFailure(); ++i)
  {
    SCOPED_TRACE(testing::Message() << "seed 11, face " << i);
    HoldToDevice(CutScene(kind.Make(random), random), unsteadyOf, sum);
  }
  return sum;
}

class CutFacesOfKind : public testing::TestWithParam<CutKind>
{
};

TEST_P(CutFacesOfKind, AreNowhereElseThanIsKnown)
{
  const DrawnOfKind drawn = DrawKind(GetParam(),
    [](const MeshProjection& projection, const FaceBlock&)
    {
      vitrine::CutFaces cuts;
      cuts.Begin(projection, vitrine::SampleGrid::AtCentres(1));
      return cuts.UnsteadyOf(0u);
    });
  EXPECT_GT(drawn.Samples, 10000);
  EXPECT_EQ(drawn.FarOff > 5, GetParam().IsCutOften)
    << drawn.FarOff << " are nearer than the face is as a whole";
}

TEST_P(CutFacesOfKind, AreKnownEightAtATimeWhereOneSideCutsThem)
{
  const DrawnOfKind drawn = DrawKind(GetParam(),
    [](const MeshProjection& projection, const FaceBlock& block)
    { return vitrine::SideCuts(projection).UnsteadyOf(block)[0]; });
  EXPECT_GT(drawn.Faces, GetParam().LeastOfOneSide);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CutFacesOfKind, testing::ValuesIn(CutKinds),
  [](const testing::TestParamInfo<CutKind>& info) { return info.param.Name; });

// Of many that floats tell nothing of.
TEST(SliversInView, AreNoNearerThanDoublesTell)
{
  Random random(13);
  int samples = 0, inDoublesAlone = 0, unknown = 0;
  for (int i = 0; i < 100000; ++i)
  {
    SCOPED_TRACE(testing::Message() << "seed 13, face " << i);
    const CutScene scene(SliverOf(std::pow(10.0, random.Between(-5.0, -1.5)), random), random);
    const vitrine::OccluderMesh mesh(scene.Points, { 0, 1, 2 });
    MeshProjection projection;
    if (!projection.Project(mesh, scene.Projection().Of(glm::dmat4(1.0), scene.Drawn())) ||
      projection.MayBeCut(mesh.Faces()[0]))
    {
      continue;
    }
    const float told = vitrine::NearestInDoubles(projection, mesh.Faces()[0]);
    unknown += told > 1.0f;
    inDoublesAlone += told < 1.0f && FaceBlock(projection, { 0 }, 0).RectangleOf(0).Nearest > 1.0f;
    for (const glm::dvec3& drawn : FloatDevice(scene.ToClip, CutViewSize).Draw(scene.Points))
    {
      ASSERT_LE(drawn.z, told + 1e-7);
      ++samples;
    }
  }
  EXPECT_GT(samples, 20000);
  EXPECT_GT(inDoublesAlone, 1000);
  EXPECT_GT(unknown, 100) << "the thinnest";
}

// Walls that are as far everywhere hide what is behind them wherever they are cut.
TEST(CutFaces, OfALevelWallAreWhereItIs)
{
  for (const double beyond : { 0.1, 1.0, 5.0 })
  {
    const double x = CutViewSize.x / 2 + beyond * CutViewSize.x,
                 y = CutViewSize.y / 2 + 1.3 * beyond * CutViewSize.y;
    const vitrine::OccluderMesh mesh(
      { { -x, -y, -20 }, { x, -y, -20 }, { x, y, -20 }, { -x, y, -20 } }, { 0, 1, 2, 0, 2, 3 });
    const glm::dmat4 toClip = glm::ortho(-CutViewSize.x / 2, CutViewSize.x / 2, -CutViewSize.y / 2,
      CutViewSize.y / 2, CutNear, CutFar);
    const ScreenProjection view(
      toClip, CutViewSize.x, CutViewSize.y, { x, y, 20 }, { 1.0f / 256, 1.0f / 256, 0x1p-21f });
    MeshProjection projection;
    ASSERT_TRUE(projection.Project(mesh, view.Of(glm::dmat4(1.0))));
    vitrine::CutFaces cuts;
    cuts.Begin(projection, vitrine::SampleGrid::AtCentres(1));
    for (std::uint32_t face = 0; face < 2; ++face)
    {
      EXPECT_LT(cuts.UnsteadyOf(face), 0.01f) << beyond << " of the view, face " << face;
    }
  }
}

// Cutting off a corner leaves two new corners on the side of the view. If a third one is as close to the side as places
// are rounded, a triangle without area may remain.
TEST(CutFaces, AreNotKnownWhereAllCornersMayLieOnASide)
{
  const auto unsteadyWithin = [](double inside)
  {
    const glm::dvec2 half = 0.5 * CutViewSize;
    const glm::dmat4 toClip = glm::ortho(-half.x, half.x, -half.y, half.y, CutNear, CutFar);
    const double step = 0.6 / 256;
    const ScreenProjection view(
      toClip, CutViewSize.x, CutViewSize.y, { 240, 135, 20 }, { 0.6f / 256, 0.6f / 256, 0x1p-21f });
    const vitrine::OccluderMesh mesh({ { half.x - inside * step, 0, -20 },
                                       { half.x + 0.3 * step, 4, -20 }, { half.x - 3, 2, -20 } },
      { 0, 1, 2 });
    MeshProjection projection;
    projection.Project(mesh, view.Of(glm::dmat4(1.0)));
    vitrine::CutFaces cuts;
    cuts.Begin(projection, vitrine::SampleGrid::AtCentres(1));
    return cuts.UnsteadyOf(0u);
  };
  EXPECT_EQ(unsteadyWithin(2.1), vitrine::AnyDepth);
  EXPECT_LT(unsteadyWithin(200.0), 0.1f);
}

TEST(CutFaces, AreThoseThatReachBeyondTheView)
{
  const glm::dmat4 toClip = glm::ortho(
    -CutViewSize.x / 2, CutViewSize.x / 2, -CutViewSize.y / 2, CutViewSize.y / 2, CutNear, CutFar);
  const ScreenProjection view(toClip, CutViewSize.x, CutViewSize.y, { 1000, 1000, 200 },
    { 1.0f / 256, 1.0f / 256, 0x1p-21f });
  const auto mayBeCut =
    [](const ScreenProjection& seenBy, const glm::dvec3& low, const glm::dvec3& high)
  {
    const vitrine::OccluderMesh mesh({ low, { high.x, low.y, low.z }, high }, { 0, 1, 2 });
    MeshProjection projection;
    projection.Project(mesh, seenBy.Of(glm::dmat4(1.0)));
    return projection.MayBeCut() && projection.MayBeCut(mesh.Faces()[0]);
  };
  EXPECT_FALSE(mayBeCut(view, { -200, -100, -20 }, { 200, 100, -30 }));
  EXPECT_TRUE(mayBeCut(view, { -250, -100, -20 }, { 200, 100, -30 })) << "left";
  EXPECT_TRUE(mayBeCut(view, { -200, -100, -20 }, { 250, 100, -30 })) << "right";
  EXPECT_TRUE(mayBeCut(view, { -200, -140, -20 }, { 200, 100, -30 })) << "below";
  EXPECT_TRUE(mayBeCut(view, { -200, -100, -20 }, { 200, 140, -30 })) << "above";
  EXPECT_TRUE(mayBeCut(view, { -200, -100, -20 }, { 200, 100, -130 })) << "beyond the far plane";
  EXPECT_TRUE(mayBeCut(view, { -200, -100, -0.5 }, { 200, 100, -30 })) << "before the near plane";
  EXPECT_FALSE(mayBeCut(view, { 250, -100, -20 }, { 260, 100, -30 })) << "beside the view";
  const ScreenProjection band = view.OfLines(100, 50);
  EXPECT_FALSE(mayBeCut(band, { -200, -100, -20 }, { 200, 100, -30 }))
    << "no device cuts at a band";
  EXPECT_TRUE(mayBeCut(band, { -200, -140, -20 }, { 200, 100, -30 }));
  EXPECT_TRUE(mayBeCut(band, { -200, -100, -20 }, { 200, 140, -30 }));
}

}
