// Tests scenes of so many parts that several threads process them. Changes between frames must be noticed, and culling
// must lose no pixel.
#include "CullerScene.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageAppendComponents.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{

/**
 * A scene with a wall that covers everything, and very many small parts behind it. The wall is in the middle of their
 * order. Each two parts share their data.
 */
class CullerOfManyParts : public testing::Test
{
protected:
  static constexpr int Columns = 64;
  static constexpr int Lines = 36;
  static constexpr int Most = Columns * Lines + 1;

  CullerOfManyParts()
  {
    TestRandom random(146);
    for (int line = 0; line < Lines; ++line)
    {
      if (line == Lines / 2)
      {
        this->Wall = Scene.AddWall();
      }
      for (int column = 0; column < Columns; ++column)
      {
        this->AddPart((column + 0.5) / Columns - 0.5, (line + 0.5) / Lines - 0.5, random.Unit());
      }
    }
  }

  void AddPart(double x, double y, double red)
  {
    if (this->Parts.size() % 2 == 0)
    {
      this->Shared = vtkSmartPointer<vtkPolyDataMapper>::New();
      this->Shared->SetInputData(MeshOf({ Rectangle(-0.03, -0.03, 0.03, 0.03, 0.0) }));
    }
    vtkNew<vtkActor> part;
    part->SetMapper(this->Shared);
    part->SetPosition(4.2 * x, 2.3 * y, -0.3);
    part->GetProperty()->SetColor(red, 1.0 - red, 0.2);
    part->GetProperty()->LightingOff();
    Scene.Renderer->AddActor(part);
    this->Parts.push_back(part);
  }

  /** The changes lift the wall and put it back in turn. */
  void ExpectSameAfter(const std::vector<std::function<void()>>& changes)
  {
    EXPECT_EQ(Scene.ExpectSame(), Most - 1);
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      SCOPED_TRACE("change " + std::to_string(i));
      changes[i]();
      EXPECT_EQ(Scene.ExpectSame() > Most / 2, i % 2 == 1);
    }
  }

  static vtkPolyData* DataOf(vtkActor* actor)
  {
    return static_cast<vtkPolyDataMapper*>(actor->GetMapper())->GetInput();
  }

  static void MovePoints(vtkActor* actor, double z)
  {
    MovePointsInPlace(DataOf(actor), { 0.0, 0.0, z });
    DataOf(actor)->GetPoints()->Modified();
  }

  CullerScene Scene{ { "ManyParts", 0, false, 270, 96, 54 } };
  vtkSmartPointer<vtkActor> Wall;
  std::vector<vtkSmartPointer<vtkActor>> Parts;

private:
  vtkSmartPointer<vtkPolyDataMapper> Shared;
};

TEST_F(CullerOfManyParts, BehindAWallThatChanges)
{
  vtkNew<vtkMatrix4x4> matrix;
  Wall->SetUserMatrix(matrix);
  vtkNew<vtkPolyDataMapper> other;
  other->SetInputData(MeshOf({ Rectangle(-0.1, -0.1, 0.1, 0.1, 0.0) }));
  const auto setOther = [&](double size)
  { other->SetInputData(MeshOf({ Rectangle(-size, -size, size, size, 0.0) })); };
  this->ExpectSameAfter({
    [&] { Wall->SetPosition(0.0, 0.0, -0.6); },
    [&] { Wall->SetPosition(0.0, 0.0, 0.0); },
    [&] { matrix->SetElement(0, 3, 6.0); },
    [&] { matrix->SetElement(0, 3, 0.0); },
    [&] { Wall->GetProperty()->SetOpacity(0.5); },
    [&] { Wall->GetProperty()->SetOpacity(1.0); },
    [&]
    {
      Wall->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, "//VTK::Light::Impl\n", false);
    },
    [&] { Wall->SetShaderProperty(nullptr); },
    [&] { this->MovePoints(Wall, -0.6); },
    [&] { this->MovePoints(Wall, 0.6); },
    [&] { Wall->SetMapper(other); },
    [&] { setOther(2.5); },
    [&] { setOther(0.2); },
    [&] { DataOf(Wall)->DeepCopy(MeshOf({ Rectangle(-2.4, -2.4, 2.4, 2.4, 0.0) })); },
    [&] { Wall->VisibilityOff(); },
    [&] { Wall->VisibilityOn(); },
    [&] { Scene.Renderer->RemoveActor(Wall); },
    [&] { Scene.Renderer->AddActor(Wall); },
  });
}

