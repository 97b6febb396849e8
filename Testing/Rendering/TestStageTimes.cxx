// Tests the times of stages, the traits of devices, and the environment variable that takes traits away.
#include "TestMethods.h"
#include "TestScene.h"
#include "gl/DeviceTraits.h"
#include "gl/VitrineOpenGL.h"
#include "vtkTransparencyPass.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <string>

namespace
{

constexpr int Layers = 10;

/** Sets VITRINE_DEVICE while it lives. */
class ScopedSwitches
{
public:
  explicit ScopedSwitches(const char* words) { setenv("VITRINE_DEVICE", words, 1); }
  ~ScopedSwitches() { unsetenv("VITRINE_DEVICE"); }
  ScopedSwitches(const ScopedSwitches&) = delete;
  void operator=(const ScopedSwitches&) = delete;
};

/** Counts the timer queries that begin while it lives. */
class QueryCount
{
public:
  QueryCount()
  {
    Count = 0;
    Begin = glBeginQuery;
    glBeginQuery = [](GLenum target, GLuint query)
    {
      Count += target == GL_TIME_ELAPSED;
      Begin(target, query);
    };
  }
  ~QueryCount() { glBeginQuery = Begin; }
  static int Count;

private:
  static decltype(glBeginQuery) Begin;
};
int QueryCount::Count = 0;
decltype(glBeginQuery) QueryCount::Begin = nullptr;

std::map<std::string, double> StagesOf(vtkTransparencyPass* pass)
{
  std::map<std::string, double> stages;
  for (int stage = 0; stage < pass->GetNumberOfStages(); ++stage)
  {
    stages[pass->GetStageName(stage)] = pass->GetStageTime(stage);
  }
  return stages;
}

class StageTimes : public testing::TestWithParam<Method>
{
protected:
  StageTimes()
  {
    this->Scene.AddPlates(RandomPlates(Layers, 0.1, 5), 6);
    this->Scene.Use(this->Pass);
  }

  /** Draws a frame that is finished on the device, and returns its wall time in seconds. */
  double Draw()
  {
    const auto begin = std::chrono::steady_clock::now();
    this->Scene.Window->Render();
    this->Scene.Window->WaitForCompletion();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  TestScene Scene;
  vtkSmartPointer<vtkTransparencyPass> Pass = GetParam().Make();
};

TEST_P(StageTimes, AreNotMeasuredUnlessAskedFor)
{
  this->Draw();
  {
    const QueryCount queries;
    this->Draw();
    EXPECT_EQ(QueryCount::Count, 0);
  }
  EXPECT_EQ(this->Pass->GetNumberOfStages(), 0);
  this->Pass->MeasureStagesOn();
  this->Draw();
  EXPECT_GT(this->Pass->GetNumberOfStages(), 0);
  this->Pass->MeasureStagesOff();
  EXPECT_EQ(this->Pass->GetNumberOfStages(), 0);
  this->Draw();
  EXPECT_EQ(this->Pass->GetNumberOfStages(), 0);
}

// Stages follow one another within the frame, so their sum is at most the frame's time. Both are of one clock.
TEST_P(StageTimes, AddUpToNoMoreThanTheFrame)
{
  this->Pass->MeasureStagesOn();
  for (int frame = 0; frame < 3; ++frame)
  {
    const double whole = this->Draw();
    const std::map<std::string, double> stages = StagesOf(this->Pass);
    double sum = 0.0;
    for (const auto& [name, seconds] : stages)
    {
      EXPECT_GE(seconds, 0.0) << name;
      sum += seconds;
    }
    EXPECT_EQ(stages.count("fill"), 1u);
    EXPECT_EQ(stages.count("resolve"), 1u);
    EXPECT_GT(sum, 0.0);
    EXPECT_LE(sum, whole);
  }
}

TEST_P(StageTimes, LeavePicturesAsTheyAre)
{
  const Picture before = this->Scene.Render();
  this->Pass->MeasureStagesOn();
  EXPECT_TRUE(Matches(this->Scene.Render(), before));
  EXPECT_TRUE(Matches(this->Scene.Render(), before));
}

// OpenGL has one query of this kind at a time. Scene.Render() fails on an error of OpenGL.
TEST_P(StageTimes, GiveWayToAQueryOfTheApplication)
{
  this->Scene.Render();
  this->Pass->MeasureStagesOn();
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_TIME_ELAPSED, query);
  this->Scene.Render();
  glEndQuery(GL_TIME_ELAPSED);
  EXPECT_EQ(this->Pass->GetNumberOfStages(), 0);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
  EXPECT_GT(nanoseconds, 0u);
  glDeleteQueries(1, &query);
}

TEST_P(StageTimes, AreThoseOfTheNewContextAfterARelease)
{
  this->Pass->MeasureStagesOn();
  this->Draw();
  this->Scene.Window->Finalize();
  EXPECT_EQ(this->Pass->GetNumberOfStages(), 0);
  this->Draw();
  EXPECT_GT(this->Pass->GetNumberOfStages(), 0);
}

INSTANTIATE_TEST_SUITE_P(All, StageTimes,
  testing::ValuesIn(MethodsThat([](const Method& method) { return method.Name != "Truth"; })),
  [](const auto& info) { return info.param.Name; });

TEST(StageNames, AreEmptyOutsideOfTheirRange)
{
  const vtkSmartPointer<vtkTransparencyPass> pass = ExactMethods().front().Make();
  for (const int stage : { -1, 0, 1 })
  {
    EXPECT_EQ(pass->GetStageName(stage), "");
    EXPECT_EQ(pass->GetStageTime(stage), 0.0);
  }
}

TEST(DeviceTraits, AreTakenAwayByWords)
{
  TestScene scene;
  scene.Render();
  const vitrine::DeviceTraits whole = vitrine::FindDeviceTraits();
  const ScopedSwitches switches("no-fetch,no-software");
  const vitrine::DeviceTraits less = vitrine::FindDeviceTraits();
  EXPECT_FALSE(less.FramebufferFetch);
  EXPECT_FALSE(less.Software);
  EXPECT_EQ(less.PostDepthCoverage, whole.PostDepthCoverage);
  EXPECT_EQ(vitrine::FindProblemOfDeviceSwitches(), "");
}

TEST(DeviceTraits, HaveNoOtherWords)
{
  EXPECT_EQ(vitrine::FindProblemOfDeviceSwitches(), "");
  const ScopedSwitches switches("no-fetch,fetch");
  const std::string problem = vitrine::FindProblemOfDeviceSwitches();
  EXPECT_NE(problem.find("'fetch'"), std::string::npos) << problem;
  EXPECT_NE(problem.find("no-fetch, no-post-depth-coverage, no-software"), std::string::npos)
    << problem;
}

// Without fetch, lists have heads and counts in an image, to which shaders add: another program draws the same picture.
TEST(DeviceTraits, ChooseThePathOfLists)
{
  for (const Method& method : ABufferMethods())
  {
    SCOPED_TRACE(method.Name);
    const auto render = [&]
    {
      TestScene scene;
      scene.AddPlates(RandomPlates(Layers, 0.1, 5), 6);
      scene.Use(method.Make());
      return scene.Render();
    };
    const Picture fetched = render();
    const ScopedSwitches switches("no-fetch");
    EXPECT_TRUE(Matches(render(), fetched));
  }
}

}
