// The pass that chooses by an error budget: no pixel exceeds its bound, no bound exceeds the budget, and what it
// cannot promise it says.
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkErrorBudgetTransparencyPass.h"
#include "vtkImageData.h"
#include "vtkLinkedListTransparencyPass.h"
#include "vtkNew.h"
#include "vtkPrefixSumTransparencyPass.h"
#include "vtkSeeThroughPass.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

constexpr double Step = 1.0 / 255.0;
// Truth holds the background in single precision. This is in steps.
constexpr double Single = 1e-4;

// Triangles of any colours and alphas, which cut each other, in front of spheres.
void AddBudgetScene(TestScene& scene, std::uint64_t seed, double alpha)
{
  TestRandom random(seed);
  const auto place = [&] { return 3.0 * random.Unit() - 1.5; };
  const auto height = [&] { return 1.8 * random.Unit() - 0.9; };
  for (int i = 0; i < 90; ++i)
  {
    const Rgba color = { random.Unit(), random.Unit(), random.Unit(),
      std::min(1.0, 2.0 * alpha * random.Unit()) };
    scene.AddTriangle({ { { place(), place(), height() }, { place(), place(), height() },
                        { place(), place(), height() } } },
      color);
  }
  scene.AddParts();
}

struct JudgedFrame
{
  double LargestError = 0.0;
  double LargestBound = 0.0;
  double WorstExcess = -1.0; // of an error over its pixel's bound
  std::vector<double>
    Tightness; // bound over error, of pixels with errors above a quarter of a step
};

void JudgePicture(
  const Picture& picture, vtkImageData* exact, vtkImageData* bounds, JudgedFrame& judged)
{
  for (int y = 0; y < picture.Height; ++y)
  {
    for (int x = 0; x < picture.Width; ++x)
    {
      const double bound = bounds->GetScalarComponentAsDouble(x, y, 0, 0) / Step;
      double error = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const double shown = picture.At(x, y)[c];
        error = std::max(error,
          std::abs(shown - std::clamp(exact->GetScalarComponentAsDouble(x, y, 0, c), 0.0, 1.0)) /
            Step);
      }
      judged.LargestError = std::max(judged.LargestError, error);
      judged.LargestBound = std::max(judged.LargestBound, bound);
      judged.WorstExcess = std::max(judged.WorstExcess, error - bound);
      if (error > 0.25)
      {
        judged.Tightness.push_back(bound / error);
      }
    }
  }
}

// Draws the scene by truth and by the pass, a few frames of it. All figures are in steps. The first frame chooses
// without knowledge, the second one finds what is hidden, and later ones do not store it.
JudgedFrame JudgeFrames(TestScene& scene, vtkErrorBudgetTransparencyPass* pass, int frames = 4)
{
  vtkNew<vtkTruthTransparencyPass> truth;
  scene.Use(truth);
  scene.Render();
  pass->KeepErrorBoundsOn();
  scene.Use(pass);
  JudgedFrame judged;
  for (int frame = 0; frame < frames; ++frame)
  {
    const Picture picture = scene.Render();
    vtkNew<vtkImageData> bounds;
    EXPECT_TRUE(pass->GetErrorBound(bounds));
    JudgePicture(picture, truth->GetResult(), bounds, judged);
  }
  return judged;
}

