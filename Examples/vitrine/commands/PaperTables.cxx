#include "commands/PaperTables.h"

namespace program
{

namespace
{
const std::string MaskPrefix = "stencil-mask-";

bool BeginsWith(const std::string& text, const std::string& prefix)
{
  return text.compare(0, prefix.size(), prefix) == 0;
}

bool IsOfThisModule(const std::string& method)
{
  return method != "blend" && method != "truth" && !BeginsWith(method, "vtk-");
}
}

const std::vector<PaperTable>& PaperTables()
{
  static const std::vector<PaperTable> tables = {
    { "masks", "Stencil masks", "demo:paper-masks", { 8, 15 },
      "blend,vtk-oit,stencil-mask-8,stencil-mask-16,linked-list,prefix-sum-predicted-compact",
      { { 8, 0.27 }, { 16, 0.12 } } },
    { "lists", "Linked lists", "demo:paper-lists", { 8, 16, 32, 57 },
      "blend,vtk-oit,linked-list,linked-list-compact,prefix-sum-predicted,prefix-sum-predicted-"
      "compact",
      { { 8, 0.12 }, { 16, 0.10 }, { 32, 0.06 }, { 64, 0.033 } } },
  };
  return tables;
}

std::optional<double> PaperShare(const PaperTable& table, const std::string& method, int layers)
{
  if (!IsOfThisModule(method))
  {
    return std::nullopt;
  }
  const bool isMask = BeginsWith(method, MaskPrefix);
  for (const PaperFigure& figure : table.Own)
  {
    if (isMask ? method == MaskPrefix + std::to_string(figure.Layers) : layers <= figure.Layers)
    {
      return figure.ShareOfBlend;
    }
  }
  return std::nullopt;
}

}
