#include "report/LayersReport.h"

#include "report/Json.h"
#include "report/TextTable.h"

#include <sstream>

namespace program
{

namespace
{
/** What is not covered by any layer. */
double ShareOfBackground(const LayersTable& table)
{
  double rest = 1.0;
  for (const LayerRow& layer : table.Layers)
  {
    rest -= layer.Share;
  }
  return rest > 0.0 ? rest : 0.0;
}
}

std::string ToText(const LayersTable& table)
{
  std::ostringstream text;
  text << table.Scene << "\n"
       << "  pixel       " << table.Pixel[0] << "," << table.Pixel[1] << " of " << table.Size[0]
       << "x" << table.Size[1] << ", from the lower left\n"
       << "  layers      " << table.Layers.size() << "\n"
       << "  background  " << FormatCell("%.4f", ShareOfBackground(table)) << " of the picture\n";
  std::vector<TextRow> rows{ { "part", "share", "opacity", "distance", "face" } };
  for (const LayerRow& layer : table.Layers)
  {
    rows.push_back({ layer.Part, FormatCell("%.4f", layer.Share),
      layer.IsOpaque ? "opaque" : FormatCell("%.4f", layer.Opacity),
      FormatCell("%.6g", layer.Distance), layer.IsFront ? "front" : "back" });
  }
  if (rows.size() > 1)
  {
    text << "\n" << AlignColumns(rows);
  }
  return text.str();
}

std::string ToJson(const LayersTable& table)
{
  Json layers = Json::array();
  for (const LayerRow& layer : table.Layers)
  {
    layers.push_back(
      { { "part", layer.Part }, { "depth", layer.Depth }, { "distance", layer.Distance },
        { "position", layer.Position }, { "color", layer.Color }, { "opacity", layer.Opacity },
        { "share", layer.Share }, { "front", layer.IsFront }, { "opaque", layer.IsOpaque } });
  }
  return JsonText({ { "scene", table.Scene }, { "size", table.Size }, { "pixel", table.Pixel },
    { "background", ShareOfBackground(table) }, { "layers", layers } });
}

}