double MedianOf(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class ErrorBudget : public testing::TestWithParam<double>
{
};

TEST_P(ErrorBudget, BoundsEachPixelAndKeepsTheBudget)
{
  for (const double alpha : { 0.02, 0.3, 0.9 })
  {
    SCOPED_TRACE("alpha " + std::to_string(alpha));
    TestScene scene(96, 72);
    AddBudgetScene(scene, 53, alpha);
    vtkNew<vtkErrorBudgetTransparencyPass> pass;
    pass->SetErrorBudget(GetParam() * Step);
    const JudgedFrame judged = JudgeFrames(scene, pass);
    EXPECT_EQ(pass->GetBudgetProblem(), "");
    EXPECT_LE(judged.WorstExcess, Single);
    EXPECT_LE(judged.LargestBound, GetParam());
    EXPECT_GT(judged.LargestError, 0.25);
    EXPECT_LE(MedianOf(judged.Tightness), 4.0);
    EXPECT_LE(pass->GetGuaranteedError(), GetParam() * Step);
  }
}

INSTANTIATE_TEST_SUITE_P(Budgets, ErrorBudget, testing::Values(0.6, 1.0, 1.3, 2.0, 8.0),
  [](const auto& info) { return "Of" + std::to_string(int(10.0 * info.param)) + "Tenths"; });

std::string ChosenFor(TestScene& scene, double steps, vtkTypeInt64 wrongGuesses)
{
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(steps * Step);
  const JudgedFrame judged = JudgeFrames(scene, pass);
  EXPECT_LE(judged.WorstExcess, Single);
  EXPECT_LE(judged.LargestBound, steps);
  EXPECT_EQ(pass->GetNumberOfWrongGuesses(), wrongGuesses);
  return pass->GetChosenMethod();
}

TEST(ErrorBudgetChoices, FollowTheBudget)
{
  TestScene scene;
  scene.AddParts();
  EXPECT_EQ(ChosenFor(scene, 0.6, 0), "prefix-sum-predicted");
  EXPECT_EQ(ChosenFor(scene, 1.0, 0), "prefix-sum-predicted");
  EXPECT_EQ(ChosenFor(scene, 2.0, 0), "prefix-sum-predicted-compact");
  EXPECT_EQ(ChosenFor(scene, 8.0, 0), "prefix-sum-predicted-compact");
}

// Alphas and blues that are one code of a compact node, or nearly, where red and green are not.
TEST(ErrorBudgetChoices, CompactNodesHaveTheOrderOfEqualDepths)
{
  for (const double alpha : { 0.4, 0.4004, 0.4008, 0.402 })
  {
    for (const double blue : { 0.5, 0.5004, 0.5008, 0.502 })
    {
      SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", blue " << blue);
      TestScene scene(8, 6);
      scene.AddPlate(0.25, { 0.9, 0.9, 0.5, 0.4 });
      scene.AddPlate(0.25, { 0.1, 0.1, blue, alpha });
      scene.AddPlate(0.25, { 0.9, 0.1, blue, 0.4 });
      EXPECT_EQ(ChosenFor(scene, 2.0, 0), "prefix-sum-predicted-compact");
      EXPECT_EQ(ChosenFor(scene, 0.6, 0), "prefix-sum-predicted");
    }
  }
}

// Below 1/128 nodes of either kind keep depths in steps of 2^-30. Two depths of one step are equal, so colours order
// them, and each colour is in front once.
TEST(ErrorBudgetChoices, NodesHaveTheOrderOfNearDepths)
{
  const Rgba colors[] = { { 0.9, 0.1, 0.1, 0.5 }, { 0.1, 0.1, 0.9, 0.6 } };
  for (const int first : { 0, 1 })
  {
    SCOPED_TRACE(first);
    TestScene scene(8, 6);
    for (const int i : { 0, 1 })
    {
      const vtkSmartPointer<vtkActor> plate = scene.AddPlate(0.5, colors[(first + i) % 2]);
      plate->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
        "gl_FragDepth = exp2(-10.0) + " + std::to_string(i) + ".0 * exp2(-32.0);\n", false);
    }
    EXPECT_EQ(ChosenFor(scene, 2.0, 0), "prefix-sum-predicted-compact");
    EXPECT_EQ(ChosenFor(scene, 0.6, 0), "prefix-sum-predicted");
  }
}

