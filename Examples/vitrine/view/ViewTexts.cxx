#include "view/ViewTexts.h"

#include "report/TextTable.h"

#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace program
{

namespace
{
const double Edge = 0.012; // of the window's size, from its sides
const std::size_t MostLayers = 16;
const std::size_t LongestPath = 48; // characters, as those of texts that follow
const std::size_t LongestLine = 100;

/** A text without its middle if it is too long. The end of a path tells more than its beginning. */
std::string Shortened(const std::string& text, std::size_t longest)
{
  if (text.size() <= longest)
  {
    return text;
  }
  const auto isWithinCharacter = [&text](std::size_t i) { return (text[i] & 0xc0) == 0x80; };
  std::size_t begin = longest / 4;
  std::size_t end = text.size() - (longest - begin - 3);
  while (begin > 0 && isWithinCharacter(begin))
  {
    --begin;
  }
  while (end < text.size() && isWithinCharacter(end))
  {
    ++end;
  }
  return text.substr(0, begin) + "..." + text.substr(end);
}

void SetLook(vtkTextActor* text, int size, bool isTable)
{
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(Edge, isTable ? 1.0 - Edge : Edge);
  vtkTextProperty* const look = text->GetTextProperty();
  look->SetColor(0.1, 0.1, 0.1);
  look->SetBackgroundColor(1.0, 1.0, 1.0);
  look->SetBackgroundOpacity(0.75);
  look->SetFontSize(size);
  if (isTable)
  {
    look->SetFontFamilyToCourier();
    look->SetVerticalJustificationToTop();
  }
}

std::string ToText(const std::vector<PartUnderCursor>& layers, const ShownParts& parts,
  const std::set<std::size_t>& selected)
{
  std::vector<TextRow> rows{ { "  layers from the front", "share", "opacity" } };
  for (std::size_t i = 0; i < std::min(layers.size(), MostLayers); ++i)
  {
    const PartUnderCursor& layer = layers[i];
    const std::string path = Shortened(parts.Path(layer.Part), LongestPath);
    rows.push_back({ (selected.count(layer.Part) > 0 ? "> " : "  ") + path,
      FormatCell("%.3f", layer.Share), FormatCell("%.2f", layer.Opacity) });
  }
  std::string text = AlignColumns(rows);
  if (layers.size() > MostLayers)
  {
    text += "  and " + std::to_string(layers.size() - MostLayers) + " more\n";
  }
  text.pop_back(); // the last end of a line
  return text;
}
}

ViewTexts::ViewTexts(vtkRenderer* renderer)
  : Renderer(renderer)
{
  SetLook(this->Line, 15, false);
  SetLook(this->Layers, 13, true);
  SetLook(this->Keys, 13, true);
  this->Layers->VisibilityOff();
  this->Keys->VisibilityOff();
  this->SetVisible(true);
}

void ViewTexts::SetLine(const std::string& line)
{
  this->Line->SetInput(Shortened(line, LongestLine).c_str());
}

void ViewTexts::SetLayers(const std::vector<PartUnderCursor>& layers, const ShownParts& parts,
  const std::set<std::size_t>& selected)
{
  this->Layers->SetVisibility(!layers.empty() && !this->HasKeys());
  if (!layers.empty())
  {
    this->Layers->SetInput(ToText(layers, parts, selected).c_str());
  }
}

void ViewTexts::SetKeys(const std::string& keys)
{
  this->Keys->SetInput(keys.c_str());
  this->Keys->SetVisibility(!keys.empty());
}

void ViewTexts::SetVisible(bool isVisible)
{
  for (vtkTextActor* const text : { this->Line.Get(), this->Layers.Get(), this->Keys.Get() })
  {
    this->Renderer->RemoveActor2D(text);
    if (isVisible)
    {
      this->Renderer->AddActor2D(text);
    }
  }
}

}
