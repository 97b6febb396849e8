// Coincident fragments in lists of every length: closed forms, and what storage and memory have to do with them.
#include "TestGroups.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

class CoincidentGroups : public testing::TestWithParam<Method>
{
};

const std::vector<int> SingleSampled = { 7, 16, 64, 65, 300, 3000 };
const std::vector<int> Multisampled = { 30, 300, 1100 };

// Lists of every bin, with groups that cross the ends of runs and blocks.
TEST_P(CoincidentGroups, GroupsAreTheClosedForm)
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
      std::vector<Picture> pictures;
      for (const std::uint64_t seed : { 42u, 43u, 44u })
      {
        const vtkSmartPointer<vtkActor> actor =
          scene.AddPlates(groups.Plates, Noisy(groups.Heights, seed), seed);
        pictures.push_back(scene.Render());
        ExpectColor(UniformColor(pictures.back()), expected, GetParam().Tolerance);
        // Sums in another order may round to the next byte.
        EXPECT_TRUE(Matches(pictures.back(), pictures.front(), 1));
        scene.Renderer->RemoveActor(actor);
      }
    }
  }
}

// The same without noise, but in other orders of arrival: the same to the byte, whatever the bin.
TEST_P(CoincidentGroups, GroupsArriveInAnyOrder)
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
      EXPECT_TRUE(Matches(pictures.back(), pictures.front()));
      scene.Renderer->RemoveActor(actor);
    }
  }
}

TEST_P(CoincidentGroups, WithoutAnyIsThePictureWithoutTheTolerance)
{
  for (const int samples : { 0, 4 })
  {
    for (const int layers :
      samples > 0 ? std::vector<int>{ 300 } : std::vector<int>{ 16, 65, 3000 })
    {
      SCOPED_TRACE(std::to_string(layers) + " layers, samples " + std::to_string(samples));
      TestScene scene(9, 6, samples);
      scene.AddPlates(RandomPlates(layers, std::max(1.0 / 255, 1.0 / layers), 49), 50);
      const vtkSmartPointer<vtkTransparencyPass> pass = GetParam().Make();
      scene.Use(pass);
      const Picture without = scene.Render();
      SetTolerance(pass, Steps, 1.0);
      EXPECT_TRUE(Matches(scene.Render(), without));
      SetTolerance(pass, 0.0);
      EXPECT_TRUE(Matches(scene.Render(), without));
    }
  }
}

// Each opaque fragment of a group is the nearest one equally often. There are so many that floats cannot tell what is
// seen behind, and more than one run or block sorts. The time of truth grows with the square of the group.
TEST_P(CoincidentGroups, OfAnyNumberOfOpaqueOnesAreTheirMean)
{
  const Rgba red = { 1.0, 0.0, 0.4, 1.0 };
  const Rgba blue = { 0.0, 0.2, 1.0, 1.0 };
  TestScene scene(1, 1);
  const vtkSmartPointer<vtkTransparencyPass> pass = MakeTolerant(GetParam());
  const int most = vtkABufferTransparencyPass::SafeDownCast(pass) ? 20000 : 5000;
  scene.Use(pass);
  for (const int layers : { 1000, 1025, 5000, 9000, 12000, 20000 })
  {
    for (const int reds : { layers, layers / 2 })
    {
      if (layers > most)
      {
        continue;
      }
      SCOPED_TRACE(std::to_string(reds) + " of " + std::to_string(layers) + " layers are red");
      std::vector<Rgba> plates(reds, red);
      plates.resize(layers, blue);
      Rgba mean = { 0.0, 0.0, 0.0, 1.0 };
      for (int c = 0; c < 3; ++c)
      {
        mean[c] = (reds * red[c] + (layers - reds) * blue[c]) / layers;
      }
      const vtkSmartPointer<vtkActor> actor =
        scene.AddPlates(plates, std::vector<double>(layers, 0.3), 63);
      // The window rounds by up to half a step.
      ExpectColor(UniformColor(scene.Render()), mean, reds == layers ? 0.0 : 0.5 + 1.0 / 3.0);
      scene.Renderer->RemoveActor(actor);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, CoincidentGroups, testing::ValuesIn(TolerantMethods()), MethodName());

// Colours of any alpha, many at one depth: the mean within a third of a step, and what storage adds.
class CoincidentStorage : public testing::TestWithParam<Method>
{
};

// One group: the first of its plates are red, the others green.
Groups OfTwoAlphas(int layers, int reds, double alphaOfReds, double alphaOfGreens)
{
  const Rgba red = { 1.0, 0.0, 0.4, alphaOfReds };
  const Rgba green = { 0.0, 1.0, 0.4, alphaOfGreens };
  Groups groups;
  groups.Plates.assign(reds, red);
  groups.Plates.resize(layers, green);
  groups.Heights.assign(layers, 0.3);
  groups.Sizes = { layers };
  return groups;
}

TEST_P(CoincidentStorage, LargeGroupsOfHostileAlphasAreTheClosedForm)
{
  const double alphas[] = { 0.0, 1.0, 128.0 / 255, 1.0 / 255, 252.0 / 255, 56.0 / 255 };
  TestScene scene(3, 2);
  scene.Use(MakeTolerant(GetParam()));
  for (const int layers : { 2, 8, 9, 32, 200, 1000 })
  {
    for (const int share : { 2, 4, 8 })
    {
      for (const double few : alphas)
      {
        for (const double many : alphas)
        {
          if (few <= many) // the error is larger where the more opaque are fewer
          {
            continue;
          }
          SCOPED_TRACE(std::to_string(layers / share) + " of " + std::to_string(layers) +
            " layers with alpha " + std::to_string(few) + ", others " + std::to_string(many));
          const Groups groups = OfTwoAlphas(layers, layers / share, few, many);
          const vtkSmartPointer<vtkActor> actor =
            scene.AddPlates(groups.Plates, groups.Heights, 56);
          ExpectColor(
            UniformColor(scene.Render()), ClosedForm(groups), GetParam().Tolerance + 1.0 / 3.0);
          scene.Renderer->RemoveActor(actor);
        }
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

TEST_P(CoincidentStorage, TakesAWordMoreUnlessMultisampled)
{
  for (const int samples : { 0, 4 })
  {
    const auto without = static_cast<double>(PoolBytesOf(GetParam(), samples, 0.0));
    const auto with = static_cast<double>(PoolBytesOf(GetParam(), samples, Steps));
    const double node = GetParam().NodeBytes();
    EXPECT_NEAR(with / without, samples > 0 ? 1.0 : (node + 4.0) / node, 0.04);
  }
}

TEST_P(CoincidentStorage, BandsAreTheWholePicture)
{
  TestScene scene(61, 47);
  scene.AddParts();
  const Groups groups = RandomGroups(30, { 2, 1, 3 }, 0.1, 59);
  scene.AddPlates(groups.Plates, Noisy(groups.Heights, 60), 61);
  const vtkSmartPointer<vtkABufferTransparencyPass> pass = MakeABuffer(GetParam());
  SetTolerance(pass, Steps, 0.5);
  scene.Use(pass);
  const Picture whole = scene.Render();
  const vtkTypeInt64 bytes = pass->GetNumberOfFragments() * (GetParam().NodeBytes() + 4);
  for (const int parts : { 3, 20 })
  {
    pass->SetMemoryLimit(bytes / parts);
    EXPECT_TRUE(Matches(scene.Render(), whole));
    EXPECT_GE(pass->GetNumberOfBands(), parts);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Methods, CoincidentStorage, testing::ValuesIn(ABufferMethods()), MethodName());

}
