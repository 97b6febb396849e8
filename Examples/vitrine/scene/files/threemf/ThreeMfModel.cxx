#include "scene/files/threemf/ThreeMfModel.h"

#include "Errors.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <functional>
#include <locale>
#include <sstream>
#include <string_view>

namespace program
{

namespace
{
const std::map<std::string_view, double> MetersOfUnits = { { "micron", 1e-6 },
  { "millimeter", 1e-3 }, { "centimeter", 1e-2 }, { "inch", 0.0254 }, { "foot", 0.3048 },
  { "meter", 1.0 } };

// Elements that are not shown, and what is said of them.
const std::map<std::string_view, const char*> Unshown = {
  { "beamlattice", "beam lattices are not shown" },
  { "displacementmesh", "displaced meshes are not shown" },
  { "slicestack", "slices are not shown" },
  { "texture2dgroup", "textures are not shown" },
  { "compositematerials", "mixtures of materials are not shown" },
  { "multiproperties", "mixtures of materials are not shown" },
};

// Pieces of the names of extensions that a model may require. Of some only that they are not shown is known.
const std::vector<std::string_view> KnownExtensions = { "/production/", "/material/",
  "/beamlattice/", "/slice/", "/trianglesets/" };

/** Attributes of an element. Prefixes of namespaces do not count. */
class Attributes
{
public:
  Attributes(const std::string& place, const char** pairs)
    : Place(place)
    , Pairs(pairs)
  {
  }

  /** The text of an attribute, or null. */
  const char* Find(std::string_view name) const
  {
    for (const char** pair = this->Pairs; pair && *pair; pair += 2)
    {
      const std::string_view full = pair[0];
      if (full == name || full.substr(std::min(full.find(':') + 1, full.size())) == name)
      {
        return pair[1];
      }
    }
    return nullptr;
  }

  std::string Text(std::string_view name) const
  {
    const char* const text = this->Find(name);
    return text ? text : "";
  }

  template <class T>
  T Number(std::string_view name) const
  {
    const std::string_view text = this->Find(name) ? this->Find(name) : "";
    const std::string_view digits = text.substr(!text.empty() && text.front() == '+' ? 1 : 0);
    T value{};
    const auto [last, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || last != digits.data() + digits.size() ||
      !std::isfinite(static_cast<double>(value)))
    {
      this->Fail("'" + std::string(text) + "' for " + std::string(name) + " is no finite number");
    }
    return value;
  }

  template <class T>
  T NumberOr(std::string_view name, T otherwise) const
  {
    return this->Find(name) ? this->Number<T>(name) : otherwise;
  }

  [[noreturn]] void Fail(const std::string& problem) const
  {
    throw InputError(this->Place, "cannot be read: " + problem);
  }

private:
  const std::string& Place;
  const char** Pairs;
};

/** "#RRGGBB" or "#RRGGBBAA". */
std::array<std::uint8_t, 4> ParseColor(const Attributes& attributes, std::string_view name)
{
  const std::string text = attributes.Text(name);
  std::array<std::uint8_t, 4> color = { 0, 0, 0, 255 };
  bool isColor = (text.size() == 7 || text.size() == 9) && text.front() == '#';
  for (std::size_t i = 0; isColor && 2 * i + 1 < text.size(); ++i)
  {
    const char* const digits = text.data() + 2 * i + 1;
    const auto [last, error] = std::from_chars(digits, digits + 2, color[i], 16);
    isColor = error == std::errc() && last == digits + 2;
  }
  if (!isColor)
  {
    attributes.Fail("'" + text + "' is no colour #RRGGBB or #RRGGBBAA");
  }
  return color;
}

ThreeMfTransform ParseTransform(const Attributes& attributes)
{
  ThreeMfTransform transform = ThreeMfUse().Transform;
  const std::string text = attributes.Text("transform");
  if (text.empty())
  {
    return transform;
  }
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::string beyond;
  const bool isWhole =
    std::all_of(transform.begin(), transform.end(),
      [&words](double& value) { return (words >> value) && std::isfinite(value); }) &&
    !(words >> beyond);
  if (!isWhole)
  {
    attributes.Fail("'" + text + "' is no transform of 12 finite numbers");
  }
  return transform;
}

ThreeMfUse ParseUse(const Attributes& attributes)
{
  ThreeMfUse use;
  use.Model = attributes.Text("path");
  use.Object = attributes.Number<int>("objectid");
  use.Transform = ParseTransform(attributes);
  use.Name = attributes.Text("partnumber");
  return use;
}

/** Builds a model of the elements that go by. */
class ModelBuilder
{
public:
  explicit ModelBuilder(const std::string& place)
    : Place(place)
  {
  }

