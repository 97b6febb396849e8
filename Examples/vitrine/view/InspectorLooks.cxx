// The gestures of vitrine view that change how parts look and where they are.
#include "view/Inspector.h"

#include "report/TextTable.h"

#include <algorithm>
#include <iterator>

namespace program
{

namespace
{
const double GlassOpacity = 0.15;
const double LeastOpacity = 0.05;
const double MostExplode = 10.0;
}

void Inspector::Hide()
{
  const std::set<std::size_t> parts = this->RequireSelected();
  this->Change(
    [&parts](ViewState& state)
    {
      for (const std::size_t part : parts)
      {
        state.Looks[part].IsVisible = false;
      }
      state.Selected.clear();
    },
    "hid " + this->Described(parts));
}

void Inspector::ShowAll()
{
  this->Change(
    [](ViewState& state)
    {
      for (auto look = state.Looks.begin(); look != state.Looks.end();)
      {
        look->second.IsVisible = true;
        look = look->second == PartLook() ? state.Looks.erase(look) : std::next(look);
      }
    },
    "all parts are shown");
}

void Inspector::Isolate()
{
  const std::set<std::size_t> parts = this->RequireSelected();
  this->Change(
    [&](ViewState& state)
    {
      for (std::size_t part = 0; part < this->Shown.Parts().Count(); ++part)
      {
        state.Looks[part].IsVisible = parts.count(part) > 0;
      }
    },
    "isolated " + this->Described(parts));
}

void Inspector::MakeGlass()
{
  this->SetLooks(
    this->SelectedOrAll(), [](PartLook& look) { look.Opacity = GlassOpacity; }, "made glass of ");
}

void Inspector::ChangeOpacity(double by)
{
  const std::set<std::size_t> parts = this->SelectedOrAll();
  this->Change(
    [&](ViewState& state)
    {
      for (const std::size_t part : parts)
      {
        std::optional<double>& opacity = state.Looks[part].Opacity;
        const double before = opacity.value_or(this->Shown.Parts().OwnOpacity(part));
        opacity = std::clamp(before + by, LeastOpacity, 1.0);
      }
    },
    std::string(by < 0.0 ? "less" : "more") + " opacity of " + this->Described(parts));
}

void Inspector::ResetLooks()
{
  const std::set<std::size_t> parts = this->SelectedOrAll();
  this->Change(
    [&parts](ViewState& state)
    {
      for (const std::size_t part : parts)
      {
        state.Looks.erase(part);
      }
    },
    "reset " + this->Described(parts));
}

void Inspector::ToggleReveal()
{
  if (this->State.Revealed)
  {
    this->Change([](ViewState& state) { state.Revealed.reset(); }, "nothing is revealed");
    return;
  }
  const std::size_t part = *this->RequireSelected().begin();
  this->Change(
    [part](ViewState& state) { state.Revealed = part; }, "revealed " + this->Described({ part }));
}

void Inspector::ExplodeBy(double factor)
{
  const double exploded = std::clamp(this->State.Explode + factor, 0.0, MostExplode);
  this->Change([exploded](ViewState& state) { state.Explode = exploded; },
    "exploded by " + FormatCell("%g", exploded));
}

void Inspector::SetLooks(const std::set<std::size_t>& parts,
  const std::function<void(PartLook&)>& set, const std::string& said)
{
  this->Change(
    [&](ViewState& state)
    {
      for (const std::size_t part : parts)
      {
        set(state.Looks[part]);
      }
    },
    said + this->Described(parts));
}

}
