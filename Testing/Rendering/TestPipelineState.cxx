// Whether a pipeline would make other data is known without updating it.
#include "CullerScene.h"
#include "TestMessages.h"
#include "scene/PipelineState.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkClipClosedSurface.h"
#include "vtkCubeSource.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShrinkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{

using vitrine::PipelineState;

/** A wall that covers all at time 0, and stands aside later. */
class WallInTime : public vtkPolyDataAlgorithm
{
public:
  static WallInTime* New();
  vtkTypeMacro(WallInTime, vtkPolyDataAlgorithm);

protected:
  WallInTime() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[2] = { 0.0, 1.0 };
    vtkInformation* const output = outputs->GetInformationObject(0);
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 2);
    output->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* const output = outputs->GetInformationObject(0);
    vtkInformationDoubleKey* const step = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    const double time = output->Has(step) ? output->Get(step) : 0.0;
    vtkPolyData* const wall = vtkPolyData::GetData(output);
    wall->ShallowCopy(MeshOf({ Rectangle(-2.5 + 9.0 * time, -2.5, 2.5 + 9.0 * time, 2.5, 0.0) }));
    wall->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

vtkStandardNewMacro(WallInTime);

/** A mapper at the end of filters. */
struct Pipeline
{
  vtkNew<vtkPlaneSource> Source;
  vtkNew<vtkTransform> Transform;
  vtkNew<vtkTransformPolyDataFilter> Moved;
  vtkNew<vtkShrinkPolyData> Shrunk;
  vtkNew<vtkPolyDataMapper> Mapper;

  Pipeline()
  {
    this->Moved->SetInputConnection(this->Source->GetOutputPort());
    this->Moved->SetTransform(this->Transform);
    this->Shrunk->SetInputConnection(this->Moved->GetOutputPort());
    this->Mapper->SetInputConnection(this->Shrunk->GetOutputPort());
  }
};

// Expects that what changes is noticed, and that nothing is once that was updated.
void ExpectNoticed(vtkPolyDataMapper* mapper, const std::function<void()>& change)
{
  const PipelineState state(mapper);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(state.IsCurrent(mapper));
    mapper->Update();
  }
  change();
  EXPECT_FALSE(state.IsCurrent(mapper));
  mapper->Update();
  EXPECT_FALSE(state.IsCurrent(mapper));
  EXPECT_TRUE(PipelineState(mapper).IsCurrent(mapper));
}

// So that it is not asked for in each frame.
TEST(PipelineState, StaysWhatItIsWhileFramesAreDrawn)
{
  Pipeline all;
  TestScene scene;
  vtkNew<vtkActor> actor;
  actor->SetMapper(all.Mapper);
  scene.Renderer->AddActor(actor);
  const PipelineState state(all.Mapper);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(state.IsCurrent(all.Mapper));
    scene.Render();
  }
}

TEST(PipelineState, NoticesWhatChangesUpstream)
{
  Pipeline all;
  ExpectNoticed(all.Mapper, [&] { all.Source->SetCenter(0.1, 0.2, 0.3); });
  ExpectNoticed(all.Mapper, [&] { all.Transform->Translate(0.1, 0.2, 0.3); });
  ExpectNoticed(all.Mapper, [&] { all.Shrunk->SetShrinkFactor(0.7); });
  ExpectNoticed(all.Mapper, [&] { all.Moved->Modified(); });
  vtkNew<vtkCubeSource> other;
  ExpectNoticed(all.Mapper, [&] { all.Moved->SetInputConnection(other->GetOutputPort()); });
}

TEST(PipelineState, NoticesDataThatChangeInPlace)
{
  Pipeline all;
  const vtkSmartPointer<vtkPolyData> data = MeshOf({ Rectangle(0, 0, 1, 1, 0) });
  all.Moved->SetInputData(data);
  ExpectNoticed(all.Mapper, [&] { data->GetPoints()->Modified(); });
  ExpectNoticed(all.Mapper, [&] { data->GetPolys()->Modified(); });
}

// It tells the times of its planes to the pipeline alone.
TEST(PipelineState, NoticesTimesThatTheFilterItselfDoesNotTell)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  vtkNew<vtkClipClosedSurface> clipped;
  clipped->SetInputConnection(cube->GetOutputPort());
  clipped->SetClippingPlanes(planes);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(clipped->GetOutputPort());
  ExpectNoticed(mapper, [&] { plane->SetOrigin(0.1, 0.0, 0.0); });
}

