#include "view/Inspector.h"

#include "Errors.h"
#include "OutputPicture.h"
#include "report/TextTable.h"
#include "view/Keys.h"

#include "vtkMath.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace program
{

namespace
{
/** The planes of a scene, for which d of (x, y, z, d) is the distance times the normal's length. */
std::vector<SectionPlane> PlanesOf(const Scene& scene)
{
  std::vector<SectionPlane> planes;
  for (const auto& [x, y, z, distance] : scene.Sections)
  {
    const double share = distance / (x * x + y * y + z * z);
    planes.push_back({ { x, y, z }, { share * x, share * y, share * z } });
  }
  return planes;
}

ViewState FirstState(const Scene& scene, vtkRenderer* renderer, const std::string& method)
{
  ViewState state;
  state.Sections = PlanesOf(scene);
  state.Box = scene.SectionBox;
  state.Method = method;
  state.Camera = CameraState::Of(renderer->GetActiveCamera());
  return state;
}

/** A name for a picture in the current folder that nothing has yet. */
std::string FreeName()
{
  std::string name = "vitrine.png";
  for (int i = 2; std::filesystem::exists(name); ++i)
  {
    name = "vitrine-" + std::to_string(i) + ".png";
  }
  return name;
}
}

Inspector::Inspector(const Scene& scene, vtkRenderer* renderer, std::vector<std::string> methods,
  const Coincidence& tolerance, const AutomaticLimits& limits)
  : Content(scene)
  , Renderer(renderer)
  , Methods(std::move(methods))
  , State(FirstState(scene, renderer, this->Methods.front()))
  , Shown(scene, renderer, tolerance, limits, this->State)
  , Texts(renderer)
  , Layers(renderer)
{
  this->Draw();
  this->Say("? shows the keys");
}

void Inspector::Press(const std::string& key)
{
  try
  {
    PressKey(key, *this);
  }
  catch (const std::runtime_error& error)
  {
    this->Say(error.what());
  }
}

void Inspector::Click(int x, int y, bool deeper, bool add)
{
  try
  {
    const PartUnderCursor* const clicked = this->Layers.Click(x, y, deeper, this->Shown.Parts());
    if (!clicked)
    {
      this->SelectNothing();
      return;
    }
    this->Clicked.push_back(clicked->Position);
    if (this->Clicked.size() > 2)
    {
      this->Clicked.erase(this->Clicked.begin());
    }
    const std::size_t part = clicked->Part;
    std::set<std::size_t> selected = add ? this->State.Selected : std::set<std::size_t>();
    if (add && selected.erase(part) == 0)
    {
      selected.insert(part);
    }
    else if (!add)
    {
      selected = { part };
    }
    this->Change([&selected](ViewState& state) { state.Selected = selected; },
      "selected " + this->Described(selected));
  }
  catch (const std::runtime_error& error)
  {
    this->Say(error.what());
  }
}

void Inspector::BeginStroke()
{
  this->BeforeStroke = this->State;
}

void Inspector::EndStroke()
{
  if (!this->BeforeStroke)
  {
    return;
  }
  this->State.Camera = CameraState::Of(this->Renderer->GetActiveCamera());
  const bool hasPlaneMoved = this->State.Sections != this->BeforeStroke->Sections;
  if (hasPlaneMoved || !(this->State.Camera == this->BeforeStroke->Camera))
  {
    this->Past.Note(*std::move(this->BeforeStroke));
    this->Say(hasPlaneMoved ? "moved the plane" : "moved the camera");
  }
  this->BeforeStroke.reset();
}

void Inspector::TellDistance()
{
  if (this->Clicked.size() < 2)
  {
    throw RuntimeError("click on two places first");
  }
  const double square =
    vtkMath::Distance2BetweenPoints(this->Clicked[0].data(), this->Clicked[1].data());
  const std::string unit = this->Content.LengthUnit.empty() ? "" : " m";
  this->Say("distance " + FormatCell("%.6g", std::sqrt(square)) + unit);
}

void Inspector::NextLights()
{
  const LightPreset next = NextPreset(this->State.Lights);
  this->Change([next](ViewState& state) { state.Lights = next; }, "lights: " + NameOfLights(next));
}

void Inspector::StepMethod(int step)
{
  const auto now = std::find(this->Methods.begin(), this->Methods.end(), this->State.Method);
  const auto count = static_cast<std::ptrdiff_t>(this->Methods.size());
  const auto next = (now - this->Methods.begin() + step + count) % count;
  const std::string name = this->Methods[static_cast<std::size_t>(next)];
  this->Change([&name](ViewState& state) { state.Method = name; }, "method " + name);
}

void Inspector::Undo()
{
  if (!this->Past.Undo(this->State))
  {
    throw RuntimeError("nothing is left to undo");
  }
  this->Shown.Show(this->State);
  this->Say("undone");
}

void Inspector::Redo()
{
  if (!this->Past.Redo(this->State))
  {
    throw RuntimeError("nothing is left to redo");
  }
  this->Shown.Show(this->State);
  this->Say("redone");
}

void Inspector::SelectNothing()
{
  this->Layers.Forget();
  this->Change([](ViewState& state) { state.Selected.clear(); }, "nothing is selected");
}

void Inspector::SavePicture(bool withTexts)
{
  const std::string name = FreeName();
  CheckPicturePath(name);
  this->Texts.SetVisible(withTexts);
  this->Draw();
  vtkRenderWindow* const window = this->Renderer->GetRenderWindow();
  const int* const size = window->GetActualSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, /* front= */ 0, pixels);
  this->Texts.SetVisible(true);
  const std::uint8_t* const begin = pixels->GetPointer(0);
  WritePicture(name, { begin, begin + pixels->GetNumberOfValues() }, { size[0], size[1] });
  this->Say("saved " + name);
}

