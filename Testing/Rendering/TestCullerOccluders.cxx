// What the culler takes for a cover, and what lies behind it: no pixel is lost.
#include "CullerScene.h"
#include "vtkCellArray.h"
#include "vtkCylinderSource.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

class CullerOccluders : public CullerTest
{
};

// Bars both ways over [-1.2, x1] x [-1.2, 1.2], with square holes in between.
std::vector<Quad> WireMesh(double x1, double hole, double wire)
{
  std::vector<Quad> bars;
  for (double at = -1.2; at < 1.2; at += hole + wire)
  {
    bars.push_back(Rectangle(-1.2, at, x1, at + wire, 0.0));
    if (at + wire < x1)
    {
      bars.push_back(Rectangle(at, -1.2, at + wire, 1.2, 0.0));
    }
  }
  return bars;
}

// Rows of a wall that are cut in unlike numbers of columns: no corner of one is a corner of the next.
std::vector<Quad> RowsOfUnlikeCuts(std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<Quad> cells;
  for (int row = 0; row < 8; ++row)
  {
    const auto columns = 1 + static_cast<int>(random.Next() % 7);
    for (int column = 0; column < columns; ++column)
    {
      cells.push_back(Rectangle(-1.5 + 3.0 * column / columns, -1.5 + 0.375 * row,
        -1.5 + 3.0 * (column + 1) / columns, -1.5 + 0.375 * (row + 1), 0.0));
    }
  }
  return cells;
}

vtkSmartPointer<vtkMatrix4x4> MatrixOf(const std::array<double, 16>& elements)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(elements.data());
  return matrix;
}

std::vector<vtkSmartPointer<vtkMatrix4x4>> OddMatrices()
{
  return {
    MatrixOf({ -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }),         // mirrored
    MatrixOf({ 1, 0.4, 0, 0.1, -0.2, 1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1 }), // sheared
    MatrixOf({ 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }),          // flat
    MatrixOf({ 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 }),          // a point
    MatrixOf({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.05, 0, 1 }),     // projective
    MatrixOf({ 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2 }),          // of another w
    MatrixOf({ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1 }),         // of a negative one
    MatrixOf({ NaN, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }),
    MatrixOf({ 1, 0, 0, 0, 0, 1, 0, Infinity, 0, 0, 1, 0, 0, 0, 0, 1 }),
  };
}

TEST_P(CullerOccluders, SlitsOfOneMesh)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(MeshOf({}));
  Scene.AddHidden();
  for (const double width : { 1.0, 0.3, 0.01 })
  {
    SCOPED_TRACE(width);
    static_cast<vtkPolyDataMapper*>(wall->GetMapper())
      ->SetInputData(MeshOf(StripsBetweenSlits(width * Scene.PixelSize(), 1)));
    Scene.ExpectHidden(101);
  }
}

TEST_P(CullerOccluders, SlitsBetweenActors)
{
  for (const Quad& strip : StripsBetweenSlits(0.3 * Scene.PixelSize(), 2))
  {
    Scene.AddMesh(MeshOf({ strip }));
  }
  Scene.AddHidden();
  Scene.ExpectHidden(102, 6);
}

TEST_P(CullerOccluders, MeshOfWires)
{
  int most = 0;
  for (const double size : { 1.2, 0.7, 0.3 })
  {
    Scene.Clear();
    const double hole = size * Scene.PixelSize();
    Scene.AddMesh(MeshOf(WireMesh(1.2, hole, 2.0 * hole)));
    Scene.AddHidden();
    if (Scene.Setting.Samples > 1)
    {
      Scene.ExpectNothingHidden(103, 2);
    }
    else // wires may cover all centres of pixels of a part
    {
      most = std::max(most, Scene.ExpectSameAround(103, 2));
    }
    Scene.AddWall(0.1);
    EXPECT_GT(Scene.ExpectSame(), 60) << "a wall in front of the wires hides all";
  }
  EXPECT_EQ(most > 20, Scene.Setting.Samples == 0) << most;
}

