// What others cannot hide is left out where it lies outside of the view, as VTK's own culler does, and nowhere else.
#include "CullerScene.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

/** What an actor is drawn with that leaves it to the view alone. */
struct Look
{
  std::string Name;
  std::function<void(vtkActor*)> Give;
};

std::vector<Look> LooksOfViewAlone()
{
  return {
    { "edges", [](vtkActor* actor) { actor->GetProperty()->EdgeVisibilityOn(); } },
    { "vertices",
      [](vtkActor* actor)
      {
        actor->GetProperty()->VertexVisibilityOn();
        actor->GetProperty()->SetPointSize(5.0f);
      } },
    { "spheres", [](vtkActor* actor) { actor->GetProperty()->RenderPointsAsSpheresOn(); } },
    { "tubes", [](vtkActor* actor) { actor->GetProperty()->RenderLinesAsTubesOn(); } },
    { "offset",
      [](vtkActor*)
      {
        vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
        vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(2.0, 2.0);
      } },
    { "shift", [](vtkActor*) { vtkMapper::SetResolveCoincidentTopologyToShiftZBuffer(); } },
  };
}

class CullerViewAlone : public CullerTest
{
protected:
  void TearDown() override { this->ForgetSettings(); }

  // Those of the whole program.
  static void ForgetSettings()
  {
    vtkMapper::SetResolveCoincidentTopologyToOff();
    vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(0.0, 0.0);
    vtkMapper::SetResolveCoincidentTopologyLineOffsetParameters(0.0, -4.0);
  }

  // Begins a scene anew for each look.
  void ForEachLook(const std::function<void(const Look&)>& test)
  {
    for (const Look& look : LooksOfViewAlone())
    {
      SCOPED_TRACE(look.Name);
      Scene.Clear();
      Scene.LookAhead();
      ForgetSettings();
      test(look);
    }
  }

  // Boxes all around the camera, some of which reach into the view.
  std::vector<vtkSmartPointer<vtkActor>> AddBoxesAllAround(std::uint64_t seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    TestRandom random(seed);
    const auto upTo = [&](double most) { return most * (2.0 * random.Unit() - 1.0); };
    std::vector<vtkSmartPointer<vtkActor>> boxes;
    for (int i = 0; i < 120; ++i)
    {
      const double x = upTo(3.0), y = upTo(2.5), z = upTo(6.0);
      boxes.push_back(Scene.AddBox({ x, y, z }, { 0.4, 0.3, 0.5 }));
      boxes.back()->RotateWXYZ(90.0 * random.Unit(), 1.0, x, y);
    }
    return boxes;
  }
};

TEST_P(CullerViewAlone, LiesOutside)
{
  ForEachLook(
    [&](const Look& look)
    {
      for (const vtkSmartPointer<vtkActor>& box : AddBoxesAllAround(401))
      {
        look.Give(box);
      }
      Scene.ExpectHidden(402, 4);
    });
}

TEST_P(CullerViewAlone, LiesBehindOthers)
{
  ForEachLook(
    [&](const Look& look)
    {
      Scene.AddWall();
      const std::vector<vtkSmartPointer<vtkActor>> boxes = Scene.AddHidden();
      Scene.ExpectHidden(403, 0);
      for (const vtkSmartPointer<vtkActor>& box : boxes)
      {
        look.Give(box);
      }
      Scene.ExpectNothingHidden(403);
    });
}

TEST_P(CullerViewAlone, LiesBeforeOthers)
{
  ForEachLook(
    [&](const Look& look)
    {
      const vtkSmartPointer<vtkActor> wall = Scene.AddWall();
      Scene.AddHidden();
      Scene.ExpectHidden(404, 0);
      look.Give(wall);
      Scene.ExpectNothingHidden(404);
    });
}