void Inspector::ToggleKeys()
{
  this->Texts.SetKeys(this->Texts.HasKeys() ? "" : DescribeKeys());
  this->Say(this->Texts.HasKeys() ? "keys" : "no keys");
}

void Inspector::End()
{
  this->Ended = true;
}

// From here on: what gestures are made of.

void Inspector::Change(const std::function<void(ViewState&)>& change, const std::string& said)
{
  ViewState before = this->State;
  change(this->State);
  this->Past.Note(std::move(before));
  this->Shown.Show(this->State);
  this->Say(said);
}

void Inspector::Draw()
{
  this->Texts.SetLayers(this->Layers.Parts(), this->Shown.Parts(), this->State.Selected);
  this->Renderer->GetRenderWindow()->Render();
}

void Inspector::Say(const std::string& text)
{
  const std::string problem = this->Shown.Problem();
  this->Texts.SetLine(
    this->State.Method + (problem.empty() ? "" : " (" + problem + ")") + "   " + text);
  this->Draw();
  std::cout << text << std::endl;
}

const std::set<std::size_t>& Inspector::RequireSelected() const
{
  if (this->State.Selected.empty())
  {
    throw RuntimeError("select a part first: click on it");
  }
  return this->State.Selected;
}

std::set<std::size_t> Inspector::SelectedOrAll() const
{
  std::set<std::size_t> parts = this->State.Selected;
  for (std::size_t part = 0; this->State.Selected.empty() && part < this->Content.Parts.size();
       ++part)
  {
    parts.insert(parts.end(), part);
  }
  return parts;
}

std::string Inspector::Described(const std::set<std::size_t>& parts) const
{
  if (parts.empty())
  {
    return "nothing";
  }
  return parts.size() == 1 ? this->Shown.Parts().Path(*parts.begin())
                           : std::to_string(parts.size()) + " parts";
}

std::array<double, 6> Inspector::VisibleBounds() const
{
  std::array<double, 6> bounds;
  this->Renderer->ComputeVisiblePropBounds(bounds.data());
  return bounds[0] <= bounds[1] ? bounds : SceneBounds(this->Content);
}

}
