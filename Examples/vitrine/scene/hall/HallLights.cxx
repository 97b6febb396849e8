#include "scene/hall/HallLights.h"

#include "scene/Random.h"
#include "scene/assembly/Mesh.h"
#include "scene/assembly/Shapes.h"
#include "scene/hall/HallPlan.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace program
{

namespace
{
using Plan = HallPlan;

// Of one light, how far from what it lights it would be in metres; of N, the square root of N times less.
const double SizeOfOne = 70.0;

enum class Kind
{
  SHELL,  ///< a spot light at the floor, a wall or the vault, behind which there is nothing
  COLUMN, ///< a spot light that shines up or down along a column
  BEAM,   ///< a spot light at a gallery or a beam
  LAMP    ///< a small one that shines all around
};

/** One of eight is of these kinds in turn, until there are as many as these; all others are of the first one. */
const std::array<Kind, 8> FarReaching = { Kind::COLUMN, Kind::LAMP, Kind::BEAM, Kind::COLUMN,
  Kind::LAMP, Kind::BEAM, Kind::COLUMN, Kind::LAMP };

Kind KindOf(std::size_t i)
{
  const bool isFarReaching = i % 8 == 7 && i / 8 < FarReaching.size();
  return isFarReaching ? FarReaching[i / 8] : Kind::SHELL;
}

/** A place on a surface that is to be lit, and where the surface faces. */
struct Spot
{
  Point Place;
  Point Normal;
};

/**
 * Points that fill a square evenly for any number of points, shifted by a seed (R2 of M. Roberts: The unreasonable
 * effectiveness of quasirandom sequences, 2018).
 */
class EvenPoints
{
public:
  explicit EvenPoints(Random& dice)
    : U(dice.Unit())
    , V(dice.Unit())
  {
  }

  std::array<double, 2> Next()
  {
    this->U = Fraction(this->U + 0.7548776662466927);
    this->V = Fraction(this->V + 0.5698402909980532);
    return { this->U, this->V };
  }

private:
  static double Fraction(double value) { return value - std::floor(value); }

  double U;
  double V;
};

/** A straight stretch of the hall's cross-section. */
struct Stretch
{
  Point From;
  Point To;
  Point Normal;

  double Length() const { return glm::length(this->To - this->From); }
};

/** Galleries and beams, as they are on one side of the cross-section; the other is its mirror image. */
std::vector<Stretch> Beams()
{
  const double nave = Plan::NaveHalfWidth;
  const double wall = Plan::HalfWidth;
  const double gallery = Plan::GalleryFloor;
  return {
    { { nave, gallery, 0.0 }, { wall, gallery, 0.0 }, { 0.0, 1.0, 0.0 } },
    { { nave, gallery - Plan::FloorThickness, 0.0 }, { wall, gallery - Plan::FloorThickness, 0.0 },
      { 0.0, -1.0, 0.0 } },
    { { nave, Plan::ColumnHeight, 0.0 }, { nave, gallery, 0.0 }, { -1.0, 0.0, 0.0 } },
    { { nave, Plan::Springing - 1.5, 0.0 }, { nave, Plan::Springing, 0.0 }, { -1.0, 0.0, 0.0 } },
  };
}

/** What the hall ends at, likewise. The vault is three chords. */
std::vector<Stretch> Shell()
{
  const double wall = Plan::HalfWidth;
  const double springing = Plan::Springing;
  std::vector<Stretch> stretches = {
    { { 0.0, 0.0, 0.0 }, { wall, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
    { { wall, 0.0, 0.0 }, { wall, springing, 0.0 }, { -1.0, 0.0, 0.0 } },
  };
  const int chords = 3;
  const auto onVault = [&](int i)
  { return Point(0.0, springing, 0.0) + OnCircle(Plan::VaultRadius, 0.5 * Pi * i / chords); };
  for (int i = 0; i < chords; ++i)
  {
    const Point middle = 0.5 * (onVault(i) + onVault(i + 1)) - Point(0.0, springing, 0.0);
    stretches.push_back({ onVault(i), onVault(i + 1), -glm::normalize(middle) });
  }
  return stretches;
}

/** Deals out places along the hall on stretches of its cross-section. */
class Stretches
{
public:
  Stretches(Random& dice, std::vector<Stretch> all)
    : On(dice)
    , All(std::move(all))
  {
    for (const Stretch& stretch : this->All)
    {
      this->Perimeter += stretch.Length();
    }
  }

  Spot Next()
  {
    const auto [u, v] = this->On.Next();
    double way = std::fmod(2.0 * u, 1.0) * this->Perimeter;
    auto stretch = this->All.begin();
    while (way > stretch->Length() && stretch + 1 != this->All.end())
    {
      way -= stretch->Length();
      ++stretch;
    }
    const double side = u < 0.5 ? -1.0 : 1.0; // mirrored
    const Point place = stretch->From + way * glm::normalize(stretch->To - stretch->From);
    return { { side * place.x, place.y, (2.0 * v - 1.0) * Plan::HalfLength },
      { side * stretch->Normal.x, stretch->Normal.y, 0.0 } };
  }

private:
  EvenPoints On;
  std::vector<Stretch> All;
  double Perimeter = 0.0;
};

/** Deals out places at columns. */
class ColumnShafts
{
public:
  explicit ColumnShafts(Random& dice)
    : Dice(&dice)
    , On(dice)
  {
  }

  /** On the shaft of some column. */
  Spot Next()
  {
    const auto [u, v] = this->On.Next();
    const auto post = static_cast<int>(u * 2.0 * (Plan::Bays + 1));
    const bool isUpper = v >= 0.6;
    const double height = isUpper ? Plan::GalleryFloor + (v - 0.6) / 0.4 * Plan::UpperColumnHeight
                                  : v / 0.6 * Plan::ColumnHeight;
    const double radius = isUpper ? Plan::UpperColumnRadius : Plan::ColumnRadius;
    const Point around = OnCircle(1.0, this->Dice->Between(0.0, 2.0 * Pi));
    const Point normal(around.x, 0.0, around.y);
    const double x = post % 2 ? Plan::NaveHalfWidth : -Plan::NaveHalfWidth;
    return { Point(x, height, Plan::BayBegin(post / 2)) + radius * normal, normal };
  }

private:
  Random* Dice;
  EvenPoints On;
};

std::array<double, 3> ToArray(const Point& point)
{
  return { point.x, point.y, point.z };
}

/** Within the hall. */
Point Inside(const Point& place)
{
  return { std::clamp(place.x, -Plan::HalfWidth + 0.05, Plan::HalfWidth - 0.05),
    std::clamp(place.y, 0.05, Plan::Top - 0.05),
    std::clamp(place.z, -Plan::HalfLength + 0.05, Plan::HalfLength - 0.05) };
}

/** 1 / d^2 but near by: half the intensity at `reach`. */
void SetFalloff(Light& light, double intensity, double reach)
{
  light.Intensity = intensity;
  light.Attenuation = { 1.0, 0.0, 1.0 / (reach * reach) };
}

/** From the yellow of candles to the white of daylight; some LEDs have a hue. */
std::array<double, 3> ColorOf(Random& dice, double hued)
{
  const double warmth = dice.Unit();
  const double hue = dice.Unit() * 2.0 * Pi;
  std::array<double, 3> color = { 1.0, 0.95 - 0.22 * warmth, 0.88 - 0.45 * warmth };
  if (dice.Unit() < hued)
  {
    for (int i = 0; i < 3; ++i)
    {
      color[i] = 0.55 + 0.45 * std::cos(hue + 2.0 * Pi * i / 3.0);
    }
  }
  return color;
}

Light MakeSpot(Random& dice, const Point& position, const Point& direction, double size)
{
  Light light;
  light.Position = ToArray(Inside(position));
  light.Direction = ToArray(direction);
  light.Color = ColorOf(dice, 0.1);
  light.ConeAngle = dice.Between(15.0, 35.0);
  light.Exponent = dice.Between(4.0, 16.0);
  SetFalloff(light, dice.Between(2.0, 4.0), 0.6 * size);
  return light;
}

Light MakeColumnLight(Random& dice, const Spot& spot, double size)
{
  const double up = dice.Unit() < 0.5 ? 1.0 : -1.0;
  const Point direction = glm::normalize(Point(0.0, up, 0.0) - 0.25 * spot.Normal);
  const Point position = spot.Place + 0.35 * size * spot.Normal - 0.6 * size * Point(0.0, up, 0.0);
  return MakeSpot(dice, position, direction, size);
}

Light MakeShellLight(Random& dice, const Spot& spot, double size)
{
  const Point lean(dice.Between(-0.3, 0.3), dice.Between(-0.3, 0.3), dice.Between(-0.3, 0.3));
  const Point direction = glm::normalize(lean - spot.Normal);
  return MakeSpot(dice, spot.Place - size * direction, direction, size);
}

Light MakeLamp(Random& dice, const Spot& spot, double size)
{
  Light light;
  light.Position = ToArray(Inside(spot.Place + dice.Between(0.1, 0.3) * size * spot.Normal));
  light.Color = ColorOf(dice, 0.4);
  SetFalloff(light, dice.Between(0.6, 1.2), 0.15 * size);
  return light;
}
}

std::vector<Light> MakeHallLights(std::size_t count, std::uint64_t seed)
{
  Random dice(seed);
  Stretches shell(dice, Shell());
  Stretches beams(dice, Beams());
  ColumnShafts columns(dice);
  const double size = SizeOfOne / std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
  std::vector<Light> lights;
  lights.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    switch (KindOf(i))
    {
      case Kind::SHELL:
        lights.push_back(MakeShellLight(dice, shell.Next(), size));
        break;
      case Kind::COLUMN:
        lights.push_back(MakeColumnLight(dice, columns.Next(), size));
        break;
      case Kind::BEAM:
        lights.push_back(MakeShellLight(dice, beams.Next(), size));
        break;
      case Kind::LAMP:
        lights.push_back(MakeLamp(dice, shell.Next(), size));
        break;
    }
  }
  return lights;
}

}
