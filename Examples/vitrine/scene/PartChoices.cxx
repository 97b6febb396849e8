#include "scene/PartChoices.h"

#include "Core/assembly/Explosion.h"
#include "Core/assembly/PartPattern.h"
#include "Errors.h"
#include "assembly/ColorTextures.h"
#include "vtkAssemblyActors.h"
#include "vtkCellData.h"
#include "vtkColor.h"
#include "vtkNamedColors.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSection.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

namespace program
{

namespace
{
// Faint parts hide little and still tell where they are.
const double FaintOpacity = 0.1;

using Numbers = std::vector<int>;

std::vector<vitrine::PartNames> NamesOf(const Scene& scene)
{
  std::vector<vitrine::PartNames> names;
  for (const Part& part : scene.Parts)
  {
    names.push_back({ PathOf(part), part.MaterialName });
  }
  return names;
}

/** Parts that a pattern chooses, at least one. */
Numbers Choose(const std::string& option, const std::string& glob, const Scene& scene)
{
  const std::vector<vitrine::PartNames> names = NamesOf(scene);
  try
  {
    const vitrine::PartPattern pattern(glob);
    const Numbers chosen = pattern.Choose(names);
    if (chosen.empty())
    {
      throw InputError(option, pattern.DescribeMiss(names));
    }
    return chosen;
  }
  catch (const vitrine::PatternError& error)
  {
    throw InputError(option, error.what());
  }
}

/** Parts that any of the patterns chooses: by part, whether it is chosen. */
std::vector<bool> ChooseAny(
  const std::string& option, const std::vector<std::string>& globs, const Scene& scene)
{
  std::vector<bool> isChosen(scene.Parts.size(), false);
  for (const std::string& glob : globs)
  {
    for (const int part : Choose(option, glob, scene))
    {
      isChosen[static_cast<std::size_t>(part)] = true;
    }
  }
  return isChosen;
}

/** Changes materials of parts. Parts that shared a material before a change share one after it. */
class MaterialChange
{
public:
  template <class Change>
  void Make(Part& part, const Change& change)
  {
    vtkSmartPointer<vtkProperty>& changed = this->Changed[part.Material];
    if (!changed)
    {
      changed = CopyMaterial(part.Material);
      change(changed);
    }
    part.Material = changed;
  }

private:
  std::map<vtkSmartPointer<vtkProperty>, vtkSmartPointer<vtkProperty>> Changed;
};

void SetOpacity(Scene& scene, const Numbers& parts, double opacity)
{
  MaterialChange material;
  for (const int part : parts)
  {
    material.Make(scene.Parts[static_cast<std::size_t>(part)],
      [opacity](vtkProperty* changed) { changed->SetOpacity(opacity); });
  }
}

/** Colours at points and textures would hide the colour of the material. */
void SetColor(Scene& scene, const Numbers& parts, const vtkColor3d& color)
{
  MaterialChange material;
  std::map<vtkPolyData*, vtkSmartPointer<vtkPolyData>> plain;
  for (const int number : parts)
  {
    Part& part = scene.Parts[static_cast<std::size_t>(number)];
    material.Make(part,
      [&color](vtkProperty* changed)
      {
        vtkAssemblyActors::SetShownColor(
          changed, color.GetRed(), color.GetGreen(), color.GetBlue());
        vitrine::RemoveColorTextures(changed);
      });
    part.Texture = nullptr;
    vtkSmartPointer<vtkPolyData>& geometry = plain[part.Geometry];
    if (!geometry)
    {
      geometry = vtkSmartPointer<vtkPolyData>::New();
      geometry->ShallowCopy(part.Geometry);
      geometry->GetPointData()->SetScalars(nullptr);
      geometry->GetCellData()->SetScalars(nullptr);
    }
    part.Geometry = geometry;
  }
}

/** A number from 0 to 1. */
double ParseOpacity(const std::string& text, const std::string& whole)
{
  double opacity = -1.0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, opacity);
  if (error != std::errc() || last != end || !(opacity >= 0.0 && opacity <= 1.0))
  {
    throw InputError(
      "--opacity", "'" + whole + "' is not A or GLOB=A, with A a number from 0 to 1");
  }
  return opacity;
}

vtkColor3d ParseColor(const std::string& text, const std::string& whole)
{
  vtkNew<vtkNamedColors> colors;
  const vtkStdString html(text);
  double rgba[4] = {};
  const bool isNamed = colors->ColorExists(html);
  const bool isNumbers = !text.empty() && (text.front() == '#' || text.compare(0, 4, "rgb(") == 0);
  if (isNamed)
  {
    return colors->GetColor3d(html);
  }
  if (isNumbers)
  {
    const vtkColor4ub bytes = colors->HTMLColorToRGBA(html);
    std::transform(
      bytes.GetData(), bytes.GetData() + 4, rgba, [](unsigned char c) { return c / 255.0; });
  }
  // HTMLColorToRGBA() returns transparent black for what it cannot read.
  if (!isNumbers || rgba[3] == 0.0)
  {
    throw InputError("--color",
      "'" + whole +
        "' is not GLOB=COLOR, with COLOR a name such as 'tomato', #RRGGBB or rgb(R,G,B)");
  }
  return { rgba[0], rgba[1], rgba[2] };
}

/** The vtkSection::HatchType of a name. */
int ParseHatch(const std::string& text, const std::string& whole)
{
  static const std::map<std::string, int> hatches = {
    { "none", vtkSection::NO_HATCH },
    { "lines", vtkSection::LINES },
    { "pairs", vtkSection::PAIRS },
    { "dashes", vtkSection::DASHES },
    { "cross", vtkSection::CROSS },
    { "level", vtkSection::LEVEL },
    { "dots", vtkSection::DOTS },
  };
  const auto found = hatches.find(text);
  if (found == hatches.end())
  {
    throw InputError("--hatch",
      "'" + whole +
        "' is not NAME or GLOB=NAME, with NAME none, lines, pairs, dashes, cross, level or dots");
  }
  return found->second;
}

/** GLOB and value of GLOB=VALUE. Names may have a '=', values have none. */
std::optional<std::pair<std::string, std::string>> SplitAtEqual(const std::string& text)
{
  const std::size_t equal = text.rfind('=');
  if (equal == std::string::npos)
  {
    return std::nullopt;
  }
  return std::make_pair(text.substr(0, equal), text.substr(equal + 1));
}

void ApplyExplode(double factor, Scene& scene)
{
  if (factor == 0.0)
  {
    return;
  }
  const std::vector<std::array<double, 3>> offsets = ExplodedOffsets(scene, factor);
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    scene.Parts[i].Transform = MovedBy(offsets[i], scene.Parts[i].Transform);
  }
}

