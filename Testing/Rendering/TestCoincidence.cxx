// A tolerance for coincidence: what it groups is composited without an order, and nothing else changes.
#include "Core/CoincidentGroup.h"
#include "TestMessages.h"
#include "TestMethods.h"
#include "TestScene.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

// What noise of the tests stays below, and what it does not. Plates stand at heights over two units of depth.
constexpr double Steps = 64.0;
const double Noise = std::ldexp(Steps, -24);

void SetTolerance(vtkTransparencyPass* pass, double steps, double slope = 0.0)
{
  if (auto* lists = vtkABufferTransparencyPass::SafeDownCast(pass))
  {
    lists->SetCoincidenceSteps(steps);
    lists->SetCoincidenceSlope(slope);
  }
  if (auto* truth = vtkTruthTransparencyPass::SafeDownCast(pass))
  {
    truth->SetCoincidenceSteps(steps);
    truth->SetCoincidenceSlope(slope);
  }
}

vtkSmartPointer<vtkTransparencyPass> MakeTolerant(
  const Method& method, double steps = Steps, double slope = 0.0)
{
  vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
  SetTolerance(pass, steps, slope);
  return pass;
}

std::vector<Method> TolerantMethods()
{
  return MethodsThat(
    [](const Method& method)
    {
      const vtkSmartPointer<vtkTransparencyPass> pass = method.Make();
      return vtkABufferTransparencyPass::SafeDownCast(pass) ||
        vtkTruthTransparencyPass::SafeDownCast(pass);
    });
}

// Plates in groups, front to back, each of one height but for noise.
struct Groups
{
  std::vector<Rgba> Plates;
  std::vector<double> Heights;
  std::vector<int> Sizes;
};

Groups RandomGroups(int layers, const std::vector<int>& sizes, double alpha, std::uint64_t seed)
{
  Groups groups;
  groups.Plates = RandomPlates(layers, alpha, seed);
  while (static_cast<int>(groups.Heights.size()) < layers)
  {
    const int number = static_cast<int>(groups.Sizes.size());
    const int left = layers - static_cast<int>(groups.Heights.size());
    groups.Sizes.push_back(std::min(sizes[number % sizes.size()], left));
    groups.Heights.insert(groups.Heights.end(), groups.Sizes.back(), -number);
  }
  for (double& height : groups.Heights)
  {
    height = 0.9 + 1.8 * height / static_cast<double>(groups.Sizes.size());
  }
  return groups;
}

std::vector<double> Noisy(const std::vector<double>& heights, std::uint64_t seed)
{
  TestRandom random(seed);
  std::vector<double> noisy = heights;
  for (double& height : noisy)
  {
    height += Noise * random.Unit();
  }
  return noisy;
}

Rgba ClosedForm(const Groups& groups)
{
  std::vector<Rgba> layers;
  std::size_t at = 0;
  for (const int size : groups.Sizes)
  {
    vitrine::CoincidentGroup group;
    for (const std::size_t end = at + size; at < end; ++at)
    {
      group.Add(groups.Plates[at][3], groups.Plates[at].data());
    }
    Rgba mean = { 0.0, 0.0, 0.0, 1.0 - group.Transmittance() };
    group.AddColor(1.0 / std::max(mean[3], 1e-30), mean.data());
    layers.push_back(mean);
  }
  return CompositePlates(layers, TestBackground);
}

class Coincidence : public testing::TestWithParam<Method>
{
};

TEST_P(Coincidence, PairsAreTheMeanOfBothOrdersToTheByte)
{
  const Rgba red = { 1.0, 0.2, 0.0, 0.6 };
  const Rgba blue = { 0.0, 0.4, 1.0, 0.2 };
  const Rgba redFirst = CompositePlates({ red, blue }, TestBackground);
  const Rgba blueFirst = CompositePlates({ blue, red }, TestBackground);
  Rgba mean;
  for (int c = 0; c < 4; ++c)
  {
    mean[c] = 0.5 * (redFirst[c] + blueFirst[c]);
  }
  for (const int samples : { 0, 4 })
  {
    TestScene scene(9, 6, samples);
    scene.Use(MakeTolerant(GetParam()));
    std::vector<Picture> pictures;
    for (const double noise : { -0.9, -0.1, 0.0, 0.1, 0.9 })
    {
      scene.Renderer->RemoveAllViewProps();
      scene.AddPlate(0.3, red);
      scene.AddPlate(0.3 + noise * Noise, blue);
      pictures.push_back(scene.Render());
      ExpectColor(UniformColor(pictures.back()), mean, GetParam().Tolerance);
      EXPECT_TRUE(pictures.back() == pictures.front()) << "noise " << noise;
    }
  }
}

