// A tolerance for coincidence: what it groups is composited without an order, and nothing else changes.
#include "TestGroups.h"
#include "gl/RenderTarget.h"
#include "transparency/common/CoincidenceTolerance.h"
#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkShaderProperty.h"
#include "vtkTruthTransparencyPass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace
{

constexpr Rgba Red = { 1.0, 0.2, 0.0, 0.6 };
constexpr Rgba Blue = { 0.0, 0.4, 1.0, 0.2 };

Rgba MeanOfBothOrders()
{
  const Rgba redFirst = CompositePlates({ Red, Blue }, TestBackground);
  const Rgba blueFirst = CompositePlates({ Blue, Red }, TestBackground);
  Rgba mean;
  for (int c = 0; c < 4; ++c)
  {
    mean[c] = 0.5 * (redFirst[c] + blueFirst[c]);
  }
  return mean;
}

// Two plates coincide within the sum of their tolerances. Heights differ by twice as much as depths.
constexpr double Reach = 4.0 * Noise;

class Coincidence : public testing::TestWithParam<Method>
{
};

TEST_P(Coincidence, PairsAreTheMeanOfBothOrdersToTheByte)
{
  for (const int samples : { 0, 4 })
  {
    TestScene scene(9, 6, samples);
    scene.Use(MakeTolerant(GetParam()));
    std::vector<Picture> pictures;
    for (const double noise : { -0.95, -0.02, 0.0, 0.02, 0.95 })
    {
      scene.Renderer->RemoveAllViewProps();
      scene.AddPlate(0.3, Red);
      scene.AddPlate(0.3 + noise * Reach, Blue);
      pictures.push_back(scene.Render());
      ExpectColor(UniformColor(pictures.back()), MeanOfBothOrders(), GetParam().Tolerance);
      EXPECT_TRUE(Matches(pictures.back(), pictures.front())) << "noise " << noise;
    }
  }
}

TEST_P(Coincidence, EndsBeyondTheTolerance)
{
  for (const double height : { 0.3 + 1.05 * Reach, 0.3 - 1.05 * Reach })
  {
    TestScene scene(9, 6);
    scene.AddPlate(0.3, Red);
    scene.AddPlate(height, Blue);
    scene.Use(MakeTolerant(GetParam()));
    const Picture picture = scene.Render();
    scene.Use(GetParam().Make());
    EXPECT_TRUE(Matches(picture, scene.Render()));
  }
}

// There the near ends of intervals are cut off, and their far ends must not move away for it.
TEST_P(Coincidence, EndsBeyondTheToleranceAtTheNearPlane)
{
  const double tolerance = 0.05; // five times the depth of the nearer plate
  const auto heightAt = [](double depth) { return 1.0 - 2.0 * depth; };
  for (const bool within : { true, false })
  {
    TestScene scene(9, 6);
    scene.AddPlate(heightAt(0.01), Red);
    scene.AddPlate(heightAt(0.01 + (within ? 1.95 : 2.05) * tolerance), Blue);
    scene.Use(MakeTolerant(GetParam(), std::ldexp(tolerance, 24)));
    ExpectColor(UniformColor(scene.Render()),
      within ? MeanOfBothOrders() : CompositePlates({ Red, Blue }, TestBackground),
      GetParam().Tolerance);
  }
}

// A plate between two others joins them, unless it is not seen.
TEST_P(Coincidence, IsNotPassedOnByWhatIsNotSeen)
{
  for (const int samples : { 0, 4 })
  {
    for (const double alpha : { 0.0, 1.0 / 255 })
    {
      TestScene scene(9, 6, samples);
      scene.AddPlates({ Red, { 1.0, 1.0, 1.0, alpha }, Blue },
        { 0.3, 0.3 - 0.45 * Reach, 0.3 - 1.2 * Reach }, 62);
      scene.Use(GetParam().Make());
      const Picture ordered = scene.Render();
      scene.Use(MakeTolerant(GetParam()));
      EXPECT_EQ(scene.Render() == ordered, alpha == 0.0) << "alpha " << alpha;
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
  TestScene scene(40, 30);
  std::vector<Picture> pictures;
  for (const double noise : { -1e-4, 1e-4 })
  {
    scene.Renderer->RemoveAllViewProps();
    scene.AddTriangle({ { { -4, -4, -0.9 }, { 4, -4, 0.9 }, { 0, 4, 0.5 } } }, Red);
    scene.AddTriangle(
      { { { -4, -4, -0.9 + noise }, { 4, -4, 0.9 + noise }, { 0, 4, 0.5 + noise } } }, Blue);
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.05));
    pictures.push_back(scene.Render());
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.0005));
    EXPECT_FALSE(scene.Render() == pictures.back());
  }
  EXPECT_TRUE(Matches(pictures[0], pictures[1]));
}