void ApplyXRay(const PartChoices& choices, Scene& scene)
{
  if (choices.XRayFalloff && choices.XRay.empty())
  {
    throw InputError("--x-ray-falloff", "needs --x-ray");
  }
  const std::vector<bool> isChosen = ChooseAny("--x-ray", choices.XRay, scene);
  scene.XRayFalloff = choices.XRayFalloff.value_or(0.0);
  MaterialChange material;
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    const bool isBehind = !isChosen[i] && !choices.XRay.empty();
    if (isBehind && choices.XRayFalloff)
    {
      scene.Parts[i].IsXRayed = true;
      scene.Parts[i].MayBeBlock = false;
    }
    else if (isBehind)
    {
      material.Make(scene.Parts[i],
        [](vtkProperty* changed) { changed->SetOpacity(FaintOpacity * changed->GetOpacity()); });
    }
  }
}

void ApplyHighlight(const std::vector<std::string>& globs, Scene& scene)
{
  const std::vector<bool> isChosen = ChooseAny("--highlight", globs, scene);
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    if (isChosen[i] && !globs.empty())
    {
      scene.Parts[i].IsOutlined = true;
      scene.Parts[i].MayBeBlock = false;
    }
  }
}

void ApplyHatch(const std::vector<std::string>& texts, Scene& scene)
{
  for (const std::string& text : texts)
  {
    const auto split = SplitAtEqual(text);
    const int hatch = ParseHatch(split ? split->second : text, text);
    if (!split)
    {
      scene.Hatch = hatch;
      continue;
    }
    for (const int part : Choose("--hatch", split->first, scene))
    {
      scene.Parts[static_cast<std::size_t>(part)].Hatch = hatch;
      scene.Parts[static_cast<std::size_t>(part)].MayBeBlock = false;
    }
  }
}

