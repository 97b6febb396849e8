#include "report/QueryReport.h"

#include "report/Json.h"
#include "report/TextTable.h"

#include <sstream>

namespace program
{

namespace
{
std::string PointText(const std::array<double, 3>& point)
{
  return FormatCell("%.7g", point[0]) + "," + FormatCell("%.7g", point[1]) + "," +
    FormatCell("%.7g", point[2]);
}

void Append(std::ostream& text, const RayAnswer& ray)
{
  std::vector<TextRow> rows{ { "  surfaces along the ray", "distance", "at", "" } };
  for (const CrossedSurface& crossing : ray.Crossings)
  {
    rows.push_back({ "    " + crossing.Part, FormatCell("%.7g", crossing.Distance),
      PointText(crossing.Position), crossing.IsEntering ? "in" : "out" });
  }
  text << AlignColumns(rows);
  rows = { { "  walls of closed parts", "from", "to", "thickness", "gap before" } };
  double end = 0.0;
  for (const CrossedWall& wall : ray.Walls)
  {
    rows.push_back({ "    " + wall.Part, FormatCell("%.7g", wall.Start),
      FormatCell("%.7g", wall.End), FormatCell("%.7g", wall.End - wall.Start),
      wall.Start > end ? FormatCell("%.7g", wall.Start - end) : "-" });
    end = std::max(end, wall.End);
  }
  text << AlignColumns(rows);
}

void Append(std::ostream& text, const char* title, const std::vector<std::string>& parts)
{
  text << "  " << title << ": " << parts.size() << (parts.size() == 1 ? " part\n" : " parts\n");
  for (const std::string& part : parts)
  {
    text << "    " << part << "\n";
  }
}

Json RayJson(const RayAnswer& ray)
{
  Json crossings = Json::array();
  for (const CrossedSurface& crossing : ray.Crossings)
  {
    crossings.push_back({ { "part", crossing.Part }, { "distance", crossing.Distance },
      { "position", crossing.Position }, { "entering", crossing.IsEntering } });
  }
  Json walls = Json::array();
  for (const CrossedWall& wall : ray.Walls)
  {
    walls.push_back({ { "part", wall.Part }, { "start", wall.Start }, { "end", wall.End },
      { "thickness", wall.End - wall.Start } });
  }
  return { { "crossings", crossings }, { "walls", walls } };
}
}

std::string ToText(const QueryAnswers& answers)
{
  std::ostringstream text;
  text << answers.Scene << "\n";
  if (answers.Ray)
  {
    Append(text, *answers.Ray);
  }
  if (answers.Nearest)
  {
    text << "  nearest part: " << answers.Nearest->Part << "\n    at "
         << PointText(answers.Nearest->Position) << ", "
         << FormatCell("%.7g", answers.Nearest->Distance) << " away\n";
  }
  if (answers.InBox)
  {
    Append(text, "in the box", *answers.InBox);
  }
  if (answers.InSphere)
  {
    Append(text, "in the sphere", *answers.InSphere);
  }
  if (answers.Distance)
  {
    text << "  distance: " << FormatCell("%.7g", answers.Distance->Distance) << "\n    "
         << answers.Distance->Parts[0] << " at " << PointText(answers.Distance->Positions[0])
         << "\n    " << answers.Distance->Parts[1] << " at "
         << PointText(answers.Distance->Positions[1]) << "\n";
  }
  if (answers.Sight)
  {
    text << "  " << answers.Sight->Parts[0]
         << (answers.Sight->MaySee ? " may see " : " does not see ") << answers.Sight->Parts[1]
         << "\n";
  }
  return text.str();
}

std::string ToJson(const QueryAnswers& answers)
{
  Json document = { { "scene", answers.Scene } };
  if (answers.Ray)
  {
    document["ray"] = RayJson(*answers.Ray);
  }
  if (answers.Nearest)
  {
    document["nearest"] = { { "part", answers.Nearest->Part },
      { "position", answers.Nearest->Position }, { "distance", answers.Nearest->Distance } };
  }
  if (answers.InBox)
  {
    document["box"] = *answers.InBox;
  }
  if (answers.InSphere)
  {
    document["sphere"] = *answers.InSphere;
  }
  if (answers.Distance)
  {
    document["distance"] = { { "parts", answers.Distance->Parts },
      { "distance", answers.Distance->Distance }, { "positions", answers.Distance->Positions } };
  }
  if (answers.Sight)
  {
    document["sees"] = { { "parts", answers.Sight->Parts }, { "may_see", answers.Sight->MaySee } };
  }
  return JsonText(document);
}

}
