// What lights reach, by VTK's formula, whatever they are made of.

#include "Core/lighting/LightVolume.h"

#include "LightScenes.h"
#include "NonFinite.h"

#include <gtest/gtest.h>

namespace
{

using light_scenes::LightReaches;
using light_scenes::RandomDirection;
using light_scenes::UniformIn;
using vitrine::BallPart;
using vitrine::Box;
using vitrine::LightShape;
using vitrine::LightVolume;
using LightKinds = vitrine::LightShape::Kinds;

LightKinds KindOf(float range, float angle, const glm::vec3& axis = { 0, 0, -1 })
{
  return LightShape({ { 1, 2, 3 }, range, axis, angle }).Kind;
}

LightVolume RandomCone(std::mt19937& random)
{
  const float angles[] = { 0.0f, 0.1f, 0.5f, 5, 30, 45, 50, 70, 89, 89.99f, -20 };
  const float scale = static_cast<float>(std::pow(10.0, UniformIn(random, -2, 3)));
  LightVolume cone;
  cone.Position = scale * RandomDirection(random);
  cone.Range = static_cast<float>(std::pow(10.0, UniformIn(random, -2, 3)));
  cone.Axis = RandomDirection(random);
  cone.ConeAngle = angles[random() % 11];
  return cone;
}

/** A point in it, mostly near the rim. */
glm::dvec3 PointIn(const LightVolume& cone, std::mt19937& random)
{
  const glm::dvec3 axis(cone.Axis);
  const glm::dvec3 aside =
    glm::normalize(glm::cross(axis, glm::dvec3(RandomDirection(random)) + 1e-3));
  const double share = random() % 2 == 0 ? 1.0 : UniformIn(random, 0, 1);
  const double angle = share * glm::radians(std::abs(static_cast<double>(cone.ConeAngle)));
  const double distance = cone.Range * (random() % 2 == 0 ? 1.0 : UniformIn(random, 0, 1));
  return glm::dvec3(cone.Position) + distance * (std::cos(angle) * axis + std::sin(angle) * aside);
}
}

TEST(LightVolume, IsWhatVTKsFormulaSays)
{
  EXPECT_EQ(KindOf(5, 180), LightKinds::Ball);
  EXPECT_EQ(KindOf(5, 90), LightKinds::Ball);
  EXPECT_EQ(KindOf(5, 89), LightKinds::Cone);
  EXPECT_EQ(
    KindOf(5, 0), LightKinds::Cone); // lights what is right before it, in a shader's rounding
  EXPECT_EQ(KindOf(5, -30), LightKinds::Cone);  // the cosine is that of 30
  EXPECT_EQ(KindOf(5, -100), LightKinds::Ball); // more than half of space
  EXPECT_EQ(KindOf(Infinity, 180), LightKinds::Everywhere);
  EXPECT_EQ(KindOf(Infinity, 30), LightKinds::Cone);
  EXPECT_EQ(KindOf(0, 180), LightKinds::Nowhere);
  EXPECT_EQ(KindOf(-1, 180), LightKinds::Nowhere);
  EXPECT_EQ(KindOf(1e30f, 180), LightKinds::Everywhere);
}

TEST(LightVolume, WithoutAnAxisLightsNothing)
{
  EXPECT_EQ(KindOf(5, 30, glm::vec3(0)), LightKinds::Nowhere); // position and focal point are one
  EXPECT_EQ(KindOf(5, -100, glm::vec3(0)), LightKinds::Ball);  // 0 >= cos(100)
  EXPECT_EQ(KindOf(5, 30, glm::vec3(NotANumber)), LightKinds::Nowhere);
  EXPECT_EQ(KindOf(5, 180, glm::vec3(NotANumber)), LightKinds::Ball);
  EXPECT_EQ(
    KindOf(5, 30, glm::vec3(0, 0, 0.5f)), LightKinds::Nowhere); // half the cosine never suffices
  EXPECT_EQ(KindOf(5, 80, glm::vec3(0, 0, 0.5f)), LightKinds::Cone);
}

TEST(LightVolume, OfNoNumberIsEverywhere)
{
  EXPECT_EQ(KindOf(NotANumber, 180), LightKinds::Everywhere);
  EXPECT_EQ(KindOf(5, NotANumber), LightKinds::Ball);
  EXPECT_EQ(KindOf(5, Infinity), LightKinds::Ball);
  for (const float bad : { NotANumber, Infinity, -Infinity, 1e30f })
  {
    EXPECT_EQ(LightShape({ { 1, bad, 3 }, 5.0f, { 0, 0, -1 }, 180 }).Kind, LightKinds::Everywhere);
    EXPECT_EQ(LightShape({ { 1, bad, 3 }, 5.0f, { 0, 0, -1 }, 30 }).Kind, LightKinds::Everywhere);
  }
}

