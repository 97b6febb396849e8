// A tolerance for coincidence: what it groups is composited without an order, and nothing else changes.
#include "TestGroups.h"
#include "TestMessages.h"
#include "vtkABufferTransparencyPass.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

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

// A flat plate cuts through a tilted one, whose depth changes along one axis alone: they coincide as many pixels to either
// side of the cut as the tolerance has slopes.
TEST_P(Coincidence, ReachesAsManyPixelsAsSlopesToEitherSide)
{
  const Rgba red = { 1.0, 0.2, 0.0, 0.6 };
  const Rgba blue = { 0.0, 0.4, 1.0, 0.2 };
  const Rgba tiltedFirst = CompositePlates({ red, blue }, TestBackground);
  const Rgba flatFirst = CompositePlates({ blue, red }, TestBackground);
  constexpr int size = 40;
  constexpr int slopes = 3;
  for (const bool alongX : { true, false })
  {
    TestScene scene(size, size);
    scene.AddPlate(0.0, blue);
    scene.AddTriangle(alongX ? std::array<std::array<double, 3>, 3>{ { { -1, -9, -0.5 },
                                 { 1, 0, 0.5 }, { -1, 9, -0.5 } } }
                             : std::array<std::array<double, 3>, 3>{ { { -9, -1, -0.5 },
                                 { 9, -1, -0.5 }, { 0, 1, 0.5 } } },
      red);
    scene.Use(MakeTolerant(GetParam(), 0.0, slopes));
    const Picture picture = scene.Render();
    for (int i = 10; i < 30; ++i)
    {
      const double fromCut = i + 0.5 - size / 2;
      const Rgba color = alongX ? picture.At(i, size / 2) : picture.At(size / 2, i);
      const Rgba& ordered = fromCut > 0.0 ? tiltedFirst : flatFirst;
      for (int c = 0; c < 3; ++c)
      {
        const double mean = 0.5 * (tiltedFirst[c] + flatFirst[c]);
        EXPECT_NEAR(255 * color[c], 255 * (std::abs(fromCut) < slopes ? mean : ordered[c]),
          GetParam().Tolerance)
          << fromCut << " pixels from the cut";
      }
    }
  }
}

TEST_P(Coincidence, ByTheSlopeGroupsEqualDepthsOfFlatFaces)
{
  const Rgba red = { 1.0, 0.2, 0.0, 0.6 };
  const Rgba blue = { 0.0, 0.4, 1.0, 0.2 };
  const Rgba redFirst = CompositePlates({ red, blue }, TestBackground);
  const Rgba blueFirst = CompositePlates({ blue, red }, TestBackground);
  TestScene scene(9, 6);
  scene.AddPlate(0.3, red);
  scene.AddPlate(0.3, blue);
  scene.AddPlate(-0.3, { 0.0, 0.0, 0.0, 0.0 });
  scene.Use(MakeTolerant(GetParam(), 0.0, 1.0));
  const Rgba color = UniformColor(scene.Render());
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(255 * color[c], 127.5 * (redFirst[c] + blueFirst[c]), GetParam().Tolerance);
  }
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

}
