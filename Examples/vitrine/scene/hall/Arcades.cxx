/**
 * Columns, each of a base, a shaft and a capital, in two storeys; and the arches between them.
 */
#include "scene/hall/HallSite.h"

#include <cmath>

namespace program
{

namespace
{
using Plan = HallPlan;

const int Flutes = 16;
const double ArchThickness = 0.42;

struct Storey
{
  std::string Name;
  double Foot;
  double Radius; ///< of columns
  double Height; ///< of columns
  double Top;    ///< of the wall above the arches
  int Sides;     ///< of what is round
};

const Storey Lower = { "lower", 0.0, Plan::ColumnRadius, Plan::ColumnHeight,
  Plan::GalleryFloor - Plan::FloorThickness, 28 };
const Storey Upper = { "upper", Plan::GalleryFloor, Plan::UpperColumnRadius,
  Plan::UpperColumnHeight, Plan::Springing, 16 };

/** An Attic base (two tori and a hollow) on a square plinth. */
Mesh Base(const Storey& storey)
{
  const double r = storey.Radius;
  const std::vector<Station> profile = { { 1.45 * r, 0.30 * r }, { 1.52 * r, 0.42 * r },
    { 1.42 * r, 0.54 * r }, { 1.28 * r, 0.56 * r }, { 1.20 * r, 0.64 * r }, { 1.22 * r, 0.74 * r },
    { 1.30 * r, 0.78 * r }, { 1.32 * r, 0.86 * r }, { 1.24 * r, 0.94 * r },
    { 1.08 * r, 0.96 * r } };
  return Joined(
    { Prism(Rectangle(3.1 * r, 3.1 * r), 0.0, 0.30 * r), Turned(profile, storey.Sides) });
}

/** What flutes leave of a circle. */
Loop FlutedCircle(double radius)
{
  const int perFlute = 4;
  Loop loop;
  for (int i = 0; i < Flutes * perFlute; ++i)
  {
    const double depth = i % perFlute == 0 ? 0.0 : i % perFlute == 2 ? 0.08 : 0.06;
    loop.push_back(OnCircle(radius * (1.0 - depth), 2.0 * Pi * i / (Flutes * perFlute)));
  }
  return loop;
}

/** Shafts grow narrower upwards, along a curve. */
double Entasis(double share)
{
  return 1.0 - 0.16 * share * share;
}

Mesh Shaft(const Storey& storey, bool isFluted)
{
  const double from = 0.95 * storey.Radius;
  const double to = storey.Height - 1.3 * storey.Radius;
  const int steps = 5;
  std::vector<Loop> loops;
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    const double radius = storey.Radius * Entasis(share);
    loops.push_back(At(
      isFluted ? FlutedCircle(radius) : Circle(radius, storey.Sides), from + share * (to - from)));
  }
  return Loft(loops, Ends::CAPPED);
}

/** From a circle to the square that the arches stand on. */
Mesh Capital(const Storey& storey)
{
  const double r = storey.Radius;
  const double from = storey.Height - 1.3 * r;
  std::vector<Loop> loops = { At(Circle(0.98 * r, storey.Sides), from),
    At(Circle(0.98 * r, storey.Sides), from + 0.08 * r) };
  const int steps = 6;
  const Loop square = Polygon(1.5 * std::sqrt(2.0) * r, 4, storey.Sides / 4);
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    const double bulge = share * share * (1.0 - 0.25 * std::sin(Pi * share));
    Loop loop = Circle(0.84 * r, storey.Sides);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      loop[k] += bulge * (square[k] - loop[k]);
    }
    loops.push_back(At(loop, from + (0.12 + 0.85 * share) * r));
  }
  return Joined({ Loft(loops, Ends::CAPPED),
    Transformed(Prism(Polygon(1.62 * std::sqrt(2.0) * r, 4, 1), 0.0, 0.3 * r),
      Shift(0.0, 0.0, storey.Height - 0.3 * r)) });
}

/** Points of a half circle in the plane x = 0, from one springer to the other. */
Point OnArch(double radius, double share)
{
  return { 0.0, radius * std::sin(Pi * share), -radius * std::cos(Pi * share) };
}

/** The stones of an arch, with a moulding to either side. */
Mesh Archivolt(double radius)
{
  const int steps = 16;
  std::vector<Loop> loops;
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    const auto at = [&](double x, double out)
    { return OnArch(radius + out, share) + Point(x, 0.0, 0.0); };
    const double half = 0.5 * ArchThickness;
    loops.push_back({ at(-half, 0.0), at(-half, 0.10), at(-half - 0.04, 0.14),
      at(-half - 0.06, 0.24), at(-half - 0.02, 0.30), at(half + 0.02, 0.30), at(half + 0.06, 0.24),
      at(half + 0.04, 0.14), at(half, 0.10), at(half, 0.0) });
  }
  return Loft(loops, Ends::CAPPED);
}

/** The wall between an arch and the level top of its storey. */
Mesh Spandrel(double radius, double height)
{
  const int steps = 16;
  const double half = 0.5 * ArchThickness;
  std::vector<Loop> loops;
  for (int i = 0; i <= steps; ++i)
  {
    const Point inner = OnArch(radius + 0.05, static_cast<double>(i) / steps);
    const double z = i == 0 ? -0.5 * Plan::BayLength : i == steps ? 0.5 * Plan::BayLength : inner.z;
    loops.push_back(
      { { -half, inner.y, z }, { -half, height, z }, { half, height, z }, { half, inner.y, z } });
  }
  return Loft(loops, Ends::CAPPED);
}

void AddColumn(HallSite& site, const Storey& storey, bool isFluted, const glm::dmat4& place)
{
  const glm::dmat4 upright = place * Upright();
  site.Add(storey.Name + "-base", HallMaterial::MARBLE, upright, [&] { return Base(storey); });
  site.Add(storey.Name + (isFluted ? "-fluted-shaft" : "-round-shaft"),
    isFluted ? HallMaterial::SANDSTONE : HallMaterial::MARBLE, upright,
    [&] { return Shaft(storey, isFluted); });
  site.Add(storey.Name + "-capital", isFluted ? HallMaterial::LIMESTONE : HallMaterial::GILT,
    upright, [&] { return Capital(storey); });
}

void AddArch(HallSite& site, const Storey& storey, const glm::dmat4& place)
{
  const double radius = 0.5 * Plan::BayLength - storey.Radius;
  const glm::dmat4 springer = place * Shift(0.0, storey.Height, 0.0);
  site.Add(
    storey.Name + "-arch", HallMaterial::LIMESTONE, springer, [&] { return Archivolt(radius); });
  site.Add(storey.Name + "-spandrel", HallMaterial::SANDSTONE, springer,
    [&] { return Spandrel(radius, storey.Top - storey.Foot - storey.Height); });
}
}

void AddArcades(HallSite& site)
{
  for (const Storey& storey : { Lower, Upper })
  {
    for (const double x : { -Plan::NaveHalfWidth, Plan::NaveHalfWidth })
    {
      for (int i = 0; i <= Plan::Bays; ++i)
      {
        AddColumn(site, storey, i % 2 == 0, Shift(x, storey.Foot, Plan::BayBegin(i)));
      }
      for (int bay = 0; bay < Plan::Bays; ++bay)
      {
        AddArch(site, storey, Shift(x, storey.Foot, Plan::BayMiddle(bay)));
      }
    }
  }
}

}