TEST(ErrorBudgetChoices, LinkedListsServeACameraThatJumps)
{
  TestScene scene;
  scene.AddParts();
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  scene.Use(pass);
  int secondPasses = 0;
  for (int frame = 0; frame < 40; ++frame)
  {
    scene.Renderer->GetActiveCamera()->SetFocalPoint(frame % 2 * 0.7, 0.0, 0.0);
    scene.Render();
    secondPasses += pass->GetNumberOfGeometryPasses() > 1 ? 1 : 0;
  }
  EXPECT_LT(secondPasses, 12);
  EXPECT_EQ(pass->GetChosenMethod(), "linked-list");
}

// 60 plates of alpha 0.2: light of a 16th of 0.6 steps passes 40 of them.
constexpr int DeepPlates = 60;
constexpr double DeepAlpha = 51.0 / 255.0;

int PlatesStored(const vtkErrorBudgetTransparencyPass* pass)
{
  return static_cast<int>(
    const_cast<vtkErrorBudgetTransparencyPass*>(pass)->GetNumberOfFragments() / (64 * 48));
}

TEST(ErrorBudgetHidden, PlatesAreNotStored)
{
  TestScene scene;
  scene.AddPlates(RandomPlates(DeepPlates, DeepAlpha, 3), 7);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  const JudgedFrame judged = JudgeFrames(scene, pass);
  const double light = (2.0 * Step - pass->GetPlannedError(0)) / 16.0;
  const int needed = int(std::ceil(std::log(light) / std::log(1.0 - DeepAlpha)));
  EXPECT_NEAR(PlatesStored(pass), needed, 1);
  EXPECT_LE(judged.WorstExcess, Single);
  EXPECT_LE(judged.LargestBound, 2.0);
  EXPECT_EQ(pass->GetNumberOfWrongGuesses(), 0);
  EXPECT_EQ(pass->GetNumberOfGeometryPasses(), 1);
}

TEST(ErrorBudgetHidden, PlatesStayHiddenWhileTheCameraMoves)
{
  TestScene scene;
  scene.AddPlates(RandomPlates(DeepPlates, DeepAlpha, 3), 7);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  scene.Use(pass);
  for (int frame = 0; frame < 8; ++frame)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(0.2);
    scene.Render();
  }
  EXPECT_LT(PlatesStored(pass), DeepPlates - 15);
  EXPECT_EQ(pass->GetNumberOfWrongGuesses(), 0);
  EXPECT_LE(JudgeFrames(scene, pass, 1).WorstExcess, Single);
}

TEST(ErrorBudgetHidden, PlatesAreStoredAgainWhereWhatHidThemGoes)
{
  TestScene scene;
  const vtkSmartPointer<vtkActor> front =
    scene.AddRectangle(-0.5, -0.5, 0.5, 0.5, 0.95, { 1, 0, 0, 0.9998 });
  scene.AddPlates(RandomPlates(DeepPlates, 5.0 / 255.0, 3), 7);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  JudgeFrames(scene, pass);
  const vtkTypeInt64 hidden = pass->GetNumberOfFragments();
  EXPECT_LT(hidden, 64 * 48 * DeepPlates);
  front->VisibilityOff();
  vtkNew<vtkErrorBudgetTransparencyPass> fresh;
  fresh->SetErrorBudget(2.0 * Step);
  EXPECT_LE(JudgeFrames(scene, fresh, 1).WorstExcess, Single);
  EXPECT_LE(JudgeFrames(scene, pass, 1).WorstExcess, Single);
  EXPECT_EQ(pass->GetNumberOfWrongGuesses(), 1);
  EXPECT_EQ(pass->GetNumberOfFragments(), 64 * 48 * DeepPlates);
  front->VisibilityOn(); // The guess is not made again at once.
  JudgeFrames(scene, pass, 8);
  EXPECT_EQ(pass->GetNumberOfWrongGuesses(), 1);
  EXPECT_GT(pass->GetNumberOfFragments(), 64 * 48 * DeepPlates);
}