TEST_F(CullerOfManyParts, OfWhichOneComesBefore)
{
  EXPECT_EQ(Scene.ExpectSame(), Most - 1);
  int moved = 0;
  for (const std::size_t i : { std::size_t{ 0 }, std::size_t{ 1100 }, Parts.size() - 1 })
  {
    Parts[i]->SetPosition(0.1 * moved, 0.2, 0.1);
    ++moved;
    EXPECT_EQ(Scene.ExpectSame(), Most - 1 - moved) << "part " << i;
  }
  MovePoints(Parts[600], 0.5); // two share it
  EXPECT_EQ(Scene.ExpectSame(), Most - 1 - moved - 2);
}

TEST_F(CullerOfManyParts, ThatComeAndGoAndComeTwice)
{
  EXPECT_EQ(Scene.ExpectSame(), Most - 1);
  vtkPropCollection* props = Scene.Renderer->GetViewProps();
  props->AddItem(Parts[7]);
  props->AddItem(Wall);
  EXPECT_EQ(Scene.ExpectSame(), Most);
  Wall->SetPosition(0.0, 0.0, -0.6);
  EXPECT_LT(Scene.ExpectSame(), Most / 2);
  Wall->SetPosition(0.0, 0.0, 0.0);
  TestRandom random(147);
  for (int frame = 0; frame < 4; ++frame)
  {
    SCOPED_TRACE("frame " + std::to_string(frame) + " of seed 147");
    for (int i = 0; i < 20; ++i)
    {
      vtkSmartPointer<vtkActor>& part = Parts[random.Next() % Parts.size()];
      Scene.Renderer->RemoveActor(part);
      part = nullptr; // so that the next may stand at its address
      part =
        Scene.MakeBox({ random.Unit() - 0.5, random.Unit() - 0.5, frame % 2 == 0 ? 0.1 : -0.2 },
          { 0.03, 0.03, 0.01 });
      Scene.Renderer->AddActor(part);
    }
    EXPECT_GT(Scene.ExpectSame(), Most / 2);
  }
}

// The texture's image is made while parts are drawn, and that moves points of other parts. So nothing is culled in that
// frame, and the next frame is culled as usual.
TEST_F(CullerOfManyParts, WhoseDataATexturesPipelineMoves)
{
  struct Move
  {
    vtkActor* Of;
    double By;

    void Do()
    {
      if (this->By != 0.0)
      {
        MovePoints(this->Of, this->By);
      }
    }
  } move{ Wall, 0.0 };
  vtkNew<vtkCallbackCommand> atEnd;
  atEnd->SetClientData(&move);
  atEnd->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { static_cast<Move*>(data)->Do(); });
  vtkNew<vtkImageAppendComponents> image;
  image->SetInputData(PlainImage(3, 200.0));
  image->AddObserver(vtkCommand::EndEvent, atEnd);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(image->GetOutputPort());
  Parts.back()->SetTexture(texture);
  const auto moveWall = [&](double by)
  {
    move.By = by;
    image->Modified();
  };
  Scene.Render();
  EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), 0);
  EXPECT_EQ(Scene.ExpectSame(), Most - 1);
  for (const double by : { -0.6, 0.6 })
  {
    moveWall(by);
    Scene.Culler->CullingOn();
    Scene.Render();
    EXPECT_EQ(Scene.Culler->GetNumberOfCulledParts(), 0);
    EXPECT_EQ(Scene.ExpectSame() > Most / 2, by > 0.0);
  }
}

}
