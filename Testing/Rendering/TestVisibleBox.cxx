// The box around all visible props, kept from frame to frame, is the one that VTK's bounds give at any time.
#include "CullerScene.h"
#include "scene/ActorRules.h"
#include "scene/VisibleBox.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkObjectFactory.h"
#include "vtkShaderProperty.h"
#include "vtkTextActor.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace
{

using vitrine::VisibleBox;

/** The union of VTK's bounds of all visible props. */
std::array<double, 6> BoundsByVTK(vtkRenderer* renderer)
{
  std::array<double, 6> bounds{};
  renderer->ComputeVisiblePropBounds(bounds.data());
  return bounds;
}

/** Cubes at places of their own: data that stand alone, made by a filter, and drawn by a vtkDataSetMapper. */
struct Cubes
{
  Cubes()
  {
    for (int i = 0; i < 6; ++i)
    {
      vtkNew<vtkCubeSource> cube;
      cube->Update();
      vtkNew<vtkPolyData> data;
      data->DeepCopy(cube->GetOutput());
      const vtkSmartPointer<vtkMapper> mapper = i % 3 == 2
        ? vtkSmartPointer<vtkMapper>(vtkSmartPointer<vtkDataSetMapper>::New())
        : vtkSmartPointer<vtkMapper>(vtkSmartPointer<vtkPolyDataMapper>::New());
      i % 3 == 1 ? mapper->SetInputConnection(cube->GetOutputPort())
                 : mapper->SetInputDataObject(data);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetPosition(3.0 * i, 0.0, 0.0);
      this->Renderer->AddActor(actor);
      this->Sources.push_back(cube);
      this->Data.push_back(data);
      this->Actors.push_back(actor);
    }
  }

  void ExpectAsVTK(const char* after)
  {
    const std::optional<vitrine::Box> box = this->Kept.Find(this->Renderer);
    ASSERT_TRUE(box) << after;
    const std::array<double, 6> b = BoundsByVTK(this->Renderer);
    const auto expected = vitrine::Box::Around({ b[0], b[2], b[4] }, { b[1], b[3], b[5] });
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(box->Min[axis], expected.Min[axis]) << after << ", axis " << axis;
      EXPECT_EQ(box->Max[axis], expected.Max[axis]) << after << ", axis " << axis;
    }
  }

  vtkNew<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkCubeSource>> Sources;
  std::vector<vtkSmartPointer<vtkPolyData>> Data;
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  VisibleBox Kept;
};

TEST(VisibleBox, FollowsAllChanges)
{
  Cubes cubes;
  cubes.ExpectAsVTK("the first frame");
  cubes.ExpectAsVTK("no change");
  cubes.Actors[5]->SetPosition(40.0, 1.0, 0.0);
  cubes.ExpectAsVTK("a move");
  vtkNew<vtkTransform> transform;
  cubes.Actors[4]->SetUserTransform(transform);
  cubes.ExpectAsVTK("a transform");
  transform->Translate(0.0, 90.0, 0.0);
  cubes.ExpectAsVTK("a change of the transform");
  for (const int i : { 0, 2 })
  {
    MovePointsInPlace(cubes.Data[i], { 0.0, 0.0, 20.0 + 5.0 * i });
    cubes.ExpectAsVTK("points that move");
  }
  cubes.Sources[1]->SetXLength(70.0);
  cubes.ExpectAsVTK("another parameter of a filter");
  cubes.Actors[3]->GetMapper()->SetInputDataObject(cubes.Data[0]);
  cubes.ExpectAsVTK("other data");
  cubes.Actors[3]->GetMapper()->SetInputConnection(cubes.Sources[1]->GetOutputPort());
  cubes.ExpectAsVTK("a filter in place of data");
  cubes.Actors[5]->VisibilityOff();
  cubes.ExpectAsVTK("one is not visible");
  cubes.Actors[5]->VisibilityOn();
  cubes.ExpectAsVTK("it is visible again");
  cubes.Renderer->RemoveActor(cubes.Actors[1]);
  cubes.ExpectAsVTK("one is taken out");
  cubes.Renderer->AddActor(cubes.Actors[1]);
  cubes.ExpectAsVTK("it comes back as the last");
  vtkNew<vtkTextActor> text;
  cubes.Renderer->AddActor2D(text);
  cubes.ExpectAsVTK("a text");
}

// Whatever the user's shaders draw, there is no box, and there is one again without them.
TEST(VisibleBox, IsNotKnownWhereAPropMayBeDrawnElsewhere)
{
  Cubes cubes;
  cubes.ExpectAsVTK("the first frame");
  for (const int i : { 0, 1, 2 })
  {
    SCOPED_TRACE(i);
    vtkShaderProperty* const shader = cubes.Actors[i]->GetShaderProperty();
    shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, "", false);
    EXPECT_FALSE(cubes.Kept.Find(cubes.Renderer));
    shader->ClearAllVertexShaderReplacements();
    cubes.ExpectAsVTK("code of the user's");
  }
  vtkNew<vtkCallbackCommand> nothing;
  nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  vtkMapper* const mapper = cubes.Actors[0]->GetMapper();
  const unsigned long id = mapper->AddObserver(vtkCommand::UpdateShaderEvent, nothing);
  EXPECT_FALSE(cubes.Kept.Find(cubes.Renderer));
  mapper->RemoveObserver(id);
  cubes.ExpectAsVTK("an observer");
  vtkNew<vtkAssembly> assembly;
  cubes.Renderer->AddActor(assembly);
  EXPECT_FALSE(cubes.Kept.Find(cubes.Renderer));
  cubes.Renderer->RemoveActor(assembly);
  cubes.ExpectAsVTK("an assembly");
}

/** A cube that counts how often anybody who wants bounds asks for it. */
class CountingCube : public vtkCubeSource
{
public:
  static CountingCube* New() { VTK_STANDARD_NEW_BODY(CountingCube); }
  vtkTypeMacro(CountingCube, vtkCubeSource);

  void UpdateInformation() override
  {
    ++this->Count;
    this->Superclass::UpdateInformation();
  }

  int Count = 0;
};

TEST(VisibleBox, AsksVTKOnlyForWhatHasChanged)
{
  Cubes cubes;
  vtkNew<CountingCube> cube;
  cubes.Actors[1]->GetMapper()->SetInputConnection(cube->GetOutputPort());
  ASSERT_TRUE(cubes.Kept.Find(cubes.Renderer));
  const int first = cube->Count;
  ASSERT_GT(first, 0); // the control
  ASSERT_TRUE(cubes.Kept.Find(cubes.Renderer));
  EXPECT_EQ(cube->Count, first);
  cubes.Actors[2]->SetPosition(0.0, 1.0, 0.0);
  ASSERT_TRUE(cubes.Kept.Find(cubes.Renderer));
  EXPECT_EQ(cube->Count, first);
  cubes.Actors[1]->SetPosition(0.0, 1.0, 0.0);
  ASSERT_TRUE(cubes.Kept.Find(cubes.Renderer));
  EXPECT_GT(cube->Count, first);
}

}
