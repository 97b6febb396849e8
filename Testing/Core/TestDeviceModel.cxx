// Tests each constant of the device model against the float operations that it stands for. None may be too small, or so
// large that it stands for something else.
#include "OccluderScenes.h"

#include "Core/culling/screen/DeviceModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using coverage::Random;

constexpr unsigned Seed = 24;
constexpr int Tries = 200000;

/** The largest of many errors, as a share of what a constant allows. */
class Worst
{
public:
  void Add(double error, double allowed)
  {
    this->Share = std::max(this->Share, std::abs(error) / allowed);
  }

  /** Expects it to be allowed, and no less than `least`: then the constant is not many times as large as it need be. */
  void ExpectWithin(double least) const
  {
    EXPECT_LE(this->Share, 1.0);
    EXPECT_GE(this->Share, least);
  }

private:
  double Share = 0.0;
};

/** A row of a matrix and a point, in doubles. */
struct Product
{
  std::array<double, 4> Row;
  std::array<double, 3> Point;

  explicit Product(Random& random)
  {
    for (double& element : this->Row)
    {
      element = random.Between(-1.0, 1.0);
    }
    for (double& coordinate : this->Point)
    {
      coordinate = random.Between(-1.0, 1.0);
    }
  }

  double Exact() const
  {
    return this->Row[0] * this->Point[0] + this->Row[1] * this->Point[1] +
      this->Row[2] * this->Point[2] + this->Row[3];
  }

  double SumOfSizes() const
  {
    double sum = std::abs(this->Row[3]);
    for (int i = 0; i < 3; ++i)
    {
      sum += std::abs(this->Row[i] * this->Point[i]);
    }
    return sum;
  }

  float InFloats() const
  {
    const auto term = [this](int i)
    { return static_cast<float>(this->Row[i]) * static_cast<float>(this->Point[i]); };
    return term(0) + term(1) + term(2) + static_cast<float>(this->Row[3]);
  }
};

}

TEST(DeviceModel, OneOperationRoundsByHalfAUnitInTheLastPlace)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    const auto a = static_cast<float>(random.Between(0.5, 1.0));
    const auto b = static_cast<float>(random.Between(0.5, 1.0));
    const double exact = double{ a } * b;
    worst.Add(a * b - exact, vitrine::RoundingOfFloat * exact);
  }
  worst.ExpectWithin(0.9);
}

TEST(DeviceModel, ProductsOfAMatrixAndAPointRoundByTheirSums)
{
  Random random(Seed);
  Worst ofDevice, ofBoth;
  for (int i = 0; i < Tries; ++i)
  {
    const Product product(random);
    const double error = product.InFloats() - product.Exact();
    ofDevice.Add(error, vitrine::ShareOfDevice * vitrine::RoundingOfSums * product.SumOfSizes());
    ofBoth.Add(2.0 * error,
      vitrine::RoundingOfSums * product.SumOfSizes()); // the culler's in the other direction
  }
  ofDevice.ExpectWithin(0.3);
  ofBoth.ExpectWithin(0.3);
}

TEST(DeviceModel, ProductsOfMatricesInDoublesRoundByLess)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    // One element of a product of three: from the model to the world, to the view, to clip coordinates.
    double inDoubles = 0.0, sum = 0.0;
    long double exact = 0.0L;
    for (int j = 0; j < 4; ++j)
    {
      const Product first(random), second(random);
      const double element = first.Row[0] * second.Row[0] + first.Row[1] * second.Row[1] +
        first.Row[2] * second.Row[2] + first.Row[3] * second.Row[3];
      long double exactElement = 0.0L;
      double sizes = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        exactElement += static_cast<long double>(first.Row[k]) * second.Row[k];
        sizes += std::abs(first.Row[k] * second.Row[k]);
      }
      const double factor = random.Between(-1.0, 1.0);
      inDoubles += element * factor;
      exact += exactElement * factor;
      sum += sizes * std::abs(factor);
    }
    worst.Add(static_cast<double>(inDoubles - exact),
      vitrine::RoundingOfDoubles * vitrine::RoundingOfSums * sum);
  }
  worst.ExpectWithin(0.01);
}

TEST(DeviceModel, QuotientsRoundOnTheirWayToTheWindow)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    const auto x = static_cast<float>(random.Between(-1.0, 1.0));
    const auto w = static_cast<float>(random.Between(1.0, 4.0));
    const auto half = static_cast<float>(random.Between(100.0, 1000.0));
    const float place = x / w * half + half;
    const double fromMiddle = double{ x } / w * half;
    const double ofPlace = vitrine::RoundingOfFloat * 2.0 * half; // what is rounded of the sum
    worst.Add(std::max(std::abs(place - (fromMiddle + half)) - ofPlace, 0.0),
      vitrine::RoundingOfQuotients * std::abs(fromMiddle));
  }
  worst.ExpectWithin(0.1);
}