// A flat plate cuts through a tilted one, whose depth changes along one axis only. They coincide on either side of the
// cut, over as many pixels as the tolerance has slopes.
TEST_P(Coincidence, ReachesAsManyPixelsAsSlopesToEitherSide)
{
  const Rgba tiltedFirst = CompositePlates({ Red, Blue }, TestBackground);
  const Rgba flatFirst = CompositePlates({ Blue, Red }, TestBackground);
  constexpr int size = 40;
  constexpr int slopes = 3;
  for (const bool alongX : { true, false })
  {
    TestScene scene(size, size);
    scene.AddPlate(0.0, Blue);
    scene.AddTriangle(alongX ? std::array<std::array<double, 3>, 3>{ { { -1, -9, -0.5 },
                                 { 1, 0, 0.5 }, { -1, 9, -0.5 } } }
                             : std::array<std::array<double, 3>, 3>{ { { -9, -1, -0.5 },
                                 { 9, -1, -0.5 }, { 0, 1, 0.5 } } },
      Red);
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
  TestScene scene(9, 6);
  scene.AddPlate(0.3, Red);
  scene.AddPlate(0.3, Blue);
  scene.AddPlate(-0.3, { 0.0, 0.0, 0.0, 0.0 });
  scene.Use(MakeTolerant(GetParam(), 0.0, 1.0));
  ExpectColor(UniformColor(scene.Render()), MeanOfBothOrders(), GetParam().Tolerance);
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
      scene.AddRectangle(-2, -2, 2, 2, 0.0, offset == 0.0 ? Red : Blue)
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
  EXPECT_TRUE(Matches(pictures[0], pictures[1]));
}

// One plane consists of impostors, whose shader discards fragments outside of a circle. Along its rim slopes may be
// anything, so either order, or none, is right.
TEST_P(Coincidence, TakesTheSlopeOfDepthsThatAreNotThrownAway)
{
  const int width = 40;
  const int height = 30;
  const double radius = 12.0;
  const Rgba rims[] = { MeanOfBothOrders(), CompositePlates({ Red, Blue }, TestBackground),
    CompositePlates({ Blue, Red }, TestBackground) };
  for (const double noise : { -1e-4, 1e-4 })
  {
    TestScene scene(width, height);
    for (const double offset : { 0.0, noise })
    {
      scene.AddRectangle(-2, -2, 2, 2, 0.0, offset == 0.0 ? Red : Blue)
        ->GetShaderProperty()
        ->AddFragmentShaderReplacement("//VTK::Depth::Impl", true,
          "if (distance(gl_FragCoord.xy, vec2(20.0, 15.0)) > 12.0) discard;\n"
          "gl_FragDepth = 0.3 + 0.01 * gl_FragCoord.x + float(" +
            std::to_string(offset) + ");\n",
          false);
    }
    scene.Use(MakeTolerant(GetParam(), 0.0, 0.05));
    const Picture picture = scene.Render();
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
        const double fromRim = std::hypot(x + 0.5 - width / 2, y + 0.5 - height / 2) - radius;
        const Rgba color = picture.At(x, y);
        const bool isRim = fromRim > -1.5 && fromRim <= 0.0; // a neighbour may be gone
        if (isRim)
        {
          EXPECT_TRUE(std::any_of(std::begin(rims), std::end(rims),
            [&](const Rgba& rim) { return std::abs(255 * (color[0] - rim[0])) <= 1.0; }));
        }
        else
        {
          ExpectColor(color, fromRim > 0.0 ? TestBackground : rims[0], GetParam().Tolerance);
        }
      }
    }
  }
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

TEST(CoincidenceTolerance, CanBeHadWithSixteenSamples)
{
  const vitrine::CoincidenceTolerance none;
  const vitrine::CoincidenceTolerance some = { 1.0, 0.0 };
  vitrine::RenderTarget target;
  for (const int samples : { 0, 1, 4, 16, 17, 32 })
  {
    target.Samples = samples;
    EXPECT_EQ(none.FindProblemIn(target), "");
    const std::string problem = some.FindProblemIn(target);
    EXPECT_EQ(problem.empty(), samples <= 16) << problem;
    if (samples > 16)
    {
      EXPECT_NE(problem.find("16 samples"), std::string::npos) << problem;
      EXPECT_NE(problem.find("has " + std::to_string(samples)), std::string::npos) << problem;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Coincidence, testing::ValuesIn(TolerantMethods()), MethodName());

}