TEST(ErrorBudgetHidden, AllLayersAreStoredWithPartNumbers)
{
  TestScene scene;
  scene.AddPlates(RandomPlates(DeepPlates, DeepAlpha, 3), 7);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  pass->PartNumbersOn();
  JudgeFrames(scene, pass);
  EXPECT_EQ(PlatesStored(pass), DeepPlates);
}

// The plates of a pixel that little light reaches are known from a closed form. From 15 % of all on they are cut, after
// one frame that counts them.
TEST(ErrorBudgetHidden, FewHiddenFragmentsAreNotWorthIt)
{
  const double budget = 2.0 * Step;
  const double stored = 1.41 * Step; // of compact nodes
  const double light = (budget - stored) / 16.0;
  const int shown = static_cast<int>(std::ceil(std::log(light) / std::log(1.0 - DeepAlpha)));
  const int worthIt = static_cast<int>(std::ceil(shown / 0.85));
  for (const int plates : { worthIt - 1, worthIt })
  {
    SCOPED_TRACE(plates);
    TestScene scene;
    scene.AddPlates(RandomPlates(plates, DeepAlpha, 3), 7);
    vtkNew<vtkErrorBudgetTransparencyPass> pass;
    pass->SetErrorBudget(budget);
    JudgeFrames(scene, pass, 2); // the first one finds that there are many layers
    const bool isCut = pass->GetPlannedReason(0).find("hidden") != std::string::npos;
    EXPECT_EQ(isCut, plates == worthIt);
    scene.Render();
    EXPECT_EQ(PlatesStored(pass), isCut ? shown : plates);
  }
}

TEST(ErrorBudgetChoices, MultisampledWindowsTellWhatTheyCannotKeep)
{
  TestScene scene(64, 48, 4);
  scene.AddParts();
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  const JudgedFrame judged = JudgeFrames(scene, pass);
  EXPECT_NE(pass->GetBudgetProblem().find("errors of up to 1.0"), std::string::npos)
    << pass->GetBudgetProblem();
  EXPECT_LE(judged.WorstExcess, Single);
  pass->SetErrorBudget(1.2 * Step);
  scene.Render();
  EXPECT_EQ(pass->GetBudgetProblem(), "");
}

TEST(ErrorBudgetChoices, BandsOfShortMemoryKeepTheBudget)
{
  TestScene scene;
  AddBudgetScene(scene, 5, 0.3);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  const JudgedFrame whole = JudgeFrames(scene, pass);
  EXPECT_EQ(pass->GetNumberOfBands(), 1);
  pass->SetMemoryLimit(pass->GetPoolBytes() / 3);
  const JudgedFrame inBands = JudgeFrames(scene, pass);
  EXPECT_GT(pass->GetNumberOfBands(), 1);
  for (const JudgedFrame& judged : { whole, inBands })
  {
    EXPECT_LE(judged.WorstExcess, Single);
    EXPECT_LE(judged.LargestBound, 2.0);
  }
}

TEST(ErrorBudgetChoices, AreListedWithReasons)
{
  TestScene scene;
  scene.AddParts();
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  EXPECT_EQ(pass->GetNumberOfPlannedMethods(), 0);
  EXPECT_EQ(pass->GetPlannedMethod(0), "");
  EXPECT_EQ(pass->GetBudgetProblem(), "no frame was drawn by this pass");
  pass->SetErrorBudget(2.0 * Step);
  scene.Use(pass);
  scene.Render();
  scene.Render();
  ASSERT_EQ(pass->GetNumberOfPlannedMethods(), 4);
  EXPECT_EQ(pass->GetPlannedMethod(0), pass->GetChosenMethod());
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NE(pass->GetPlannedReason(i), "") << pass->GetPlannedMethod(i);
    EXPECT_GE(pass->GetPlannedPasses(i), 1.0);
    EXPECT_GE(pass->GetPlannedBytes(i), 16 * pass->GetNumberOfFragments());
    EXPECT_GE(pass->GetPlannedError(i), 0.5 * Step);
  }
  EXPECT_EQ(pass->GetPlannedMethod(4), "");
  EXPECT_EQ(pass->GetPlannedMethod(-1), "");
}

