/**
 * demo:hall: a colonnaded hall of two storeys under a coffered vault, for many lights. The hall is the same for any
 * number of lights, and about as bright.
 */
#include "scene/DemoScene.h"
#include "scene/hall/HallLights.h"
#include "scene/hall/HallSite.h"

namespace program
{

Scene MakeHallScene(const DemoValues& values)
{
  HallSite site;
  AddShell(site);
  AddArcades(site);
  AddVault(site);
  AddFurnishings(site);
  Scene scene;
  scene.Parts = std::move(site.Parts);
  scene.Lights = MakeHallLights(
    static_cast<std::size_t>(values.at("lights")), static_cast<std::uint64_t>(values.at("seed")));
  // The camera goes round a place that is near by, so that it stays within.
  const double eye = HallPlan::HalfLength - 2.0;
  scene.Placement.Camera = { { 0.8, 4.4, eye }, { 0.5, 4.6, eye - 5.0 } };
  scene.Placement.DefaultView.Zoom = 0.5;
  return scene;
}

}
