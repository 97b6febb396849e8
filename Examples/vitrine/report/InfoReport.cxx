#include "report/InfoReport.h"

#include "report/Json.h"

#include <iomanip>
#include <sstream>

namespace program
{

namespace
{
void AppendBounds(std::ostream& text, const std::array<double, 6>& bounds)
{
  const char* const axes = "xyz";
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis == 0 ? "" : ", ") << axes[axis] << " " << bounds[2 * axis] << " to "
         << bounds[2 * axis + 1];
  }
}

void AppendLayers(std::ostream& text, const SceneInfo& info)
{
  if (!info.WhyNoLayers.empty())
  {
    text << "unknown: " << info.WhyNoLayers;
    return;
  }
  text << *info.Layers.Fragments << " fragments, at most " << *info.Layers.LayersMax
       << " in a pixel, " << *info.Layers.LayersMean << " on average where there are any, at "
       << info.Size.Width << "x" << info.Size.Height;
}

Json LayersJson(const SceneInfo& info)
{
  if (!info.WhyNoLayers.empty())
  {
    return { { "skipped", info.WhyNoLayers } };
  }
  return { { "width", info.Size.Width }, { "height", info.Size.Height },
    { "fragments", *info.Layers.Fragments }, { "layers_max", *info.Layers.LayersMax },
    { "layers_mean", *info.Layers.LayersMean } };
}

void AppendArrays(std::ostream& text, const std::vector<DataArray>& arrays)
{
  for (const DataArray& array : arrays)
  {
    text << "  array       " << array.Name << ", at " << (array.IsAtCells ? "cells" : "points");
    if (array.Components > 1)
    {
      text << ", magnitude of " << array.Components << " components";
    }
    if (array.Range)
    {
      text << ", " << (*array.Range)[0] << " to " << (*array.Range)[1];
    }
    text << ", of " << array.Parts << (array.Parts == 1 ? " part\n" : " parts\n");
  }
}

Json ArraysJson(const std::vector<DataArray>& arrays)
{
  Json rows = Json::array();
  for (const DataArray& array : arrays)
  {
    rows.push_back({ { "name", array.Name }, { "at", array.IsAtCells ? "cells" : "points" },
      { "components", array.Components }, { "parts", array.Parts },
      { "range", array.Range ? Json(*array.Range) : Json() } });
  }
  return rows;
}
}

std::string ToText(const SceneInfo& info)
{
  std::ostringstream text;
  text << std::setprecision(9);
  text << info.Name << "\n";
  text << "  parts       " << info.Parts << ", of which " << info.TranslucentParts
       << " are translucent\n";
  text << "  triangles   " << info.Triangles << "\n";
  if (info.Lines > 0)
  {
    text << "  lines       " << info.Lines << "\n";
  }
  if (info.Points > 0)
  {
    text << "  points      " << info.Points << "\n";
  }
  if (info.Lights > 0)
  {
    text << "  lights      " << info.Lights << "\n";
  }
  text << "  materials   " << info.Materials << "\n";
  text << "  bounds      ";
  AppendBounds(text, info.Bounds);
  if (!info.LengthUnit.empty())
  {
    text << "\n  unit        metre here; in the file: " << info.LengthUnit;
  }
  text << "\n  layers      ";
  AppendLayers(text, info);
  text << "\n";
  if (!info.Expectation.empty())
  {
    text << "  expected    " << info.Expectation << "\n";
  }
  AppendArrays(text, info.Arrays);
  for (const SkippedPart& part : info.Skipped)
  {
    text << "  skipped     " << part.Name << ": " << part.Reason << "\n";
  }
  for (const std::string& note : info.Notes)
  {
    text << "  note        " << note << "\n";
  }
  if (info.Tree)
  {
    text << PartsText(*info.Tree);
  }
  return text.str();
}

std::string ToJson(const SceneInfo& info)
{
  Json skipped = Json::array();
  for (const SkippedPart& part : info.Skipped)
  {
    skipped.push_back({ { "part", part.Name }, { "reason", part.Reason } });
  }
  Json document = { { "scene", info.Name }, { "parts", info.Parts },
    { "translucent_parts", info.TranslucentParts }, { "triangles", info.Triangles },
    { "lines", info.Lines }, { "points", info.Points }, { "lights", info.Lights },
    { "materials", info.Materials }, { "bounds", info.Bounds }, { "length_unit", info.LengthUnit },
    { "layers", LayersJson(info) }, { "expected", info.Expectation },
    { "arrays", ArraysJson(info.Arrays) }, { "skipped", skipped }, { "notes", info.Notes } };
  if (info.Tree)
  {
    document["part_list"] = PartsJson(*info.Tree);
  }
  return JsonText(document);
}

}
