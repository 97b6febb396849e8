/**
 * Floors of tiles, walls with windows, and the galleries' slabs.
 */
#include "scene/hall/HallSite.h"

namespace program
{

namespace
{
using Plan = HallPlan;

const double TileSide = 1.0;
const double WindowWidth = 1.8;
const double WindowFoot = 2.0;
const double WindowTop = 5.0;
const double UpperWindowFoot = 8.0;
const double UpperWindowTop = 10.4;
const double WallThickness = 0.5;
const double WallFoot = -0.1; // below the joints of tiles

/** A slab whose upper edges are bevelled, with its top at y = 0. */
Mesh Tile(double width, double length)
{
  const double joint = 0.01;
  const double bevel = 0.015;
  const auto outline = [&](double inset)
  { return Rectangle(width - 2.0 * inset, length - 2.0 * inset); };
  return Transformed(
    Loft({ At(outline(joint), -bevel), At(outline(joint + bevel), 0.0) }, Ends::CAPPED), Upright());
}

/** Every other tile of a bay between two x. */
Mesh TilesOfBay(double left, double right, int turn)
{
  std::vector<Mesh> tiles;
  const int across = static_cast<int>((right - left) / TileSide + 0.5);
  const int along = static_cast<int>(Plan::BayLength / TileSide + 0.5);
  const double width = (right - left) / across;
  for (int i = 0; i < across * along; ++i)
  {
    if ((i / along + i % along) % 2 == turn)
    {
      tiles.push_back(Transformed(Tile(width, TileSide),
        Shift(left + (i / along + 0.5) * width, 0.0,
          (i % along + 0.5) * TileSide - 0.5 * Plan::BayLength)));
    }
  }
  return Joined(tiles);
}

void AddTiles(HallSite& site, int bay)
{
  const glm::dmat4 place = Shift(0.0, 0.0, Plan::BayMiddle(bay));
  const double inner = Plan::NaveHalfWidth;
  const double outer = Plan::HalfWidth;
  const std::array<HallMaterial, 2> materials = { HallMaterial::LIGHT_TILE,
    HallMaterial::DARK_TILE };
  for (int turn = 0; turn < 2; ++turn)
  {
    const std::string kind = turn ? "dark-tiles" : "light-tiles";
    site.Add(
      "nave-" + kind, materials[turn], place, [&] { return TilesOfBay(-inner, inner, turn); });
    site.Add("left-aisle-" + kind, materials[turn], place,
      [&] { return TilesOfBay(-outer, -inner, turn); });
    site.Add("right-aisle-" + kind, materials[turn], place,
      [&] { return TilesOfBay(inner, outer, turn); });
  }
}

/** A box between two heights and two places along z, in the wall's plane x = 0. */
Mesh WallPiece(double foot, double top, double from, double to)
{
  return Transformed(Box(WallThickness, top - foot, to - from),
    Shift(0.5 * WallThickness, 0.5 * (foot + top), 0.5 * (from + to)));
}

/** The wall of a bay around two windows, one above the other. */
Mesh WallOfBay()
{
  const double end = 0.5 * Plan::BayLength;
  const double jamb = 0.5 * WindowWidth;
  return Joined({ WallPiece(WallFoot, Plan::Top, -end, -jamb),
    WallPiece(WallFoot, Plan::Top, jamb, end), WallPiece(WallFoot, WindowFoot, -jamb, jamb),
    WallPiece(WindowTop, UpperWindowFoot, -jamb, jamb),
    WallPiece(UpperWindowTop, Plan::Top, -jamb, jamb) });
}

Mesh WindowFrame(double foot, double top)
{
  return Transformed(HollowPrism(Rectangle(WindowWidth + 0.2, top - foot + 0.2),
                       Rectangle(WindowWidth - 0.1, top - foot - 0.1), -0.08, 0.08),
    Shift(0.0, 0.5 * (foot + top), 0.0) * TurnY(0.5 * Pi));
}

Mesh Pane(double foot, double top)
{
  return Transformed(Box(0.02, top - foot, WindowWidth), Shift(0.25, 0.5 * (foot + top), 0.0));
}

void AddWall(HallSite& site, int bay, const glm::dmat4& side)
{
  const glm::dmat4 place =
    Shift(0.0, 0.0, Plan::BayMiddle(bay)) * side * Shift(Plan::HalfWidth, 0.0, 0.0);
  site.Add("wall", HallMaterial::PLASTER, place, WallOfBay);
  site.Add(
    "window-frame", HallMaterial::BRONZE, place, [] { return WindowFrame(WindowFoot, WindowTop); });
  site.Add("upper-window-frame", HallMaterial::BRONZE, place,
    [] { return WindowFrame(UpperWindowFoot, UpperWindowTop); });
  site.Add("pane", bay % 2 ? HallMaterial::RED_GLASS : HallMaterial::BLUE_GLASS, place,
    [] { return Pane(WindowFoot, WindowTop); });
  site.Add("upper-pane", HallMaterial::CLEAR_GLASS, place,
    [] { return Pane(UpperWindowFoot, UpperWindowTop); });
}

/** What tiles lie on: it shows in the joints. */
void AddBed(HallSite& site, int bay)
{
  site.Add("bed", HallMaterial::DARK_TILE, Shift(0.0, -0.11, Plan::BayMiddle(bay)),
    [] { return Box(2.0 * Plan::HalfWidth, 0.2, Plan::BayLength); });
}

void AddGallery(HallSite& site, int bay, const glm::dmat4& side)
{
  const double width = Plan::HalfWidth - Plan::NaveHalfWidth + Plan::ColumnRadius;
  const glm::dmat4 place = Shift(0.0, 0.0, Plan::BayMiddle(bay)) * side *
    Shift(Plan::HalfWidth - 0.5 * width, Plan::GalleryFloor, 0.0);
  site.Add("gallery-floor", HallMaterial::LIMESTONE, place,
    [&]
    {
      return Transformed(Box(width, Plan::FloorThickness, Plan::BayLength),
        Shift(0.0, -0.5 * Plan::FloorThickness, 0.0));
    });
  site.Add("gallery-ceiling", HallMaterial::PLASTER, place,
    [&]
    {
      return Transformed(
        Box(width, 0.3, Plan::BayLength), Shift(0.0, Plan::UpperHeight + 0.15, 0.0));
    });
}

/** An end of the hall: a wall, and a round window in it. */
void AddEnd(HallSite& site, const glm::dmat4& side)
{
  const double middle = 12.0;
  const glm::dmat4 place = side * Shift(0.0, 0.0, -Plan::HalfLength);
  site.Add("end-wall", HallMaterial::PLASTER, place,
    []
    {
      return Transformed(Box(2.0 * Plan::HalfWidth, Plan::Top - WallFoot, WallThickness),
        Shift(0.0, 0.5 * (Plan::Top + WallFoot), -0.5 * WallThickness));
    });
  site.Add("rose-ring", HallMaterial::GILT, place * Shift(0.0, middle, 0.1),
    []
    {
      return TurnedRing(
        { { 2.2, 0.0 }, { 2.6, 0.0 }, { 2.6, 0.1 }, { 2.5, 0.2 }, { 2.3, 0.2 }, { 2.2, 0.1 } }, 48);
    });
  for (int petal = 0; petal < 12; ++petal)
  {
    site.Add("rose-petal", petal % 2 ? HallMaterial::RED_GLASS : HallMaterial::BLUE_GLASS,
      place * Shift(0.0, middle, 0.1) * TurnZ(Pi * petal / 6.0) * Shift(1.4, 0.0, 0.0),
      [] { return Prism(Circle(0.36, 20), 0.02, 0.06); });
  }
}
}

void AddShell(HallSite& site)
{
  for (int bay = 0; bay < Plan::Bays; ++bay)
  {
    AddBed(site, bay);
    AddTiles(site, bay);
    for (const double turn : { 0.0, Pi })
    {
      AddWall(site, bay, TurnY(turn));
      AddGallery(site, bay, TurnY(turn));
    }
  }
  AddEnd(site, TurnY(0.0));
  AddEnd(site, TurnY(Pi));
}

}
