// Boxes around runs of faces: they hold all faces, and a part is hidden by them only where nothing of it is seen.
#include "NonFinite.h"
#include "PartScenes.h"

#include "Core/culling/hidden/BoxesHidden.h"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using coverage::AheadView;
using coverage::CullAhead;
using coverage::FrameColumns;
using coverage::FrameLines;
using coverage::GridOf;
using coverage::PartScene;
using coverage::Random;
using coverage::SightLines;
using coverage::Triangles;
using coverage::View;
using coverage::ViewOfHeap;
using coverage::WallAt;
using vitrine::Box;
using vitrine::MeshBoxes;
using vitrine::OccluderMesh;
using vitrine::PartCuller;

/** The boxes in which there are none, and that those of the second level lie in those of the first. */
std::vector<Box> LeavesOf(const MeshBoxes& boxes)
{
  std::vector<Box> leaves;
  for (std::size_t i = 0; i < boxes.Nodes().size(); ++i)
  {
    const MeshBoxes::Node& node = boxes.Nodes()[i];
    for (int lane = 0; lane < node.Count; ++lane)
    {
      if (node.Nodes[lane] == MeshBoxes::NoNode)
      {
        leaves.push_back(node.Boxes.At(lane));
      }
      else
      {
        EXPECT_EQ(i, 0u) << "there are two levels";
        EXPECT_EQ(boxes.Nodes()[node.Nodes[lane]].Boxes.Bounds(), node.Boxes.At(lane));
      }
    }
  }
  return leaves;
}

Box BoxOf(const OccluderMesh& mesh, const OccluderMesh::Face& face)
{
  Box box;
  for (const std::uint32_t point : face)
  {
    const glm::vec3 place(
      mesh.Coordinates(0)[point], mesh.Coordinates(1)[point], mesh.Coordinates(2)[point]);
    box.Add({ place, place });
  }
  return box;
}

/** A rod along x, from -1 to 1, of so many quads on each of four sides. */
Triangles RodOf(int count, double half = 0.02)
{
  Triangles rod;
  for (int side = 0; side < 4; ++side)
  {
    const auto corner = [&](int turn)
    { return half * glm::dvec2(turn % 4 == 0 || turn % 4 == 3 ? 1 : -1, turn % 4 < 2 ? 1 : -1); };
    const glm::dvec2 a = corner(side), b = corner(side + 1);
    const Triangles quads = GridOf(
      count, 1, [&](double u, double v) { return glm::dvec3(2.0 * u - 1.0, glm::mix(a, b, v)); });
    for (std::size_t i = 0; i < quads.Corners.size(); i += 3)
    {
      const std::uint32_t* corners = &quads.Corners[i];
      rod.Add(quads.Points[corners[0]], quads.Points[corners[1]], quads.Points[corners[2]]);
    }
  }
  return rod;
}

/** A wall at -20 that covers all above the diagonal of the view through its middle, if `offset` is 0. */
Triangles WallAboveDiagonal(double offset)
{
  Triangles wall;
  wall.Add({ -90, -90 - offset, -20 }, { 90, 90 - offset, -20 }, { -90, 90, -20 });
  return wall;
}

/** Along the diagonal of the view, at -40. */
glm::dmat4 AlongDiagonal(double half)
{
  const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -40));
  return glm::scale(
    glm::rotate(away, glm::pi<double>() / 4.0, glm::dvec3(0, 0, 1)), glm::dvec3(half));
}

/**
 * Returns meshes of many points within -10 .. 10. Some are flat, some mirrored, some lack a few faces, and there are a
 * few walls.
 */
PartScene HeapOfLarge(int count, Random& random)
{
  PartScene scene;
  for (int i = 0; i < count; ++i)
  {
    Triangles mesh = random.OneIn(3) ? RodOf(12 + random.Below(60), random.Between(0.01, 0.2))
      : random.OneIn(2)              ? coverage::BallOf(12, 8, random.Between(0.2, 1.0), random)
                                     : coverage::SoupOf(40, random);
    if (random.OneIn(4))
    {
      coverage::Damage(mesh, random);
    }
    glm::dmat4 toWorld = glm::translate(glm::dmat4(1.0), random.Point(-8, 8));
    toWorld = glm::rotate(toWorld, random.Between(0, 6), random.Point(-1, 1) + glm::dvec3(1.01));
    toWorld = glm::scale(toWorld, random.Point(0.3, 4.0));
    scene.Add(mesh, random.OneIn(5) ? glm::scale(toWorld, glm::dvec3(1, -1, 1)) : toWorld);
  }
  for (int i = 0; i < 14; ++i)
  {
    const glm::dvec3 low = random.Point(-10, 0);
    glm::dvec3 size = random.Point(5, 12);
    size[random.Below(3)] = 0.1;
    scene.AddBox(low, low + size);
  }
  return scene;
}

}