TEST_P(Coincidence, EndsBeyondTheTolerance)
{
  const Rgba red = { 1.0, 0.2, 0.0, 0.6 };
  const Rgba blue = { 0.0, 0.4, 1.0, 0.2 };
  for (const double height : { 0.3 + 5 * Noise, 0.3 - 5 * Noise })
  {
    TestScene scene(9, 6);
    scene.AddPlate(0.3, red);
    scene.AddPlate(height, blue);
    scene.Use(MakeTolerant(GetParam()));
    const Picture picture = scene.Render();
    scene.Use(GetParam().Make());
    EXPECT_TRUE(picture == scene.Render());
  }
}

const std::vector<int> SingleSampled = { 7, 16, 64, 65, 300, 3000 };
const std::vector<int> Multisampled = { 30, 300, 1100 };

// Lists of every bin, with groups that cross the ends of runs and blocks.
TEST_P(Coincidence, GroupsAreTheClosedForm)
{
  for (const int samples : { 0, 4 })
  {
    TestScene scene(6, 5, samples);
    scene.Use(MakeTolerant(GetParam()));
    for (const int layers : samples > 0 ? Multisampled : SingleSampled)
    {
      SCOPED_TRACE(std::to_string(layers) + " layers, samples " + std::to_string(samples));
      const Groups groups =
        RandomGroups(layers, { 1, 2, 1, 3, 8, 33, 2, 100 }, std::max(1.0 / 255, 2.0 / layers), 41);
      const Rgba expected = ClosedForm(groups);
      for (const std::uint64_t seed : { 42u, 43u, 44u })
      {
        const vtkSmartPointer<vtkActor> actor =
          scene.AddPlates(groups.Plates, Noisy(groups.Heights, seed), seed);
        ExpectColor(UniformColor(scene.Render()), expected, GetParam().Tolerance);
        scene.Renderer->RemoveActor(actor);
      }
    }
  }
}

// The same without noise, but in other orders of arrival: the same to the byte, whatever the bin.
TEST_P(Coincidence, GroupsArriveInAnyOrder)
{
  TestScene scene(6, 5);
  scene.Use(MakeTolerant(GetParam()));
  for (const int layers : { 7, 64, 65, 300, 1100 })
  {
    SCOPED_TRACE(std::to_string(layers) + " layers");
    const Groups groups = RandomGroups(layers, { 3, 40, 1 }, 4.0 / layers, 45);
    std::vector<Picture> pictures;
    for (const std::uint64_t seed : { 46u, 47u, 48u })
    {
      const vtkSmartPointer<vtkActor> actor = scene.AddPlates(groups.Plates, groups.Heights, seed);
      pictures.push_back(scene.Render());
      EXPECT_TRUE(pictures.back() == pictures.front());
      scene.Renderer->RemoveActor(actor);
    }
  }
}

TEST_P(Coincidence, WithoutAnyIsThePictureWithoutTheTolerance)
{
  for (const int samples : { 0, 4 })
  {
    for (const int layers : samples > 0 ? Multisampled : SingleSampled)
    {
      SCOPED_TRACE(std::to_string(layers) + " layers, samples " + std::to_string(samples));
      TestScene scene(9, 6, samples);
      scene.AddPlates(RandomPlates(layers, std::max(1.0 / 255, 1.0 / layers), 49), 50);
      const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
      scene.Use(pass);
      const Picture without = scene.Render();
      SetTolerance(pass, Steps, 1.0);
      EXPECT_TRUE(scene.Render() == without);
      SetTolerance(pass, 0.0);
      EXPECT_TRUE(scene.Render() == without);
    }
  }
}

