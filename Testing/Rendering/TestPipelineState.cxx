// Whether a pipeline would make other data is known without updating it.
#include "CullerScene.h"
#include "culling/PipelineState.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkClipClosedSurface.h"
#include "vtkCubeSource.h"
#include "vtkDataObject.h"
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
  mapper->Update();
  PipelineState state(mapper);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_TRUE(state.IsCurrent());
    mapper->Update();
  }
  change();
  EXPECT_FALSE(state.IsCurrent());
  mapper->Update();
  EXPECT_FALSE(state.IsCurrent());
  EXPECT_TRUE(PipelineState(mapper).IsCurrent());
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

TEST(PipelineState, IsNotKnownWithoutAPipeline)
{
  EXPECT_FALSE(PipelineState().IsCurrent());
  vtkNew<vtkPolyDataMapper> mapper;
  EXPECT_FALSE(PipelineState(mapper).IsCurrent());
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
    EXPECT_LE(Scene.ExpectSame(), isAside ? 40 : 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Settings, CullerPipelines, testing::ValuesIn(CullerSettings()), CullerSettingName);

}
