#include "report/TextTable.h"

#include <algorithm>
#include <cstdio>

namespace program
{

std::string FormatCell(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string AlignColumns(const std::vector<TextRow>& rows)
{
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TextRow& row : rows)
  {
    for (std::size_t i = 0; row.size() == widths.size() ? i < row.size() : i < 1; ++i)
    {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string lines;
  for (const TextRow& row : rows)
  {
    std::string line = row[0] + std::string(widths[0] - row[0].size(), ' ');
    for (std::size_t i = 1; i < row.size(); ++i)
    {
      const std::size_t padding = row.size() == widths.size() ? widths[i] - row[i].size() : 0;
      line += "  " + std::string(padding, ' ') + row[i];
    }
    lines += line + "\n";
  }
  return lines;
}

}