  void Begin(std::string_view element, const Attributes& attributes)
  {
    if (element == "vertex")
    {
      this->ObjectAt(attributes)
        .Vertices.push_back({ attributes.Number<float>("x"), attributes.Number<float>("y"),
          attributes.Number<float>("z") });
    }
    else if (element == "triangle")
    {
      this->AddTriangle(attributes);
    }
    else if (element == "base" || element == "color")
    {
      this->AddColor(element, attributes);
    }
    else if (element == "basematerials" || element == "colorgroup")
    {
      this->Group = &this->Model.Groups[attributes.Number<int>("id")];
    }
    else if (element == "object")
    {
      this->AddObject(attributes);
    }
    else if (element == "component")
    {
      this->ObjectAt(attributes).Components.push_back(ParseUse(attributes));
    }
    else if (element == "item")
    {
      this->Model.Items.push_back(ParseUse(attributes));
    }
    else if (element == "model")
    {
      this->SetUnit(attributes);
      this->CheckExtensions(attributes);
    }
    else if (const auto found = Unshown.find(element); found != Unshown.end())
    {
      this->Model.Notes.insert(found->second);
    }
  }

  void End(std::string_view element)
  {
    if (element == "object" && this->Object)
    {
      this->CheckTriangles();
      this->Object = nullptr;
    }
    else if (element == "basematerials" || element == "colorgroup")
    {
      this->Group = nullptr;
    }
    else if (element == "model")
    {
      this->IsWhole = true;
    }
  }

  /** Throws InputError unless the document was a model. */
  ThreeMfModel Finish()
  {
    if (!this->IsWhole)
    {
      throw InputError(this->Place, "is damaged: it is no model");
    }
    return std::move(this->Model);
  }

private:
  ThreeMfObject& ObjectAt(const Attributes& attributes) const
  {
    if (!this->Object)
    {
      attributes.Fail("a piece of an object stands outside of objects");
    }
    return *this->Object;
  }

  void SetUnit(const Attributes& attributes)
  {
    const std::string unit = attributes.Text("unit");
    const auto found = MetersOfUnits.find(unit.empty() ? "millimeter" : unit);
    if (found == MetersOfUnits.end())
    {
      attributes.Fail("'" + unit + "' is no unit");
    }
    this->Model.MetersPerUnit = found->second;
    this->Model.LengthUnit = found->first;
  }

  /** A model may say that it must not be shown without what an extension means. */
  static void CheckExtensions(const Attributes& attributes)
  {
    std::istringstream prefixes(attributes.Text("requiredextensions"));
    for (std::string prefix; prefixes >> prefix;)
    {
      const std::string extension = attributes.Text("xmlns:" + prefix);
      const bool isKnown = std::any_of(KnownExtensions.begin(), KnownExtensions.end(),
        [&extension](std::string_view known)
        { return extension.find(known) != std::string::npos; });
      if (!isKnown)
      {
        attributes.Fail("it requires the extension '" + extension + "', which is not known");
      }
    }
  }

  void AddObject(const Attributes& attributes)
  {
    const int id = attributes.Number<int>("id");
    const auto [added, isNew] = this->Model.Objects.try_emplace(id);
    if (!isNew)
    {
      attributes.Fail("it has two objects " + std::to_string(id));
    }
    this->Object = &added->second;
    this->Object->Name = attributes.Text("name");
    this->Object->Group = attributes.NumberOr("pid", NoGroup);
    this->Object->Color = attributes.NumberOr("pindex", 0);
  }

  void AddTriangle(const Attributes& attributes)
  {
    ThreeMfTriangle triangle;
    const std::array<std::string_view, 3> corners = { "v1", "v2", "v3" };
    for (std::size_t i = 0; i < 3; ++i)
    {
      triangle.Corners[i] = attributes.Number<std::uint32_t>(corners[i]);
    }
    if (attributes.Find("p1"))
    {
      triangle.Group = attributes.NumberOr("pid", this->ObjectAt(attributes).Group);
      triangle.Colors.fill(attributes.Number<int>("p1"));
      triangle.Colors[1] = attributes.NumberOr("p2", triangle.Colors[0]);
      triangle.Colors[2] = attributes.NumberOr("p3", triangle.Colors[0]);
    }
    this->ObjectAt(attributes).Triangles.push_back(triangle);
  }

