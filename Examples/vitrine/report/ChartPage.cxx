#include "report/ChartPage.h"

#include "chart/ChartMeasures.h"
#include "chart/ChartPageTexts.h"
#include "chart/MethodFamily.h"
#include "report/PagePicture.h"

#include <stdexcept>
#include <vector>

namespace program
{

namespace
{
/** The pictures that the rows of a list name, by path: their URIs, and how much those are shrunk that are. */
void AddPictures(const ChartRecord& record, const std::string& list, Json& uris, Json& shrunk)
{
  for (const Json& row : record.Rows(list))
  {
    for (const char* key : { "picture", "truth_picture" })
    {
      const std::string path = row.value(key, "");
      if (path.empty() || uris.contains(path))
      {
        continue;
      }
      const PagePicture picture = ReadPagePicture(record.PathOf(path));
      uris[path] = picture.Uri;
      if (picture.Shrink > 1)
      {
        shrunk[path] = picture.Shrink;
      }
    }
  }
}

Json FamiliesJson()
{
  Json families = Json::object();
  for (const MethodFamily& family : MethodFamilies())
  {
    char color[8];
    std::snprintf(
      color, sizeof(color), "#%02x%02x%02x", family.Color[0], family.Color[1], family.Color[2]);
    families[family.Name] = { { "color", color }, { "marker", family.Marker } };
  }
  return families;
}

Json MeasuresJson(const std::vector<ChartMeasure>& measures)
{
  Json list = Json::array();
  for (const ChartMeasure& measure : measures)
  {
    list.push_back({ { "name", measure.Name }, { "title", measure.Title },
      { "logarithmic", measure.IsLogarithmic } });
  }
  return list;
}

Json PageData(const ChartRecord& record)
{
  Json pictures = Json::object();
  Json shrunk = Json::object();
  AddPictures(record, "results", pictures, shrunk);
  AddPictures(record, "failures", pictures, shrunk);
  return { { "chart", record.Document() }, { "families", FamiliesJson() },
    { "costs", MeasuresJson(CostMeasures()) }, { "errors", MeasuresJson(ErrorMeasures()) },
    { "pictures", pictures }, { "shrunk", shrunk } };
}

/** JSON that may stand in a script element: nothing in it can end the element. */
std::string ScriptJson(const Json& data)
{
  const std::string json =
    data.dump(-1, ' ', /* ensure_ascii= */ false, Json::error_handler_t::replace);
  std::string text;
  text.reserve(json.size());
  for (const char character : json)
  {
    character == '<' ? text += "\\u003c" : text += character;
  }
  return text;
}

/** Put `content` in the place of the one `mark` in `page`. */
void Replace(std::string& page, const std::string& mark, const std::string& content)
{
  const std::size_t place = page.find(mark);
  if (place == std::string::npos)
  {
    throw std::logic_error("the chart's page has no mark " + mark);
  }
  page.replace(place, mark.size(), content);
}
}

std::string MakeChartPage(const ChartRecord& record)
{
  std::string script;
  for (const char* part :
    { chart_page::elements, chart_page::axes, chart_page::plots, chart_page::pictures,
      chart_page::scenes, chart_page::growth, chart_page::failures, chart_page::page })
  {
    script += part;
  }
  std::string page = chart_page::index;
  Replace(page, "/* style */", chart_page::style);
  Replace(page, "/* script */", script);
  Replace(page, "/* data */", ScriptJson(PageData(record)));
  return page;
}

}