TEST(LightVolume, ConesAreHeldByWhatIsAroundThem)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const LightVolume cone = RandomCone(random);
    const LightShape shape(cone);
    ASSERT_EQ(shape.Kind, LightKinds::Cone);
    const Box box = shape.Bounds();
    const BallPart ball = shape.Enclosing();
    const glm::vec3 direction = RandomDirection(random);
    for (int j = 0; j < 20; ++j)
    {
      const glm::dvec3 point = PointIn(cone, random);
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_LE(box.Min[axis], point[axis]) << i;
        ASSERT_GE(box.Max[axis], point[axis]) << i;
      }
      ASSERT_LE(glm::length(point - glm::dvec3(ball.Centre)), ball.Radius) << i;
      const glm::dvec3 away = point - glm::dvec3(cone.Position);
      ASSERT_LE(
        glm::dot(away, glm::dvec3(direction)), shape.SupportAlong(direction) + 1e-6 * cone.Range)
        << i;
      const double radius = std::pow(10.0, UniformIn(random, -3, 2));
      const glm::vec3 centre(point + 0.999 * radius * glm::dvec3(RandomDirection(random)));
      ASSERT_TRUE(shape.MayTouch(centre, static_cast<float>(radius))) << i;
    }
  }
}

TEST(LightVolume, ConesTouchNoBallsFarAside)
{
  const LightShape cone({ { 0, 0, 0 }, 10.0f, { 0, 0, -1 }, 30.0f });
  EXPECT_TRUE(cone.MayTouch({ 0, 0, -10.9f }, 1));
  EXPECT_FALSE(cone.MayTouch({ 0, 0, -11.1f }, 1)); // beyond
  EXPECT_TRUE(cone.MayTouch({ 0, 0, 0.9f }, 1));
  EXPECT_FALSE(cone.MayTouch({ 0, 0, 1.1f }, 1)); // behind
  const glm::vec3 rim(5 * std::sin(glm::radians(30.0f)), 0, -5 * std::cos(glm::radians(30.0f)));
  const glm::vec3 outwards(std::cos(glm::radians(30.0f)), 0, std::sin(glm::radians(30.0f)));
  EXPECT_TRUE(cone.MayTouch(rim + 0.99f * outwards, 1));
  EXPECT_FALSE(cone.MayTouch(rim + 1.01f * outwards, 1)); // beside
  EXPECT_NEAR(cone.SupportAlong({ 1, 0, 0 }), 5.0f, 1e-3);
  EXPECT_NEAR(cone.SupportAlong({ 0, 0, -1 }), 10.0f, 1e-3);
  EXPECT_EQ(cone.SupportAlong({ 0, 0, 1 }), 0.0f);
  EXPECT_NEAR(cone.Enclosing().Radius, 10 / std::sqrt(3.0), 1e-3);
}

TEST(LightVolume, NarrowConesFarOffKeepTheirWidth)
{
  // A tenth of a degree, a kilometre away: the distance from the axis is what squares would lose.
  const LightShape cone({ { 0, 0, 0 }, 2000.0f, { 0.6f, 0, -0.8f }, 0.1f });
  const glm::vec3 onAxis(600, 0, -800);
  EXPECT_TRUE(cone.MayTouch(onAxis, 0.0f));
  EXPECT_TRUE(cone.MayTouch(onAxis + glm::vec3(0, 1.74f, 0), 0.01f));
  EXPECT_FALSE(cone.MayTouch(onAxis + glm::vec3(0, 4.0f, 0), 0.5f));
}

TEST(LightVolume, PartsOfABallLieInTheirBall)
{
  BallPart part{ { 0, 0, 0 }, 5, 25 };
  EXPECT_TRUE(part.CutBy({ 1, 0, 0, 2 })); // x >= -2: the centre lies within
  EXPECT_EQ(part.Radius, 5);
  EXPECT_TRUE(part.CutBy({ 1, 0, 0, -3 })); // x >= 3
  EXPECT_EQ(part.Centre, glm::vec3(3, 0, 0));
  EXPECT_EQ(part.Radius, 4);
  EXPECT_FALSE(part.CutBy({ 0, 1, 0, -4.1f }));
}