// Spheres that cut each other, with groups along the cuts and silhouettes.
TEST_P(Coincidence, OfPartsIsTruthOfTheSameTolerance)
{
  for (const int samples : { 0, 4 })
  {
    TestScene scene(61, 47, samples);
    scene.AddParts();
    scene.AddTriangle(
      { { { -0.9, -0.9, -0.5 }, { 0.9, -0.6, 0.1 }, { 0.0, 0.9, 0.7 } } }, { 0.9, 0.9, 0.3, 0.6 });
    scene.AddTriangle(
      { { { 0.9, -0.6, 0.1 }, { 0.0, 0.9, 0.7 }, { -0.9, -0.9, -0.5 } } }, { 0.1, 0.2, 0.3, 0.4 });
    vtkNew<vtkTruthTransparencyPass> truth;
    scene.Use(truth);
    const Picture ordered = scene.Render();
    SetTolerance(truth, Steps, 2.0);
    const Picture grouped = scene.Render();
    EXPECT_GT(LargestDifference(ordered, grouped), 5);

    scene.Use(MakeTolerant(GetParam(), Steps, 2.0));
    EXPECT_LE(DistanceFromTruth(scene.Render(), truth->GetResult()),
      GetParam().Tolerance +
        (samples > 0 ? 0.5 : 0.0)); // each sample is rounded, and so is their mean
  }
}

// Two corners of a plane, tilted, whose heights differ by less than a hundredth of its change over a pixel.
TEST_P(Coincidence, ByTheSlopeGroupsTiltedFaces)
{
  const Rgba red = { 1.0, 0.2, 0.0, 0.6 };
  const Rgba blue = { 0.0, 0.4, 1.0, 0.2 };
  TestScene scene(40, 30);
  std::vector<Picture> pictures;
  for (const double noise : { -1e-4, 1e-4 })
  {
    scene.Renderer->RemoveAllViewProps();
    scene.AddTriangle({ { { -4, -4, -0.9 }, { 4, -4, 0.9 }, { 0, 4, 0.5 } } }, red);
    scene.AddTriangle(
      { { { -4, -4, -0.9 + noise }, { 4, -4, 0.9 + noise }, { 0, 4, 0.5 + noise } } }, blue);
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.05));
    pictures.push_back(scene.Render());
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.0005));
    EXPECT_FALSE(scene.Render() == pictures.back());
  }
  EXPECT_TRUE(pictures[0] == pictures[1]);
}

// The slope that counts is that of the depth that a shader writes, not of the geometry.
TEST_P(Coincidence, TakesTheSlopeOfWrittenDepths)
{
  std::vector<Picture> pictures;
  for (const double noise : { -1e-4, 1e-4 })
  {
    TestScene scene(40, 30);
    for (const double offset : { 0.0, noise })
    {
      scene
        .AddRectangle(-2, -2, 2, 2, 0.0,
          offset == 0.0 ? Rgba{ 1.0, 0.2, 0.0, 0.6 } : Rgba{ 0.0, 0.4, 1.0, 0.2 })
        ->GetShaderProperty()
        ->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
          "gl_FragDepth = 0.3 + 0.01 * gl_FragCoord.x + float(" + std::to_string(offset) + ");\n",
          false);
    }
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.05));
    pictures.push_back(scene.Render());
    scene.Use(MakeTolerant(GetParam(), 1.0, 0.0005));
    EXPECT_FALSE(scene.Render() == pictures.back());
  }
  EXPECT_TRUE(pictures[0] == pictures[1]);
}

TEST_P(Coincidence, OfAllDepthIsOneGroup)
{
  TestScene scene(6, 5);
  const Groups groups = RandomGroups(20, { 20 }, 0.2, 53);
  std::vector<double> heights;
  for (int i = 0; i < 20; ++i)
  {
    heights.push_back(0.9 - 0.09 * i);
  }
  scene.AddPlates(groups.Plates, heights, 54);
  scene.Use(MakeTolerant(GetParam(), 1e30, 1e30));
  ExpectColor(UniformColor(scene.Render()), ClosedForm(groups), GetParam().Tolerance);
}