TEST(DeviceModel, PlacesWhereEdgesAreCutRoundByFourCuts)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    // One coordinate, from -1 to 1 across the view, of what four planes leave of an edge, one after the other.
    auto place = static_cast<float>(random.Between(-1.0, 1.0));
    double exact = place;
    for (int plane = 0; plane < 4; ++plane)
    {
      const auto end = static_cast<float>(random.Between(-1.0, 1.0));
      const auto inside = static_cast<float>(random.Between(0.1, 1.0));
      const auto outside = static_cast<float>(random.Between(-1.0, -0.1));
      const float share = inside / (inside - outside);
      place = place + share * (end - place);
      exact = exact + inside / (double{ inside } - outside) * (end - exact);
    }
    const float half = 240.0f;
    worst.Add((place * half + half) - (exact * half + half), vitrine::RoundingOfCuts * 2.0 * half);
  }
  worst.ExpectWithin(0.1);
}

// Each corner is at least so many times as far from where the face is cut as it may be off.
TEST(DeviceModel, SharesOfEdgesThatEndAwayFromTheCutAreKnown)
{
  double least = 1.0, greatest = 1.0, mostOff = 0.0;
  for (double inside = vitrine::LeastAway; inside < 100.0 * vitrine::LeastAway; inside *= 1.1)
  {
    for (double outside = vitrine::LeastAway; outside < 100.0 * vitrine::LeastAway; outside *= 1.1)
    {
      const double share = inside / (inside + outside);
      for (const double a : { -1.0, 1.0 })
      {
        for (const double b : { -1.0, 1.0 })
        {
          const double drawn = (inside + a) / (inside + a + outside + b);
          mostOff = std::max(mostOff, std::abs(drawn / share - 1.0));
          least = std::min(least, drawn / share);
          greatest = std::max(greatest, drawn / share);
        }
      }
    }
  }
  EXPECT_LE(mostOff, 1.0 / 6.0);
  EXPECT_GE(mostOff, 0.1);
  EXPECT_GE(least * least, vitrine::LeastOfShares);
}

// The root of 2 of what a point is off along each axis is how far it moves.
TEST(DeviceModel, FacesAndLinesAreSteeperByWhatTheirCornersMove)
{
  const double moved = 2.0 * std::sqrt(2.0); // at both ends, or on both sides
  const double ofFaces = vitrine::ThinOfRounding / (vitrine::ThinOfRounding - moved);
  EXPECT_GT(vitrine::SteeperOnDevice, ofFaces);
  EXPECT_LT(vitrine::SteeperOnDevice, 1.5 * ofFaces);
  const double ofLines = vitrine::ShortestByMargin / (vitrine::ShortestByMargin - moved);
  EXPECT_GT(vitrine::SteeperByMargin, ofLines);
  EXPECT_LT(vitrine::SteeperByMargin, 1.5 * ofLines);
}

TEST(DeviceModel, SnappingToTheNearestMovesByHalfAStep)
{
  Random random(Seed);
  Worst worst;
  const double steps = std::ldexp(1.0, vitrine::MostSubpixelBits);
  for (int i = 0; i < Tries; ++i)
  {
    const auto place = static_cast<float>(random.Between(0.0, 4096.0));
    const double snapped = std::nearbyint(place * steps) / steps;
    worst.Add(snapped - place, vitrine::SnappedSteps / steps);
  }
  worst.ExpectWithin(0.75);
}

TEST(DeviceModel, ProductsOfSidesRoundByTheirSums)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    std::array<double, 4> exact;
    std::array<float, 4> sides;
    for (int j = 0; j < 4; ++j)
    {
      const auto from = static_cast<float>(random.Between(0.0, 500.0));
      const auto to = static_cast<float>(random.Between(0.0, 500.0));
      exact[j] = double{ to } - from;
      sides[j] = to - from;
    }
    const double first = exact[0] * exact[3], second = exact[1] * exact[2];
    const float inFloats = sides[0] * sides[3] - sides[1] * sides[2];
    worst.Add(inFloats - (first - second),
      vitrine::RoundingOfFloats * (std::abs(first) + std::abs(second)));
  }
  worst.ExpectWithin(0.2);
}

TEST(DeviceModel, DistancesFromPlanesRoundByHowFarTheEyeIs)
{
  Random random(Seed);
  Worst worst;
  for (int i = 0; i < Tries; ++i)
  {
    const glm::dvec3 eye = random.Point(-10.0, 10.0); // from the middle of a mesh of radius 1
    const glm::dvec3 normal = glm::normalize(random.Point(-1.0, 1.0) + 1e-3);
    const double plane = random.Between(-1.0, 1.0);
    const auto term = [](double a, double b)
    { return static_cast<float>(a) * static_cast<float>(b); };
    const float inFloats = term(eye.x, normal.x) + term(eye.y, normal.y) + term(eye.z, normal.z) -
      static_cast<float>(plane);
    worst.Add(inFloats - (glm::dot(eye, normal) - plane),
      vitrine::RoundingOfDistances * (glm::length(eye) + 1.0));
  }
  worst.ExpectWithin(0.2);
}
