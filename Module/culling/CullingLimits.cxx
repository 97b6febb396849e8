#include "culling/CullingLimits.h"

#include "culling/CullingPolicy.h"
#include "culling/PropPolicy.h"

#include <array>

namespace vitrine
{

namespace
{

/** Returns the head of a table of three columns, under a heading. */
std::string Head(const std::string& heading, const std::string& condition)
{
  return "### " + heading + "\n\n| " + condition + " | effect | why |\n| --- | --- | --- |\n";
}

std::string RowOf(const std::array<std::string, 3>& cells)
{
  return "| " + cells[0] + " | " + cells[1] + " | " + cells[2] + " |\n";
}
}

std::string LimitsAsMarkdown()
{
  std::string text = Head("Of a frame", "where");
  for (const FrameRow& row : FrameRows())
  {
    text += RowOf({ row.Condition, EffectOf(row.Mode), row.Why });
  }
  text += "\n" + Head("Kept besides, if all of the kind would be left out", "where");
  for (const KeepRow& row : KeepRows())
  {
    text += RowOf({ row.Condition, row.Kept + std::string(" is drawn"), row.Why });
  }
  text += "\n" + Head("Of a prop", "where");
  for (const PropRow& row : PropRows())
  {
    text += RowOf({ row.Condition, EffectOf(row.Effect), row.Why });
  }
  return text;
}

}