TEST_P(CullerOccluders, MeshOfWiresBesideAPlate)
{
  Scene.AddMesh(MeshOf(WireMesh(0.1, 0.4 * Scene.PixelSize(), Scene.PixelSize())));
  Scene.AddMesh(MeshOf({ Rectangle(0.1, -1.2, 1.2, 1.2, 0.0) }));
  Scene.AddHidden();
  Scene.ExpectHidden(104);
}

// A part as wide as the view, seen through an opening in a corner or at an edge of the viewport alone.
TEST_P(CullerOccluders, OpeningAtTheEdgeOfTheView)
{
  const double top = 0.5 * Scene.PixelSize() * Scene.Setting.Height;
  const double right = top * Scene.Setting.Width / Scene.Setting.Height;
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(MeshOf({}));
  Scene.AddBox({ 0.0, 0.0, -1.0 }, { 5.0, 5.0, 0.1 });
  Scene.AddHidden();
  for (const double pixels : { 0.2, 1.0, 1.6 })
  {
    const double opening = pixels * Scene.PixelSize();
    for (const int side : { 0, 1, 2, 3 })
    {
      SCOPED_TRACE(std::to_string(pixels) + " pixels at side " + std::to_string(side));
      const double x0 = side == 0 ? -right + opening : -3.0;
      const double x1 = side == 1 ? right - opening : 3.0;
      const double y0 = side == 2 ? -top + opening : -3.0;
      const double y1 = side == 3 ? top - opening : 3.0;
      vtkNew<vtkPolyDataMapper> mapper; // one that is given other data all the time hides nothing
      wall->SetMapper(mapper);
      mapper->SetInputData(MeshOf({ Rectangle(x0, y0, x1, y1, 0.0) }));
      EXPECT_GE(Scene.ExpectSame(), 20);
      mapper->SetInputData(MeshOf({ Rectangle(x0, -3.0, x1, top - opening, 0.0),
        Rectangle(x0, top - opening, x1 - 0.5, 3.0, 0.0) })); // a corner, too
      EXPECT_GE(Scene.ExpectSame(), 20);
    }
  }
}

TEST_P(CullerOccluders, PlatesThatTouchAndCoincide)
{
  // Four plates that touch make a wall; over it another one that coincides.
  for (const double x : { -1.5, 0.0 })
  {
    for (const double y : { -1.5, 0.0 })
    {
      Scene.AddMesh(MeshOf({ Rectangle(x, y, x + 1.5, y + 1.5, 0.0) }));
    }
  }
  Scene.AddMesh(MeshOf({ Rectangle(-1.1, -0.9, 0.8, 1.1, 0.0) }), { 0.2, 0.3, 0.9, 1.0 });
  Scene.AddMesh(MeshOf({ Rectangle(-1.0, -0.7, 0.9, 1.2, 1e-7) }), { 0.2, 0.9, 0.9, 1.0 });
  for (int twice = 0; twice < 2; ++twice)
  {
    Scene.AddHidden();
    Scene.AddHidden(-0.02); // their faces lie in the plane of the wall
    Scene.AddHidden(-0.02 - 1e-7);
  }
  Scene.ExpectHidden(106, 5);
}

TEST_P(CullerOccluders, CornersThatAreNoCorners)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddMesh(MeshOf(RowsOfUnlikeCuts(3)));
  Scene.AddHidden();
  Scene.ExpectHidden(107);
  wall->RotateZ(17.3);
  wall->RotateX(3.1);
  Scene.ExpectHidden(108, 5);
}

/** In turn strips, slivers and nothing at all. */
std::vector<Quad> StripsAndSlivers()
{
  TestRandom random(4);
  std::vector<Quad> strips;
  double left = -1.5;
  for (int i = 0; i < 60; ++i)
  {
    const double right = left +
      (i % 3 == 0      ? 0.05 + 0.15 * random.Unit()
          : i % 3 == 1 ? 1e-7
                       : 0.0);
    strips.push_back(Rectangle(left, -1.5, right, 1.5, 0.0));
    left = right;
  }
  strips.push_back(Rectangle(left, -1.5, 1.5, 1.5, 0.0));
  return strips;
}

