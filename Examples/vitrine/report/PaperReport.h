/**
 * The results of `paper` for people and for programs.
 */
#ifndef VITRINE_PAPER_REPORT_H
#define VITRINE_PAPER_REPORT_H

#include "commands/PaperTables.h"
#include "faces/FaceOrders.h"

#include <optional>
#include <string>
#include <vector>

namespace program
{

/** What `paper` measured: tables, the order of faces, or both. */
struct PaperResults
{
  Device GL;
  std::vector<PaperResult> Tables;
  std::optional<FaceOrderComparison> Faces;
};

/** The tables, each with a line for every number of layers and method, and that of the order of faces. */
std::string ToText(const PaperResults& results);

/**
 * JSON as that of `compare` if there are tables; each row has also "fps", "mpixel_s" (the window's pixels, a million a
 * second), "share_of_blend" and "paper_share", null where there is none. "faces" has the rows of FaceOrderReport.
 */
std::string ToJson(const PaperResults& results);

}
#endif
