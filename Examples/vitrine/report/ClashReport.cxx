#include "report/ClashReport.h"

#include "report/Json.h"
#include "report/TextTable.h"

#include <algorithm>
#include <sstream>

namespace program
{

namespace
{
std::size_t Count(const ClashTable& table, const std::string& kind)
{
  return static_cast<std::size_t>(std::count_if(table.Clashes.begin(), table.Clashes.end(),
    [&](const PartClash& clash) { return clash.Kind == kind; }));
}

std::string PairsText(const ClashTable& table, const std::string& kind)
{
  const std::size_t count = Count(table, kind);
  return std::to_string(count) + (count == 1 ? " pair" : " pairs");
}

std::string PositionText(const std::array<double, 3>& position)
{
  return FormatCell("%.5g", position[0]) + "," + FormatCell("%.5g", position[1]) + "," +
    FormatCell("%.5g", position[2]);
}
}

std::string ToText(const ClashTable& table, bool listsTouching)
{
  std::ostringstream text;
  text << table.Scene << "\n"
       << "  parts        " << table.Parts << ", " << table.OpenParts << " of them not closed\n"
       << "  tolerance    " << table.Tolerance << "\n"
       << "  clearance    " << table.Clearance << "\n"
       << "  interfering  " << PairsText(table, "interfering") << "\n"
       << "  touching     " << PairsText(table, "touching") << "\n"
       << "  near         " << PairsText(table, "near") << "\n";
  std::vector<TextRow> rows{ { "parts", "kind", "depth", "distance", "at" } };
  for (const PartClash& clash : table.Clashes)
  {
    if (clash.Kind == "touching" && !listsTouching)
    {
      continue;
    }
    const bool isDeep = clash.Kind == "interfering";
    rows.push_back({ clash.Names[0] + " - " + clash.Names[1],
      clash.Inside.empty() ? clash.Kind : "inside", isDeep ? FormatCell("%.4g", clash.Depth) : "-",
      FormatCell("%.4g", clash.Distance), PositionText(clash.Position) });
  }
  if (rows.size() > 1)
  {
    text << "\n" << AlignColumns(rows);
  }
  return text.str();
}

std::string ToJson(const ClashTable& table)
{
  Json pairs = Json::array();
  for (const PartClash& clash : table.Clashes)
  {
    pairs.push_back(
      { { "parts", clash.Parts }, { "closed", clash.IsClosed }, { "kind", clash.Kind },
        { "depth", clash.Kind == "interfering" ? Json(clash.Depth) : Json(nullptr) },
        { "distance", clash.Distance }, { "position", clash.Position },
        { "inside", clash.Inside.empty() ? Json(nullptr) : Json(clash.Inside) } });
  }
  return JsonText(
    { { "scene", table.Scene }, { "parts", table.Parts }, { "open_parts", table.OpenParts },
      { "tolerance", table.Tolerance }, { "clearance", table.Clearance },
      { "interfering", Count(table, "interfering") }, { "touching", Count(table, "touching") },
      { "near", Count(table, "near") }, { "pairs", pairs } });
}

}