TEST_P(Coincidence, RefusesWhatIsNoTolerance)
{
  const vtkSmartPointer<vtkTransparencyPass> pass = MakeTolerant(GetParam(), 3.0, 0.5);
  for (const double bad : { -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    SetTolerance(pass, bad, bad);
    const std::vector<std::string> messages = TakeMessages();
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_NE(messages[0].find("finite numbers of at least 0"), std::string::npos) << messages[0];
  }
  if (auto* lists = vtkABufferTransparencyPass::SafeDownCast(pass))
  {
    EXPECT_EQ(lists->GetCoincidenceSteps(), 3.0);
    EXPECT_EQ(lists->GetCoincidenceSlope(), 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Coincidence, testing::ValuesIn(TolerantMethods()), MethodName());

// Colours of any alpha, many at one depth: the mean within a quarter of a step, and what storage adds.
class CoincidenceStorage : public testing::TestWithParam<Method>
{
};

TEST_P(CoincidenceStorage, LargeGroupsOfHostileAlphasAreTheClosedForm)
{
  const std::vector<double> alphas = { 0.0, 1.0, 128.0 / 255, 1.0 / 255, 252.0 / 255, 51.0 / 255 };
  TestScene scene(3, 2);
  scene.Use(MakeTolerant(GetParam()));
  for (const int layers : { 2, 8, 9, 16, 32, 64, 200, 1000 })
  {
    for (std::size_t a = 0; a < alphas.size(); ++a)
    {
      for (std::size_t b = a + 1; b < alphas.size(); ++b)
      {
        SCOPED_TRACE(std::to_string(layers) + " layers, alphas " + std::to_string(alphas[a]) +
          " and " + std::to_string(alphas[b]));
        Groups groups = RandomGroups(layers, { layers }, 0.5, 55);
        for (int i = 0; i < layers; ++i)
        {
          const bool first = i < layers / 2;
          groups.Plates[i] = { first ? 1.0 : 0.0, first ? 0.0 : 1.0, 0.4, alphas[first ? a : b] };
        }
        const vtkSmartPointer<vtkActor> actor = scene.AddPlates(groups.Plates, groups.Heights, 56);
        ExpectColor(UniformColor(scene.Render()), ClosedForm(groups), GetParam().Tolerance + 0.25);
        scene.Renderer->RemoveActor(actor);
      }
    }
  }
}

// Of a first frame, which expects nothing.
vtkTypeInt64 PoolBytesOf(const Method& method, int samples, double steps)
{
  TestScene scene(64, 48, samples);
  scene.AddPlates(RandomPlates(50, 0.1, 57), 58);
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(method);
  SetTolerance(pass, Steps);
  SetTolerance(pass, steps);
  scene.Use(pass);
  scene.Render();
  EXPECT_STREQ(pass->GetFallbackReason(), "");
  return pass->GetPoolBytes();
}

TEST_P(CoincidenceStorage, TakesAWordMoreUnlessMultisampled)
{
  for (const int samples : { 0, 4 })
  {
    const auto without = static_cast<double>(PoolBytesOf(GetParam(), samples, 0.0));
    const auto with = static_cast<double>(PoolBytesOf(GetParam(), samples, Steps));
    const double node = GetParam().NodeBytes();
    EXPECT_NEAR(with / without, samples > 0 ? 1.0 : (node + 4.0) / node, 0.04);
  }
}

TEST_P(CoincidenceStorage, BandsAreTheWholePicture)
{
  TestScene scene(61, 47);
  scene.AddParts();
  const Groups groups = RandomGroups(30, { 2, 1, 3 }, 0.1, 59);
  scene.AddPlates(groups.Plates, Noisy(groups.Heights, 60), 61);
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(GetParam());
  SetTolerance(pass, Steps, 0.5);
  scene.Use(pass);
  const Picture whole = scene.Render();
  const vtkTypeInt64 bytes = pass->GetFragmentCount() * (GetParam().NodeBytes() + 4);
  for (const int parts : { 3, 20 })
  {
    pass->SetMemoryLimit(bytes / parts);
    EXPECT_TRUE(scene.Render() == whole);
    EXPECT_GE(pass->GetNumberOfBands(), parts);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, CoincidenceStorage, testing::ValuesIn(ABufferMethods()), MethodName());

}