TEST(MeshBoxes, OfARodLieOneAfterTheOther)
{
  const MeshBoxes boxes(RodOf(64, 1e-3).Mesh()); // 512 faces
  ASSERT_EQ(boxes.Nodes().size(), 9u);
  EXPECT_EQ(boxes.Nodes()[0].Count, 8);
  std::vector<Box> leaves = LeavesOf(boxes);
  ASSERT_EQ(leaves.size(), 64u);
  double length = 0.0;
  for (const Box& leaf : leaves)
  {
    length += leaf.Max.x - leaf.Min.x;
  }
  EXPECT_NEAR(
    length, 2.0, 1e-4); // of halves at the median, none of which has a face in common with another
}

TEST(MeshBoxes, HoldAllFacesAndNothingElse)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    Triangles triangles = coverage::RandomTriangles(random);
    coverage::Damage(triangles, random);
    const OccluderMesh mesh = triangles.Mesh();
    const MeshBoxes boxes(mesh);
    const std::vector<Box> leaves = LeavesOf(boxes);
    Box around, ofFaces;
    for (const OccluderMesh::Face& face : mesh.Faces())
    {
      const Box box = BoxOf(mesh, face);
      ofFaces.Add(box);
      EXPECT_TRUE(std::any_of(leaves.begin(), leaves.end(),
        [&](const Box& leaf) { return vitrine::Contains(leaf, box); }));
    }
    for (const Box& leaf : leaves)
    {
      around.Add(leaf);
    }
    EXPECT_EQ(around, ofFaces);
    EXPECT_LE(boxes.Nodes().size(), 9u);
  }
}

TEST(MeshBoxes, TakeTwoNodesOfEightAtTheMost)
{
  const MeshBoxes boxes(RodOf(3000).Mesh());
  EXPECT_EQ(boxes.Nodes().size(), 9u);
  EXPECT_LE(boxes.Bytes(), 4096u);
}

TEST(MeshBoxes, OfNothingHideNothing)
{
  vitrine::SBuffer lines(FrameColumns, FrameLines);
  const auto view = AheadView(false).Projection(100.0);
  EXPECT_FALSE(AreBoxesHidden(MeshBoxes(), lines, view, glm::dmat4(1.0)));
  EXPECT_FALSE(AreBoxesHidden(MeshBoxes(OccluderMesh()), lines, view, glm::dmat4(1.0)));
}

// All centres are at one place: any halves do.
TEST(MeshBoxes, OfFacesAtOnePlace)
{
  Triangles star;
  for (int i = 1; i <= 100; ++i)
  {
    const double size = i;
    star.Add({ -size, -size, 0 }, { size, -size, 0 }, { 0, size, 0 });
  }
  const MeshBoxes boxes(star.Mesh());
  EXPECT_GE(LeavesOf(boxes).size(), 8u);
  EXPECT_LE(boxes.Nodes().size(), 9u);
}

// So close to the edge that boxes of the first level stand over it, too.
TEST(MeshBoxes, HideARodBehindASlantedEdgeThatItsBoxStandsOver)
{
  for (const bool isParallel : { false, true })
  {
    for (const double mirror : { 1.0, -1.0 })
    {
      SCOPED_TRACE(isParallel);
      SCOPED_TRACE(mirror);
      PartScene scene;
      scene.Add(WallAboveDiagonal(1.25));
      const glm::dmat4 place =
        glm::scale(AlongDiagonal(isParallel ? 8.0 : 16.0), glm::dvec3(1, mirror, 1));
      const std::uint32_t rod = scene.Add(RodOf(64, 0.005), place);
      const std::uint32_t without = scene.Add(RodOf(64, 0.005), place);
      scene.Parts[without].Boxes.reset();
      scene.Parts[without].IsOfFacesAlone = false;
      CullAhead(scene, isParallel);
      EXPECT_FALSE(scene.Visible[rod]);
      EXPECT_TRUE(scene.Visible[without]);
    }
  }
}

TEST(MeshBoxes, ShowAPartOfWhichOneFaceShows)
{
  const glm::dvec3 offset(30, -20, 10); // of the mesh, in model coordinates
  for (const double x : { -1.0, -0.4, 0.0, 0.7, 1.0 })
  {
    SCOPED_TRACE(x);
    PartScene scene;
    scene.Add(WallAboveDiagonal(2.0));
    Triangles rod = RodOf(64);
    rod.Add({ x, -0.05, 0.0 }, { x, -0.4, 0.01 }, { x + 0.001, -0.4, 0.0 });
    for (glm::dvec3& point : rod.Points)
    {
      point += offset;
    }
    const std::uint32_t part = scene.Add(rod, glm::translate(AlongDiagonal(8.0), -offset));
    CullAhead(scene, true);
    EXPECT_TRUE(scene.Visible[part]);
  }
}

// From one side of the view to the other, around it.
TEST(MeshBoxes, LieOutsideOfAViewThatTheyGoAround)
{
  const Triangles frame = GridOf(200, 1,
    [](double u, double v)
    {
      const double radius = v > 0.5 ? 41.0 : 40.0;
      return glm::dvec3(radius * std::cos(6.3 * u), radius * std::sin(6.3 * u), -30.0);
    });
  const vitrine::SBuffer lines(FrameColumns, FrameLines); // that hides nothing
  const MeshBoxes boxes(frame.Mesh());
  const auto view = AheadView(true).Projection(100.0);
  EXPECT_TRUE(AreBoxesHidden(boxes, lines, view, glm::dmat4(1.0)));
  EXPECT_FALSE(
    AreBoxesHidden(boxes, lines, view, glm::scale(glm::dmat4(1.0), glm::dvec3(0.3, 0.3, 1))));
}