TEST_P(CullerOccluders, Slivers)
{
  Scene.AddMesh(MeshOf(StripsAndSlivers()));
  Scene.AddHidden();
  Scene.ExpectHidden(109);
}

// What a device draws of slivers at a slant has any depth, so little of such a wall hides.
TEST_P(CullerOccluders, SliversAtASlant)
{
  Scene.AddMesh(MeshOf(StripsAndSlivers()))->RotateZ(-38.7);
  Scene.AddHidden();
  Scene.ExpectHidden(110, 5);
}

/** Right behind height 0 and seen from straight ahead: a plate that looks so thin, across the middle of the screen. */
vtkSmartPointer<vtkPolyData> PlateSeenFromItsEdge(double thickness)
{
  const double low = -0.5 * thickness, high = 0.5 * thickness, near = -0.02, far = -0.52;
  return MeshOf(
    { { { { -0.2, low, near }, { 0.2, low, near }, { 0.2, high, far }, { -0.2, high, far } } } });
}

// A device may draw slivers of less than what it snaps by, 1/256 pixel, nearer than all of their corners.
TEST_P(CullerOccluders, SliversRightBehindAWall)
{
  Scene.AddWall();
  Scene.LookAhead();
  Scene.PutSampleInMiddle();
  for (const auto& [pixels, hidden] : { std::pair(1.0 / 1000.0, 0), std::pair(0.5, 1) })
  {
    const vtkSmartPointer<vtkActor> plate =
      Scene.AddMesh(PlateSeenFromItsEdge(pixels * Scene.PixelSize()));
    EXPECT_EQ(Scene.ExpectSame(), hidden) << pixels << " pixels";
    Scene.Renderer->RemoveActor(plate);
  }
}

TEST_P(CullerOccluders, PartsThatCutEachOther)
{
  TestRandom random(5);
  for (int i = 0; i < 40; ++i)
  {
    const double x = 2.0 * random.Unit() - 1.0, y = 2.0 * random.Unit() - 1.0;
    const vtkSmartPointer<vtkActor> box =
      Scene.AddBox({ x, y, 0.3 * random.Unit() }, { 0.7, 0.5, 0.2 });
    box->SetOrientation(360.0 * random.Unit(), 360.0 * random.Unit(), 360.0 * random.Unit());
  }
  Scene.AddHidden(-0.8);
  Scene.ExpectHidden(111, 5);
}

TEST_P(CullerOccluders, EachPartBehindTheNext)
{
  for (int i = 0; i < 3; ++i) // beams that lie on each other in a circle
  {
    const double turn = i * 2.0943951;
    const vtkSmartPointer<vtkActor> beam =
      Scene.AddBox({ 0.45 * std::cos(turn), 0.45 * std::sin(turn), 0.3 }, { 0.45, 2.2, 0.05 });
    beam->SetOrientation(8.0, 0.0, 120.0 * i);
  }
  Scene.AddHidden();
  Scene.ExpectHidden(112, 5);
}

TEST_P(CullerOccluders, ShaftInAHole)
{
  for (int i = 0; i < 12; ++i)
  {
    const double x = -0.9 + 0.6 * (i % 4), y = -0.6 + 0.6 * (i / 4);
    for (const double radius : { 0.3, 0.25 + 1e-3, 0.25 }) // shafts of a hub, a little too thick
    {
      vtkNew<vtkCylinderSource> shaft;
      shaft->SetResolution(radius == 0.25 ? 17 : 24);
      shaft->SetRadius(radius);
      shaft->SetHeight(radius > 0.26 ? 0.2 : 0.4);
      shaft->SetCapping(radius < 0.251);
      const vtkSmartPointer<vtkActor> actor = Scene.AddSource(shaft, { 0.4, radius, 0.6, 1.0 });
      actor->SetPosition(x, y, 0.0);
      actor->RotateX(90.0);
    }
  }
  Scene.AddHidden(-0.7);
  Scene.ExpectHidden(113, 5);
}