TEST(PipelineState, NoticesRequests)
{
  vtkNew<WallInTime> wall;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(wall->GetOutputPort());
  ExpectNoticed(mapper,
    [&] {
      wall->GetOutputInformation(0)->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), 1.0);
    });
  ExpectNoticed(mapper, [&] { wall->UpdateTimeStep(0.0); });
}

/** A sphere, once it may be made, of which it tells nobody; and a second output. */
class LateSphere : public vtkSphereSource
{
public:
  static LateSphere* New();
  vtkTypeMacro(LateSphere, vtkSphereSource);

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const bool isRefused =
      !this->IsThere && request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT());
    return isRefused ? 0 : this->Superclass::ProcessRequest(request, inputs, outputs);
  }

  bool IsThere = true;

protected:
  LateSphere() { this->SetNumberOfOutputPorts(2); }
};

vtkStandardNewMacro(LateSphere);

TEST(PipelineState, IsNotKnownOfWhatCannotBeMade)
{
  vtkNew<LateSphere> sphere;
  vtkNew<vtkShrinkPolyData> shrunk;
  shrunk->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(shrunk->GetOutputPort());
  EXPECT_TRUE(PipelineState(mapper).IsCurrent(mapper));
  sphere->IsThere = false;
  sphere->Modified();
  EXPECT_FALSE(PipelineState(mapper).IsCurrent(mapper));
  EXPECT_FALSE(TakeMessages().empty());
}

TEST(PipelineState, IsNotKnownOfOtherOutputsThanAreDrawn)
{
  vtkNew<LateSphere> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort(1));
  EXPECT_FALSE(PipelineState(mapper).IsCurrent(mapper));
}

TEST(PipelineState, IsNotKnownOfOthers)
{
  Pipeline all, others;
  EXPECT_FALSE(PipelineState().IsCurrent(all.Mapper));
  EXPECT_FALSE(PipelineState(all.Mapper).IsCurrent(others.Mapper));
}

using CullerPipelines = CullerTest;

// What filters make of the wall lifts it and puts it back in turn.
TEST_P(CullerPipelines, OfAWallThatChange)
{
  Scene.AddHidden();
  Pipeline all;
  all.Source->SetOrigin(-2.5, -2.5, 0.0);
  all.Source->SetPoint1(2.5, -2.5, 0.0);
  all.Source->SetPoint2(-2.5, 2.5, 0.0);
  all.Shrunk->SetShrinkFactor(1.0);
  vtkNew<vtkActor> wall;
  wall->SetMapper(all.Mapper);
  Scene.Renderer->AddActor(wall);
  const vtkSmartPointer<vtkPolyData> aside = MeshOf({ Rectangle(7.0, -2.5, 9.0, 2.5, 0.0) });
  const std::vector<std::function<void()>> changes{ [&] { all.Source->SetCenter(9.0, 0.0, 0.0); },
    [&] { all.Source->SetCenter(0.0, 0.0, 0.0); }, [&] { all.Transform->Translate(9.0, 0.0, 0.0); },
    [&] { all.Transform->Identity(); }, [&] { all.Shrunk->SetShrinkFactor(0.01); },
    [&] { all.Shrunk->SetShrinkFactor(1.0); }, [&] { all.Moved->SetInputData(aside); },
    [&] { all.Moved->SetInputConnection(all.Source->GetOutputPort()); } };
  Scene.LookAhead();
  EXPECT_GT(Scene.ExpectSame(), 40);
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    SCOPED_TRACE("change " + std::to_string(i));
    changes[i]();
    const bool isLifted = i % 2 == 0;
    for (int frame = 0; frame < 2; ++frame)
    {
      EXPECT_LE(Scene.ExpectSame(), isLifted ? 40 : 1000); // soon it changes too often to be read
    }
  }
}

