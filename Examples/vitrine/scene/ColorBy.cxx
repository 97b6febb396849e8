#include "scene/ColorBy.h"

#include "Errors.h"
#include "Join.h"
#include "assembly/ColorTextures.h"
#include "scene/ColorMaps.h"
#include "scene/DataArrays.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace program
{

namespace
{
const char* const Option = "--color-by";

/** What a text asks for. */
struct Coloring
{
  std::string Array; ///< NAME or NAME:N
  std::optional<std::array<double, 2>> Range;
  std::string Map;
};

/** What is shown of an array. */
struct Quantity
{
  std::string Name;
  std::optional<int> Component;
};

template <typename T>
bool ParseNumber(const std::string& text, T& value)
{
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && last == end;
}

/** "MIN:MAX", or nothing if the text is no two numbers. */
std::optional<std::array<double, 2>> ParseRange(const std::string& text)
{
  const std::size_t colon = text.find(':');
  std::array<double, 2> range{};
  if (colon == std::string::npos || !ParseNumber(text.substr(0, colon), range[0]) ||
    !ParseNumber(text.substr(colon + 1), range[1]))
  {
    return std::nullopt;
  }
  if (!(range[0] < range[1]) || !std::isfinite(range[0]) || !std::isfinite(range[1]))
  {
    throw InputError(Option, "'" + text + "' is no range MIN:MAX, with MIN below MAX");
  }
  return range;
}

bool IsMap(const std::string& name)
{
  const std::vector<std::string> names = ColorMapNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** Range and map are taken from the end, since names of arrays may have commas. */
Coloring ParseColoring(const std::string& text)
{
  Coloring coloring{ text, std::nullopt, "" };
  for (std::size_t comma = text.rfind(','); comma != std::string::npos;
       comma = coloring.Array.rfind(','))
  {
    const std::string last = coloring.Array.substr(comma + 1);
    if (coloring.Map.empty() && IsMap(last))
    {
      coloring.Map = last;
    }
    else if (const auto range = coloring.Range ? std::nullopt : ParseRange(last))
    {
      coloring.Range = range;
    }
    else
    {
      break;
    }
    coloring.Array.resize(comma);
  }
  if (coloring.Map.empty())
  {
    coloring.Map = "viridis";
  }
  return coloring;
}

const DataArray* FindArray(const std::vector<DataArray>& arrays, const std::string& name)
{
  const auto found = std::find_if(
    arrays.begin(), arrays.end(), [&name](const DataArray& array) { return array.Name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

/** The array of that name, or the component of it. */
Quantity FindQuantity(const std::string& text, const std::vector<DataArray>& arrays)
{
  if (FindArray(arrays, text))
  {
    return { text, std::nullopt };
  }
  const std::size_t colon = text.rfind(':');
  int component = -1;
  if (colon != std::string::npos && ParseNumber(text.substr(colon + 1), component))
  {
    const std::string name = text.substr(0, colon);
    const DataArray* const array = FindArray(arrays, name);
    if (array && component >= 0 && component < array->Components)
    {
      return { name, component };
    }
    if (array)
    {
      throw InputError(Option,
        "array '" + name + "' has no component " + std::to_string(component) + "; it has " +
          std::to_string(array->Components) + ", numbered from 0");
    }
  }
  const std::size_t comma = text.rfind(',');
  if (comma != std::string::npos && FindArray(arrays, text.substr(0, text.find(','))))
  {
    throw InputError(Option,
      "'" + text.substr(comma + 1) + "' is neither a range MIN:MAX nor one of the maps " +
        Join(ColorMapNames(), [](const std::string& name) { return name; }));
  }
  throw InputError(Option,
    "no part has an array '" + text + "'; " +
      (arrays.empty() ? "there are no arrays" : "there are: " + NameDataArrays(arrays)));
}

/** Where a part has the array that is shown. */
struct Source
{
  vtkDataArray* Array = nullptr; ///< null if the part has none
  bool IsAtCells = false;
};

Source FindSource(vtkPolyData* geometry, const Quantity& quantity)
{
  for (const bool isAtCells : { false, true })
  {
    vtkDataSetAttributes* const data = isAtCells
      ? static_cast<vtkDataSetAttributes*>(geometry->GetCellData())
      : static_cast<vtkDataSetAttributes*>(geometry->GetPointData());
    vtkDataArray* const array = data->GetArray(quantity.Name.c_str());
    if (array && quantity.Component.value_or(0) < array->GetNumberOfComponents())
    {
      return { array, isAtCells };
    }
  }
  return {};
}

/** The range that colours are spread over: what was asked for, or what there is, which may be one value. */
std::array<double, 2> ChooseRange(
  const Coloring& coloring, const Quantity& quantity, const Scene& scene)
{
  if (coloring.Range)
  {
    return *coloring.Range;
  }
  std::optional<std::array<double, 2>> range;
  for (const Part& part : scene.Parts)
  {
    if (const Source source = FindSource(part.Geometry, quantity); source.Array)
    {
      Widen(range, ValuesOf(source.Array, quantity.Component));
    }
  }
  if (!range)
  {
    throw InputError(Option, "array '" + quantity.Name + "' has no finite number");
  }
  if ((*range)[0] == (*range)[1])
  {
    const double margin = std::max(0.5, 0.001 * std::abs((*range)[0]));
    return { (*range)[0] - margin, (*range)[1] + margin };
  }
  return *range;
}

vtkSmartPointer<vtkUnsignedCharArray> MapValues(
  const std::vector<double>& values, vtkScalarsToColors* map)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), numbers->GetPointer(0));
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("colors");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(numbers->GetNumberOfTuples());
  map->MapScalarsThroughTable(numbers, colors->GetPointer(0), VTK_RGB);
  return colors;
}

/** Geometry in its colours, made once for all parts that share it. */
class ColoredGeometry
{
public:
  ColoredGeometry(const Quantity& quantity, vtkScalarsToColors* map)
    : Shown(quantity)
    , Map(map)
  {
  }

  vtkSmartPointer<vtkPolyData> Of(vtkPolyData* geometry, const Source& source)
  {
    vtkSmartPointer<vtkPolyData>& colored = this->Made[geometry];
    if (!colored)
    {
      const std::vector<double> values = ValuesOf(source.Array, this->Shown.Component);
      this->NotNumbers +=
        std::count_if(values.begin(), values.end(), [](double value) { return std::isnan(value); });
      colored = vtkSmartPointer<vtkPolyData>::New();
      colored->ShallowCopy(geometry);
      colored->GetPointData()->SetActiveScalars(nullptr);
      colored->GetCellData()->SetActiveScalars(nullptr);
      const vtkSmartPointer<vtkUnsignedCharArray> colors = MapValues(values, this->Map);
      if (source.IsAtCells)
      {
        colored->GetCellData()->SetScalars(colors);
      }
      else
      {
        colored->GetPointData()->SetScalars(colors);
      }
    }
    return colored;
  }

  std::ptrdiff_t CountNotNumbers() const { return this->NotNumbers; }

private:
  const Quantity& Shown;
  vtkScalarsToColors* Map;
  std::map<vtkSmartPointer<vtkPolyData>, vtkSmartPointer<vtkPolyData>> Made;
  std::ptrdiff_t NotNumbers = 0;
};

/** Textures would hide the colours. */
void RemoveTextures(Part& part)
{
  part.Texture = nullptr;
  if (vitrine::HasColorTexture(part.Material))
  {
    part.Material = CopyMaterial(part.Material);
    vitrine::RemoveColorTextures(part.Material);
  }
}

/** Colours all parts that can be, and tells of what has none. */
void ColorParts(const Quantity& quantity, vtkScalarsToColors* map, Scene& scene)
{
  ColoredGeometry colored(quantity, map);
  std::size_t left = 0;
  for (Part& part : scene.Parts)
  {
    const Source source = FindSource(part.Geometry, quantity);
    if (!source.Array)
    {
      ++left;
      continue;
    }
    part.Geometry = colored.Of(part.Geometry, source);
    part.MayBeBlock = part.MayBeBlock && !source.IsAtCells; // blocks have colours at points alone
    RemoveTextures(part);
  }
  if (left > 0)
  {
    scene.Notes.push_back(std::to_string(left) + " of " + std::to_string(scene.Parts.size()) +
      " parts have no array '" + quantity.Name + "' and keep their colours");
  }
  if (colored.CountNotNumbers() > 0)
  {
    scene.Notes.push_back(std::to_string(colored.CountNotNumbers()) + " values of array '" +
      quantity.Name + "' are not numbers and are shown in " + NotANumberColorName);
  }
}
}

std::string DescribeColorBy()
{
  return "an array of the data, at points or else cells: NAME, by magnitude of vectors, or NAME:N "
         "for component N "
         "from 0; MIN:MAX is its whole range by default; MAP is one of " +
    Join(ColorMapNames(), [](const std::string& name) { return name; }) + "; not a number is " +
    NotANumberColorName;
}

void ColorPartsBy(const std::string& text, Scene& scene)
{
  const Coloring coloring = ParseColoring(text);
  const Quantity quantity = FindQuantity(coloring.Array, ListDataArrays(scene));
  const std::array<double, 2> range = ChooseRange(coloring, quantity, scene);
  const auto map = MakeColorMap(coloring.Map, range[0], range[1]);
  ColorParts(quantity, map, scene);
  scene.Bar = { coloring.Array, map };
}

void AddScalarBar(const Scene& scene, vtkRenderer* renderer)
{
  if (!scene.Bar.Colors)
  {
    return;
  }
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(scene.Bar.Colors);
  bar->SetTitle(scene.Bar.Title.c_str());
  bar->SetNumberOfLabels(5);
  bar->UnconstrainedFontSizeOn();
  for (vtkTextProperty* const text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetColor(0.1, 0.1, 0.1);
    text->SetFontSize(std::max(10, renderer->GetRenderWindow()->GetSize()[1] / 32));
    text->ItalicOff();
    text->ShadowOff();
    text->BoldOff();
  }
  bar->SetBarRatio(0.25);
  bar->SetHeight(0.6);
  bar->SetPosition(0.86, 0.2);
  bar->SetWidth(0.12);
  renderer->AddActor2D(bar);
}

}