TEST_P(CullerOccluders, PointsThatAreNoNumbers)
{
  for (const double odd : { NaN, Infinity, -Infinity, 1e30, 1e38, 1e300 })
  {
    SCOPED_TRACE(odd);
    Scene.Clear();
    std::vector<Quad> quads{ Rectangle(-1.1, -1.1, 1.1, 1.1, 0.0),
      Rectangle(-1.1, -1.1, 0.0, 1.1, 0.1) };
    quads[1][2][0] = odd;
    const vtkSmartPointer<vtkActor> wall = Scene.AddWall(0.2);
    Scene.AddMesh(MeshOf(quads));
    Scene.AddHidden();
    Scene.ExpectHidden(114, 2);
    wall->VisibilityOff();
    Scene.ExpectNothingHidden(115, 2); // one such point spoils what a device makes of the mesh
  }
}

TEST_P(CullerOccluders, PartsOfNothing)
{
  for (const bool hasWall : { false, true })
  {
    Scene.Clear();
    if (hasWall)
    {
      Scene.AddWall();
    }
    Scene.AddMesh(MeshOf({}));
    Scene.AddMesh(vtkSmartPointer<vtkPolyData>::New());
    vtkNew<vtkPolyData> pointsAlone;
    pointsAlone->SetPoints(MeshOf({ Rectangle(0.0, 0.0, 1.0, 1.0, 0.0) })->GetPoints());
    Scene.AddMesh(pointsAlone);
    Scene.Renderer->AddActor(vtkSmartPointer<vtkActor>::New()); // without a mapper
    Scene.AddHidden();
    EXPECT_EQ(Scene.ExpectSameAround(116) > 0, hasWall);
  }
}

TEST_P(CullerOccluders, OddMatricesOfTheWall)
{
  const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
  Scene.AddHidden();
  int number = 0;
  for (const vtkSmartPointer<vtkMatrix4x4>& matrix : OddMatrices())
  {
    SCOPED_TRACE("matrix " + std::to_string(number));
    wall->SetUserMatrix(matrix);
    const int culled = Scene.ExpectSameAround(118, 2);
    if (number < 2)
    {
      EXPECT_GT(culled, 0);
    }
    else
    {
      EXPECT_LE(culled, 1); // a part between centres of pixels needs nothing before it
    }
    ++number;
  }
}

TEST_P(CullerOccluders, OddMatricesOfWhatIsHidden)
{
  Scene.AddMesh(MeshOf({ Rectangle(-0.5, -2.0, 2.0, 2.0, 0.0) }));
  const std::vector<vtkSmartPointer<vtkActor>> boxes = Scene.AddHidden();
  for (const vtkSmartPointer<vtkMatrix4x4>& matrix : OddMatrices())
  {
    for (std::size_t i = 0; i < boxes.size(); i += 2)
    {
      boxes[i]->SetUserMatrix(matrix);
    }
    Scene.ExpectHidden(119, 2);
  }
}

// What is culled of a wall, a mirrored one and a box is what the screen shows going around clockwise.
TEST_P(CullerOccluders, FacesThatAreLeftOut)
{
  for (const bool isMirrored : { false, true })
  {
    for (const int culling : { 0, 1, 2, 3 })
    {
      SCOPED_TRACE(std::to_string(isMirrored) + " mirrored, culling " + std::to_string(culling));
      Scene.Clear();
      const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
      const vtkSmartPointer<vtkActor> box = Scene.AddBox({ 0.1, 0.2, 0.6 }, { 0.9, 0.8, 0.7 });
      for (vtkActor* actor : { wall.Get(), box.Get() })
      {
        actor->GetProperty()->SetBackfaceCulling(culling & 1);
        actor->GetProperty()->SetFrontfaceCulling(culling >> 1);
        actor->SetScale(isMirrored ? -1.0 : 1.0, 1.0, 1.0);
      }
      Scene.AddHidden();
      const int culled = Scene.ExpectSameAround(120, 2);
      EXPECT_EQ(culled > 0, culling < 2) << culled;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerOccluders, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
