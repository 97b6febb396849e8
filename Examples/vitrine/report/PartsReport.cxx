#include "report/PartsReport.h"

#include "report/TextTable.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

namespace program
{

namespace
{
std::vector<std::string> NamesOf(const std::string& path)
{
  std::vector<std::string> names;
  for (std::size_t begin = 1; begin <= path.size();)
  {
    const std::size_t slash = std::min(path.find('/', begin), path.size());
    names.push_back(path.substr(begin, slash - begin));
    begin = slash + 1;
  }
  return names;
}

/** What lies at a path and below. */
struct Below
{
  std::int64_t Parts = 0;
  std::int64_t Triangles = 0;
};

std::map<std::string, Below> CountBelow(const std::vector<PartInfo>& parts)
{
  std::map<std::string, Below> counts;
  for (const PartInfo& part : parts)
  {
    std::string path;
    for (const std::string& name : NamesOf(part.Path))
    {
      path += "/" + name;
      counts[path].Parts += 1;
      counts[path].Triangles += part.Triangles;
    }
  }
  return counts;
}

/** A name by its depth in the tree. */
std::string Indent(const std::string& name, std::size_t depth)
{
  return std::string(4 + 2 * depth, ' ') + name;
}

std::string BoundsText(const std::array<double, 6>& bounds)
{
  std::ostringstream text;
  text << std::setprecision(5);
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis == 0 ? "" : ", ") << bounds[2 * axis] << " to " << bounds[2 * axis + 1];
  }
  return text.str();
}

TextRow RowOf(const PartInfo& part, const std::string& name, std::size_t depth)
{
  return { Indent(name, depth), std::to_string(part.Triangles), FormatCell("%.3g", part.Opacity),
    part.Triangles == 0 ? "-"
      : part.IsClosed   ? "closed"
                        : "open",
    part.Material.empty() ? "-" : part.Material, BoundsText(part.Bounds) };
}

TextRow RowOf(const Below& below, const std::string& name, std::size_t depth)
{
  return { Indent(name, depth),
    std::to_string(below.Parts) + (below.Parts == 1 ? " part, " : " parts, ") +
      std::to_string(below.Triangles) + " triangles" };
}

/** Rows of a part and of those nodes above it that have none yet, whose counts are taken out. */
void AppendRows(
  const PartInfo& part, std::map<std::string, Below>& counts, std::vector<TextRow>& rows)
{
  const std::vector<std::string> names = NamesOf(part.Path);
  std::string path;
  for (std::size_t depth = 0; depth + 1 < names.size(); ++depth)
  {
    path += "/" + names[depth];
    if (const auto found = counts.find(path); found != counts.end())
    {
      rows.push_back(RowOf(found->second, names[depth], depth));
      counts.erase(found);
    }
  }
  counts.erase(part.Path);
  rows.push_back(RowOf(part, names.back(), names.size() - 1));
}
}

std::string PartsText(const std::vector<PartInfo>& parts)
{
  std::map<std::string, Below> counts = CountBelow(parts);
  std::vector<TextRow> rows = { { "  tree", "triangles", "opacity", "surface", "material",
    "bounds of x, y, z" } };
  for (const PartInfo& part : parts)
  {
    AppendRows(part, counts, rows);
  }
  return AlignColumns(rows);
}

Json PartsJson(const std::vector<PartInfo>& parts)
{
  Json rows = Json::array();
  for (const PartInfo& part : parts)
  {
    rows.push_back(
      { { "path", part.Path }, { "material", part.Material }, { "triangles", part.Triangles },
        { "opacity", part.Opacity }, { "translucent", part.IsTranslucent },
        { "closed", part.IsClosed }, { "bounds", part.Bounds } });
  }
  return rows;
}

}