// Behind the eye they would be in the middle of the view, and far away.
TEST(MeshBoxes, ThatReachBeforeTheNearPlaneShow)
{
  vitrine::SBuffer lines(FrameColumns, FrameLines);
  for (int line = 0; line < FrameLines; ++line)
  {
    lines.Insert(line, { 0.0f, FrameColumns, 0.9f, 0.9f, 1 });
  }
  const Triangles floor =
    GridOf(40, 1, [](double u, double v) { return glm::dvec3(2 * u - 1, -0.3, 60 * v - 30); });
  const MeshBoxes boxes(floor.Mesh());
  const auto view = AheadView(false).Projection(100.0);
  EXPECT_FALSE(AreBoxesHidden(boxes, lines, view, glm::dmat4(1.0)));
  EXPECT_TRUE(
    AreBoxesHidden(boxes, lines, view, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -40))));
}

// Elements of a matrix that are infinite, as coordinates are next to nothing.
TEST(MeshBoxes, OfMoreThanFloatsHoldShow)
{
  for (const double size : { 1e-36, 1e-37, 1e-38, 1e-39, 1e-40 })
  {
    for (const double turn : { 0.0, 45.0, 225.0 })
    {
      SCOPED_TRACE(testing::Message() << size << " turned by " << turn);
      PartScene scene;
      const std::uint32_t part = scene.Add(
        GridOf(12, 12,
          [size](double u, double v) { return size * glm::dvec3(12 * u - 6, 12 * v - 6, 0); }),
        glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -30)),
                     glm::radians(turn), glm::dvec3(0, 0, 1)),
          glm::dvec3(1.0 / size)));
      CullAhead(scene, true);
      EXPECT_TRUE(scene.Visible[part]);
    }
  }
}

TEST(MeshBoxes, WhoseMatrixIsNoneShow)
{
  for (int element = 0; element < 16; ++element)
  {
    SCOPED_TRACE(element);
    PartScene scene;
    scene.Add(WallAboveDiagonal(2.0));
    const std::uint32_t rod = scene.Add(RodOf(64), AlongDiagonal(8.0));
    scene.Parts[rod].ToWorld[element / 4][element % 4] = NotANumber;
    CullAhead(scene, false);
    EXPECT_TRUE(scene.Visible[rod]);
  }
}

// A rod whose edge is level with the wall's is hidden if it is drawn lower by more than a device, or a line's width,
// may move it.
TEST(MeshBoxes, AreAsWideAsWhatIsDrawn)
{
  const double pixel = 20.0 / FrameLines * 0.9;
  for (const double growth : { 0.0, 2.0 })
  {
    for (const double margin : { 0.5, 3.0 })
    {
      PartScene scene;
      scene.Add(WallAboveDiagonal(0.0));
      const double below = std::sqrt(0.5) * margin * pixel; // of the diagonal wall's edge
      const std::uint32_t rod = scene.Add(RodOf(64, 1e-3),
        glm::translate(glm::dmat4(1.0), glm::dvec3(-below, below, 0)) * AlongDiagonal(6.0));
      const View view = AheadView(true);
      PartCuller culler(FrameColumns, FrameLines);
      culler.Cull(vitrine::LooseOctree(scene.Bounds), scene,
        vitrine::ScreenProjection(
          view.ToClip, view.Columns, view.Lines, glm::dvec3(scene.Reach), {}, glm::vec2(growth)),
        true, scene.Visible);
      EXPECT_EQ(scene.Visible[rod], margin < 1.0 || growth > 1.0) << margin << ' ' << growth;
    }
  }
}

TEST(MeshBoxes, LoseNothingThatIsSeen)
{
  int culled = 0, more = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    SCOPED_TRACE(seed);
    Random random(seed);
    PartScene scene = HeapOfLarge(40, random);
    for (PartScene::Part& part : scene.Parts)
    {
      part.IsOfFacesAlone = false; // else faces are tested as well, and hide all that boxes do
    }
    const View view = ViewOfHeap(random);
    const std::vector<std::uint8_t> drawn = scene.Visible;
    PartCuller culler(view.Columns, view.Lines);
    scene.Cull(culler, view);
    const SightLines sight(scene, drawn, view);
    for (std::uint32_t i = 0; i < scene.Parts.size(); ++i)
    {
      if (!scene.Visible[i])
      {
        ASSERT_FALSE(sight.Sees(i, 200, random)) << "part " << i;
        ++culled;
        ++more;
      }
    }
    for (PartScene::Part& part : scene.Parts)
    {
      part.Boxes.reset();
    }
    scene.Visible = drawn;
    PartCuller without(view.Columns, view.Lines);
    scene.Cull(without, view);
    more -= static_cast<int>(std::count(scene.Visible.begin(), scene.Visible.end(), 0));
  }
  EXPECT_GT(culled, 120);
  EXPECT_GT(more, 30);
}
