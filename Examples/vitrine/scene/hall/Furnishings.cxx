/**
 * Balustrades of the galleries, lanterns over the nave, sconces at the walls, and curtains.
 */
#include "scene/hall/HallSite.h"

#include <cmath>

namespace program
{

namespace
{
using Plan = HallPlan;

const int BalustersPerBay = 5;
const double RailHeight = 1.0;

Mesh Baluster()
{
  return Turned({ { 0.09, 0.08 }, { 0.09, 0.14 }, { 0.04, 0.18 }, { 0.085, 0.34 }, { 0.075, 0.44 },
                  { 0.04, 0.62 }, { 0.06, 0.78 }, { 0.04, 0.82 }, { 0.08, 0.88 } },
    10);
}

Mesh BalustersOfBay()
{
  std::vector<Mesh> balusters;
  const double length = Plan::BayLength - 2.0 * Plan::UpperColumnRadius - 0.4;
  for (int i = 0; i < BalustersPerBay; ++i)
  {
    balusters.push_back(Transformed(
      Baluster(), Shift(0.0, 0.0, ((i + 0.5) / BalustersPerBay - 0.5) * length) * Upright()));
  }
  return Joined(balusters);
}

Mesh RailsOfBay()
{
  const double length = Plan::BayLength - 2.0 * Plan::UpperColumnRadius;
  return Joined({ Transformed(Box(0.24, 0.08, length), Shift(0.0, 0.04, 0.0)),
    Transformed(Box(0.22, 0.12, length), Shift(0.0, RailHeight - 0.06, 0.0)) });
}

void AddBalustrade(HallSite& site, double x, int bay)
{
  const glm::dmat4 place = Shift(x, Plan::GalleryFloor, Plan::BayMiddle(bay));
  site.Add("balusters", HallMaterial::MARBLE, place, BalustersOfBay);
  site.Add("rails", HallMaterial::LIMESTONE, place, RailsOfBay);
}

Mesh LanternFrame()
{
  std::vector<Mesh> pieces = { Rod({ { 0.0, 0.5, 0.0 }, { 0.0, 6.0, 0.0 } }, 0.02, 8) };
  for (const double height : { -0.4, 0.4 })
  {
    pieces.push_back(Transformed(
      TurnedRing({ { 0.26, -0.03 }, { 0.30, -0.03 }, { 0.30, 0.03 }, { 0.26, 0.03 } }, 24),
      Shift(0.0, height, 0.0) * Upright()));
  }
  for (int i = 0; i < 6; ++i)
  {
    const Point out = OnCircle(0.28, Pi * i / 3.0);
    pieces.push_back(
      Rod({ { out.x, -0.4, out.y }, { out.x, 0.4, out.y }, { 0.0, 0.7, 0.0 } }, 0.015, 6));
  }
  return Joined(pieces);
}

void AddLantern(HallSite& site, int bay)
{
  const glm::dmat4 place = Shift(0.0, Plan::Springing - 2.5, Plan::BayMiddle(bay));
  site.Add("lantern-frame", HallMaterial::BRONZE, place, LanternFrame);
  site.Add("lantern-glass", HallMaterial::CLEAR_GLASS, place,
    [] { return Transformed(Prism(Circle(0.25, 24), -0.38, 0.38), Upright()); });
  site.Add("lantern-bulb", HallMaterial::LAMP, place, [] { return Ball(0.12, 20); });
}

void AddSconce(HallSite& site, const glm::dmat4& side, int post)
{
  const glm::dmat4 place =
    Shift(0.0, 2.6, Plan::BayBegin(post)) * side * Shift(Plan::HalfWidth - 0.25, 0.0, 0.0);
  site.Add("sconce", HallMaterial::BRONZE, place,
    []
    {
      return Joined(
        { Rod(
            Bent({ { 0.25, -0.2, 0.0 }, { 0.0, -0.2, 0.0 }, { 0.0, 0.0, 0.0 } }, 0.1, 6), 0.02, 8),
          Transformed(Turned({ { 0.05, -0.04 }, { 0.12, 0.0 }, { 0.13, 0.04 } }, 20), Upright()) });
    });
  site.Add("sconce-bulb", HallMaterial::LAMP, place,
    [] { return Transformed(Ball(0.09, 16), Shift(0.0, 0.12, 0.0)); });
}

/** Cloth in folds, in the plane x = 0, that hangs from y = 0 and is gathered to one side. */
Mesh Curtain()
{
  const int folds = 32;
  const int rows = 6;
  const double height = 3.2;
  std::vector<Loop> loops;
  for (int row = 0; row <= rows; ++row)
  {
    const double down = static_cast<double>(row) / rows;
    const double width = 1.3 - 0.7 * std::sin(Pi * down * 0.8);
    Loop front;
    for (int i = 0; i <= folds; ++i)
    {
      const double across = static_cast<double>(i) / folds;
      front.push_back(
        { 0.08 * std::sin(2.0 * Pi * 8.0 * across + 0.6 * down), -height * down, width * across });
    }
    Loop loop = front;
    for (auto point = front.rbegin(); point != front.rend(); ++point)
    {
      loop.push_back(*point + Point(0.01, 0.0, 0.0));
    }
    loops.push_back(loop);
  }
  return Loft(loops, Ends::OPEN);
}

/** A pair between two columns. */
void AddCurtains(HallSite& site, double x, int bay)
{
  const double jamb = 0.5 * Plan::BayLength - Plan::ColumnRadius;
  const glm::dmat4 rod = Shift(x, Plan::ColumnHeight - 0.6, Plan::BayMiddle(bay));
  site.Add("curtain-rod", HallMaterial::BRONZE, rod,
    [&] {
      return Rod({ { 0.0, 0.0, -jamb }, { 0.0, 0.0, jamb } }, 0.03, 10);
    });
  site.Add("curtain", HallMaterial::CURTAIN, rod * Shift(0.0, 0.0, -jamb), Curtain);
  site.Add("curtain", HallMaterial::CURTAIN, rod * TurnY(Pi) * Shift(0.0, 0.0, -jamb), Curtain);
}
}

void AddFurnishings(HallSite& site)
{
  for (int bay = 0; bay < Plan::Bays; ++bay)
  {
    AddLantern(site, bay);
    for (const double x : { -Plan::NaveHalfWidth, Plan::NaveHalfWidth })
    {
      AddBalustrade(site, x, bay);
      if (bay % 4 == 1)
      {
        AddCurtains(site, x, bay);
      }
    }
  }
  for (int post = 1; post < Plan::Bays; ++post)
  {
    AddSconce(site, TurnY(0.0), post);
    AddSconce(site, TurnY(Pi), post);
  }
}

}