// What is changed in the middle of a scene counts at once.
TEST_P(CullerViewAlone, ComesAndGoes)
{
  const std::vector<vtkSmartPointer<vtkActor>> boxes = AddBoxesAllAround(405);
  int leftOut = Scene.ExpectSame();
  TestRandom random(406);
  for (int step = 0; step < 12; ++step)
  {
    vtkActor* const box = boxes[random.Next() % boxes.size()];
    box->GetProperty()->SetRenderLinesAsTubes(step % 2 == 0);
    box->SetPosition(0.3 * random.Unit(), 0.3 * random.Unit(), step % 3 == 0 ? 0.3 : 5.0);
    leftOut = Scene.ExpectSame();
  }
  EXPECT_GT(leftOut, 0);
}

// Lines and points are wider than their box.
TEST_P(CullerViewAlone, TubesReachIntoTheViewFromBesideIt)
{
  const double pixel = Scene.PixelSize();
  const double half = 0.5 * Scene.Setting.Height * pixel;
  const auto tubeAbove = [&](double pixels)
  {
    const vtkSmartPointer<vtkActor> tube =
      Scene.AddLine({ -0.3, half + pixels * pixel, 0.0 }, { 0.3, half + pixels * pixel, 0.0 });
    tube->GetProperty()->RenderLinesAsTubesOn();
    tube->GetProperty()->SetLineWidth(20.0f);
    return tube;
  };
  tubeAbove(60.0);
  const vtkSmartPointer<vtkActor> near = tubeAbove(8.0);
  EXPECT_EQ(Scene.ExpectSame(), 1);
  EXPECT_TRUE(Scene.ShowsUnculled({ near }));
}

// VTK draws it nearer than the rest, and wider.
TEST_P(CullerViewAlone, IsSelected)
{
  Scene.AddWall(-0.35);
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, -0.351) });
  const vtkSmartPointer<vtkActor> part = Scene.AddMesh(mesh);
  EXPECT_EQ(Scene.ExpectSame(), 1);
  vtkNew<vtkIdTypeArray> chosen;
  chosen->InsertNextValue(0);
  chosen->InsertNextValue(2);
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(vtkSelectionNode::POINT);
  node->SetSelectionList(chosen);
  vtkNew<vtkSelection> selection;
  part->GetMapper()->SetSelection(selection);
  part->GetProperty()->SetSelectionPointSize(15.0f);
  EXPECT_EQ(Scene.ExpectSame(), 1) << "it is empty";
  selection->AddNode(node); // which the mapper is not told
  EXPECT_EQ(Scene.ExpectSame(), 0);
  part->SetPosition(50.0, 0.0, 0.0);
  EXPECT_EQ(Scene.ExpectSame(), 1);
}

// ParaView offsets lines and points, and leaves faces at their depths.
TEST_P(CullerViewAlone, IsNotForFacesWithoutOffset)
{
  Scene.AddWall(-0.35);
  const vtkSmartPointer<vtkPolyData> mesh = MeshOf({ Rectangle(-0.3, -0.3, 0.3, 0.3, -0.351) });
  Scene.AddMesh(mesh);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  vtkMapper::SetResolveCoincidentTopologyLineOffsetParameters(0.0, -2000.0); // before the wall
  EXPECT_EQ(Scene.ExpectSame(), 1);
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 2 });
  mesh->SetLines(line);
  EXPECT_EQ(Scene.ExpectSame(), 0);
  mesh->SetLines(nullptr);
  EXPECT_EQ(Scene.ExpectSame(), 1);
  vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(0.0, 1.0);
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

// Of whom it is not known where they are drawn.
TEST_P(CullerViewAlone, HasAPlace)
{
  const vtkSmartPointer<vtkActor> box = Scene.AddBox({ 50.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  box->GetProperty()->EdgeVisibilityOn();
  EXPECT_EQ(Scene.ExpectSame(), 1);
  box->GetShaderProperty()->AddVertexShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n", false);
  EXPECT_EQ(Scene.ExpectSame(), 0);
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerViewAlone, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