  void AddColor(std::string_view element, const Attributes& attributes)
  {
    if (!this->Group)
    {
      return; // of another extension
    }
    const bool isBase = element == "base";
    this->Group->push_back({ isBase ? attributes.Text("name") : std::string(),
      ParseColor(attributes, isBase ? "displaycolor" : "color") });
  }

  void CheckTriangles() const
  {
    const std::size_t vertices = this->Object->Vertices.size();
    for (const ThreeMfTriangle& triangle : this->Object->Triangles)
    {
      if (*std::max_element(triangle.Corners.begin(), triangle.Corners.end()) >= vertices)
      {
        throw InputError(this->Place,
          "is damaged: a triangle has a corner that is not among the " + std::to_string(vertices) +
            " vertices of its object");
      }
    }
  }

  const std::string& Place;
  ThreeMfModel Model;
  ThreeMfObject* Object = nullptr;            ///< the one that is being read
  std::vector<ThreeMfColor>* Group = nullptr; ///< the one that is being read
  bool IsWhole = false;
};

using OnBegin = std::function<void(std::string_view, const Attributes&)>;
using OnEnd = std::function<void(std::string_view)>;

/** Calls functions at elements. Prefixes of namespaces do not count. */
class ElementParser : public vtkXMLParser
{
public:
  static ElementParser* New();
  vtkTypeMacro(ElementParser, vtkXMLParser);

  std::string Place;
  OnBegin Begin;
  OnEnd End;
  std::exception_ptr
    Problem; ///< what a function has thrown, which must not go through expat; null if nothing was

protected:
  static std::string_view LocalName(std::string_view name)
  {
    return name.substr(std::min(name.find(':') + 1, name.size()));
  }

  void StartElement(const char* name, const char** attributes) override
  {
    this->Call([&] { this->Begin(LocalName(name), Attributes(this->Place, attributes)); });
  }

  void EndElement(const char* name) override
  {
    this->Call([&] { this->End(LocalName(name)); });
  }

private:
  template <class Function>
  void Call(const Function& function)
  {
    try
    {
      if (!this->Problem)
      {
        function();
      }
    }
    catch (...)
    {
      this->Problem = std::current_exception();
    }
  }
};
vtkStandardNewMacro(ElementParser);

/** Parses a document of the archive. Documents with types of their own, which can be made to grow, are refused. */
void ParseDocument(const std::string& path, ZipArchive& archive, const std::string& name,
  const OnBegin& begin, const OnEnd& end)
{
  vtkNew<ElementParser> parser;
  parser->Place = path + ": '" + name + "'";
  parser->Begin = begin;
  parser->End = end;
  parser->InitializeParser();
  bool isWhole = true;
  archive.Read(name,
    [&](std::string_view piece)
    {
      isWhole = isWhole && piece.find("<!DOCTYPE") == std::string_view::npos &&
        parser->ParseChunk(piece.data(), static_cast<unsigned int>(piece.size()));
      if (parser->Problem)
      {
        std::rethrow_exception(parser->Problem);
      }
    });
  if (!parser->CleanupParser() || !isWhole)
  {
    throw InputError(path, "is damaged: '" + name + "' is no XML document, or is not whole");
  }
}
}

ThreeMfModel ReadThreeMfModel(const std::string& path, ZipArchive& archive, const std::string& name)
{
  const std::string place = path + ": '" + name + "'";
  ModelBuilder builder(place);
  ParseDocument(
    path, archive, name,
    [&builder](std::string_view element, const Attributes& attributes)
    { builder.Begin(element, attributes); },
    [&builder](std::string_view element) { builder.End(element); });
  return builder.Finish();
}

std::string FindThreeMfModel(const std::string& path, ZipArchive& archive)
{
  const std::string relationships = "_rels/.rels";
  std::string model;
  ParseDocument(
    path, archive, relationships,
    [&model](std::string_view element, const Attributes& attributes)
    {
      const std::string type = attributes.Text("Type");
      const std::string_view wanted = "/3dmodel";
      const bool isModel = type.size() >= wanted.size() &&
        type.compare(type.size() - wanted.size(), wanted.size(), wanted) == 0;
      if (element == "Relationship" && isModel && model.empty())
      {
        model = attributes.Text("Target");
      }
    },
    [](std::string_view) {});
  if (model.empty())
  {
    throw InputError(path, "holds no model: '" + relationships + "' tells none");
  }
  return model;
}

}