TEST(ErrorBudgetSettings, RefuseWhatNoPictureKeeps)
{
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  for (const double budget :
    { 0.0, -1.0, 0.5 * Step, 10.0, std::numeric_limits<double>::quiet_NaN() })
  {
    pass->SetErrorBudget(budget);
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 1u) << budget;
    EXPECT_NE(messages.front().find("ErrorBudget"), std::string::npos) << messages.front();
    EXPECT_EQ(pass->GetErrorBudget(), Step);
  }
}

TEST(ErrorBudgetSettings, BoundsAreKeptOnRequestOnly)
{
  TestScene scene;
  scene.AddParts();
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  vtkNew<vtkImageData> bounds;
  EXPECT_FALSE(pass->GetErrorBound(bounds));
  scene.Use(pass);
  scene.Render();
  EXPECT_FALSE(pass->GetErrorBound(bounds));
  EXPECT_FALSE(pass->GetErrorBound(nullptr));
  pass->KeepErrorBoundsOn();
  scene.Render();
  EXPECT_TRUE(pass->GetErrorBound(bounds));
  EXPECT_EQ(bounds->GetDimensions()[0], 64);
  EXPECT_EQ(bounds->GetDimensions()[1], 48);
}

TEST(ErrorBudgetSettings, FaintFragmentsCountEvenIfTheirAlphaIsStoredAsZero)
{
  TestScene scene(8, 8);
  for (int i = 0; i < 600; ++i)
  {
    scene.AddPlate(0.9 - 0.003 * i, { 1.0, 1.0, 1.0, 5e-8 });
  }
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(2.0 * Step);
  const JudgedFrame judged = JudgeFrames(scene, pass, 2);
  EXPECT_LE(judged.WorstExcess, Single);
  EXPECT_GT(judged.LargestBound, 255.0 * 600.0 * std::ldexp(1.0, -23));
}

TEST(ErrorBudgetSettings, AFrameWithoutTranslucentPropsHasNoError)
{
  TestScene scene;
  const vtkSmartPointer<vtkActor> plate = scene.AddPlate(0.25, { 0.9, 0.3, 0.5, 0.4 });
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->KeepErrorBoundsOn();
  scene.Use(pass);
  scene.Render();
  plate->VisibilityOff();
  scene.Render();
  vtkNew<vtkImageData> bounds;
  EXPECT_EQ(pass->GetBudgetProblem(), "");
  EXPECT_EQ(pass->GetGuaranteedError(), 0.0);
  ASSERT_TRUE(pass->GetErrorBound(bounds));
  EXPECT_EQ(bounds->GetScalarRange()[1], 0.0);
}

TEST(ErrorBudgetSettings, PixelsOutsideOfTheViewportHaveNoError)
{
  TestScene scene;
  const vtkSmartPointer<vtkActor> plate = scene.AddPlate(0.25, { 0.9, 0.3, 0.5, 0.4 });
  scene.Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(4.0 * Step);
  pass->SetColorError(1.0 * Step); // which pixels without fragments have
  pass->KeepErrorBoundsOn();
  scene.Use(pass);
  for (const int visible : { 1, 0 })
  {
    plate->SetVisibility(visible);
    scene.Render();
    vtkNew<vtkImageData> bounds;
    ASSERT_TRUE(pass->GetErrorBound(bounds));
    ASSERT_EQ(bounds->GetNumberOfPoints(), 64 * 48);
    for (int y = 0; y < 48; ++y)
    {
      for (int x = 0; x < 64; ++x)
      {
        const double bound = bounds->GetScalarComponentAsDouble(x, y, 0, 0) / Step;
        const bool isInside = x >= 32 && y >= 12 && y < 36;
        EXPECT_EQ(bound > 0.0, isInside) << visible << " " << x << " " << y;
        EXPECT_TRUE(visible || std::abs(bound - isInside) < 1e-5) << bound;
      }
    }
  }
}