void ApplyKeepWhole(const std::vector<std::string>& globs, Scene& scene)
{
  const std::vector<bool> isChosen = ChooseAny("--keep-whole", globs, scene);
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    scene.Parts[i].IsKeptWhole = isChosen[i];
    scene.Parts[i].MayBeBlock = scene.Parts[i].MayBeBlock && !isChosen[i];
  }
}

void ApplyOpacity(const std::vector<std::string>& texts, Scene& scene)
{
  for (const std::string& text : texts)
  {
    const auto split = SplitAtEqual(text);
    const double opacity = ParseOpacity(split ? split->second : text, text);
    if (split)
    {
      SetOpacity(scene, Choose("--opacity", split->first, scene), opacity);
    }
    else
    {
      MultiplyOpacity(scene, opacity);
    }
  }
}

void ApplyColor(const std::vector<std::string>& texts, Scene& scene)
{
  for (const std::string& text : texts)
  {
    const auto split = SplitAtEqual(text);
    const vtkColor3d color = ParseColor(split ? split->second : std::string(), text);
    SetColor(scene, Choose("--color", split->first, scene), color);
  }
}

void KeepDrawn(const PartChoices& choices, Scene& scene)
{
  const std::vector<bool> isHidden = ChooseAny("--hide", choices.Hide, scene);
  const std::vector<bool> isWanted = ChooseAny("--only", choices.Only, scene);
  std::vector<Part> drawn;
  for (std::size_t i = 0; i < scene.Parts.size(); ++i)
  {
    if (!isHidden[i] && (choices.Only.empty() || isWanted[i]))
    {
      drawn.push_back(std::move(scene.Parts[i]));
    }
  }
  if (drawn.empty())
  {
    throw InputError(choices.Only.empty() ? "--hide" : "--only", "no part is left to draw");
  }
  scene.Parts = std::move(drawn);
}
}

std::vector<std::array<double, 3>> ExplodedOffsets(const Scene& scene, double factor)
{
  std::vector<vitrine::ExplodedPart> parts;
  for (const Part& part : scene.Parts)
  {
    const std::array<double, 6> bounds = PartBounds(part);
    parts.push_back(
      { PathOf(part), { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } });
  }
  std::vector<std::array<double, 3>> offsets;
  for (const glm::dvec3& offset : vitrine::ExplodedOffsets(parts, factor))
  {
    offsets.push_back({ offset.x, offset.y, offset.z });
  }
  return offsets;
}

vtkSmartPointer<vtkMatrix4x4> MovedBy(const std::array<double, 3>& offset, vtkMatrix4x4* place)
{
  auto moved = vtkSmartPointer<vtkMatrix4x4>::New();
  if (place)
  {
    moved->DeepCopy(place);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    moved->SetElement(axis, 3, moved->GetElement(axis, 3) + offset[axis]);
  }
  return moved;
}

void Apply(const PartChoices& choices, Scene& scene)
{
  ApplyExplode(choices.Explode, scene);
  ApplyXRay(choices, scene);
  ApplyHighlight(choices.Highlight, scene);
  ApplyHatch(choices.Hatch, scene);
  ApplyKeepWhole(choices.KeepWhole, scene);
  ApplyOpacity(choices.Opacity, scene);
  ApplyColor(choices.Color, scene);
  KeepDrawn(choices, scene);
}

double CommonOpacity(const PartChoices& choices)
{
  double product = 1.0;
  for (const std::string& text : choices.Opacity)
  {
    product *= SplitAtEqual(text) ? 1.0 : ParseOpacity(text, text);
  }
  return product;
}

}