TEST_P(CullerPipelines, OfAWallAtAnotherTime)
{
  Scene.AddHidden();
  vtkNew<WallInTime> maker;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(maker->GetOutputPort());
  vtkNew<vtkActor> wall;
  wall->SetMapper(mapper);
  Scene.Renderer->AddActor(wall);
  Scene.LookAhead();
  for (int frame = 0; frame < 8; ++frame)
  {
    SCOPED_TRACE(frame);
    const bool isAside = frame / 2 % 2 == 1;
    maker->GetOutputInformation(0)->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), isAside ? 1.0 : 0.0);
    const int leftOut = Scene.ExpectSame();
    EXPECT_LE(leftOut, isAside ? 40 : 1000);
    EXPECT_TRUE(frame > 0 || leftOut > 40) << leftOut << ", soon it changes too often to be read";
  }
}

// Nothing but its pipeline tells of a part that is hidden.
TEST_P(CullerPipelines, BringHiddenPartsToTheFront)
{
  Scene.AddWall();
  Scene.AddHidden();
  Pipeline all;
  all.Source->SetCenter(0.0, 0.0, -0.5);
  all.Shrunk->SetShrinkFactor(0.5);
  vtkNew<vtkActor> part;
  part->SetMapper(all.Mapper);
  Scene.Renderer->AddActor(part);
  Scene.LookAhead();
  const int hidden = Scene.ExpectSame();
  EXPECT_GT(hidden, 40);
  for (int frame = 0; frame < 4; ++frame)
  {
    const bool isInFront = frame % 2 == 0;
    all.Transform->Translate(0.0, 0.0, isInFront ? 1.0 : -1.0);
    EXPECT_EQ(Scene.ExpectSame(), isInFront ? hidden - 1 : hidden);
  }
}

TEST_P(CullerPipelines, ThatCouldNotBeRun)
{
  Scene.AddWall();
  vtkNew<LateSphere> sphere;
  sphere->SetCenter(0.0, 0.0, -0.5);
  sphere->SetRadius(0.1);
  vtkNew<vtkShrinkPolyData> shrunk;
  shrunk->SetInputConnection(sphere->GetOutputPort());
  const vtkSmartPointer<vtkActor> part = Scene.AddSource(shrunk, { 0.9, 0.3, 0.1, 1.0 });
  Scene.LookAhead();
  EXPECT_EQ(Scene.ExpectSame(), 1);
  sphere->IsThere = false;
  sphere->SetCenter(0.0, 0.0, 0.5);
  EXPECT_EQ(Scene.ExpectSame(), 1); // what there was before is drawn
  sphere->IsThere = true;
  EXPECT_EQ(Scene.ExpectSame(), 0);
  TakeMessages();
}

// A filter makes anew what each mapper draws of it: all, or the half of a sphere that is above or below.
class CullerPieces : public CullerPipelines
{
protected:
  CullerPieces()
  {
    this->Sphere->SetRadius(0.6);
    this->Sphere->SetThetaResolution(32);
    this->Sphere->SetPhiResolution(32);
    Scene.AddHidden();
  }

  vtkSmartPointer<vtkActor> AddSphere(double x, int pieces, int piece)
  {
    const vtkSmartPointer<vtkActor> actor = Scene.AddSource(this->Sphere, { 0.9, 0.3, 0.1, 1.0 });
    actor->SetPosition(x, 0.0, 0.2);
    auto* const mapper = static_cast<vtkPolyDataMapper*>(actor->GetMapper());
    mapper->SetNumberOfPieces(pieces);
    mapper->SetPiece(piece);
    return actor;
  }

  void ExpectSameWhileItStays()
  {
    Scene.LookAhead();
    for (int frame = 0; frame < 4; ++frame)
    {
      SCOPED_TRACE(frame);
      EXPECT_GT(Scene.ExpectSame(), 0);
    }
  }

  vtkNew<vtkSphereSource> Sphere;
};

TEST_P(CullerPieces, OfWhichTheOtherIsHidden)
{
  Scene.AddMesh(MeshOf({ Rectangle(-2.0, -2.0, 2.0, 0.0, 0.9) }));
  this->AddSphere(0.0, 1, 0);
  this->AddSphere(0.9, 2, 1)->SetPosition(0.9, 0.6, 0.2);
  this->ExpectSameWhileItStays();
}

TEST_P(CullerPieces, OfWhichAllWouldHide)
{
  this->AddSphere(0.0, 2, 0);
  this->AddSphere(9.0, 1, 0);
  this->ExpectSameWhileItStays();
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerPipelines, testing::ValuesIn(CullerSettings()), CullerSettingName);

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerPieces, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