TEST(ErrorBudgetSettings, ReleasesLeaveTheSamePicture)
{
  TestScene scene;
  scene.AddParts();
  vtkNew<vtkErrorBudgetTransparencyPass> pass;
  pass->SetErrorBudget(1.0 * Step); // half floats in all frames
  pass->KeepErrorBoundsOn();
  vtkNew<vtkSeeThroughPass> frame;
  frame->SetTranslucentPass(pass);
  scene.ExpectTheSameAfterReleases(frame);
  vtkNew<vtkImageData> bounds;
  EXPECT_TRUE(pass->GetErrorBound(bounds));
}

TEST(ErrorBudgetOfFrame, ChangesTheMethodAndPutsItBack)
{
  TestScene scene;
  scene.AddParts();
  vtkNew<vtkSeeThroughPass> frame;
  vtkNew<vtkPrefixSumTransparencyPass> before;
  frame->SetTranslucentPass(before);
  EXPECT_EQ(frame->GetErrorBudget(), 0.0);
  frame->SetErrorBudget(2.0 * Step);
  scene.Use(frame);
  scene.Render();
  scene.Render(); // The first frame chooses without knowledge.
  auto* const method = vtkErrorBudgetTransparencyPass::SafeDownCast(frame->GetTranslucentPass());
  ASSERT_NE(method, nullptr);
  EXPECT_EQ(method->GetChosenMethod(), "prefix-sum-predicted-compact");
  frame->SetErrorBudget(0.6 * Step);
  EXPECT_EQ(frame->GetTranslucentPass(), method);
  EXPECT_EQ(frame->GetErrorBudget(), 0.6 * Step);
  frame->SetErrorBudget(0.0);
  EXPECT_EQ(frame->GetTranslucentPass(), before);
  EXPECT_EQ(frame->GetErrorBudget(), 0.0);
}

TEST(ErrorBudgetOfFrame, IsThatOfTheMethodThatIsSet)
{
  vtkNew<vtkSeeThroughPass> frame;
  vtkNew<vtkErrorBudgetTransparencyPass> method;
  frame->SetTranslucentPass(method);
  EXPECT_EQ(frame->GetErrorBudget(), method->GetErrorBudget());
  frame->SetErrorBudget(0.0);
  EXPECT_NE(vtkLinkedListTransparencyPass::SafeDownCast(frame->GetTranslucentPass()), nullptr);
}

TEST(ErrorBudgetOfFrame, LeavesAMethodThatWasSetLater)
{
  vtkNew<vtkSeeThroughPass> frame;
  frame->SetErrorBudget(2.0 * Step);
  vtkNew<vtkPrefixSumTransparencyPass> later;
  frame->SetTranslucentPass(later);
  frame->SetErrorBudget(0.0);
  EXPECT_EQ(frame->GetTranslucentPass(), later);
}

TEST(ErrorBudgetOfFrame, RefusesWhatNoPictureKeeps)
{
  vtkNew<vtkSeeThroughPass> frame;
  vtkRenderPass* const before = frame->GetTranslucentPass();
  for (const double budget : { -1.0, 0.5 * Step, 10.0, std::numeric_limits<double>::quiet_NaN() })
  {
    frame->SetErrorBudget(budget);
    ASSERT_EQ(TakeMessages().size(), 1u) << budget;
    EXPECT_EQ(frame->GetTranslucentPass(), before);
    EXPECT_EQ(frame->GetErrorBudget(), 0.0);
  }
  for (const double milliseconds :
    { -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    frame->SetFrameTime(milliseconds);
    ASSERT_EQ(TakeMessages().size(), 1u) << milliseconds;
    EXPECT_EQ(frame->GetTranslucentPass(), before);
    EXPECT_EQ(frame->GetFrameTime(), 0.0);
  }
}

}
