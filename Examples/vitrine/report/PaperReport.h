/**
 * The results of `paper` for people and for programs.
 */
#ifndef VITRINE_PAPER_REPORT_H
#define VITRINE_PAPER_REPORT_H

#include "commands/PaperTables.h"

#include <string>
#include <vector>

namespace program
{

/** The tables, each with a line for every number of layers and method. */
std::string ToText(const std::vector<PaperResult>& results);

/**
 * JSON as that of `compare`; each row has also "fps", "mpixel_s" (the window's pixels, a million a second),
 * "share_of_blend" and "paper_share", null where there is none.
 */
std::string ToJson(const std::vector<PaperResult>& results);

}
#endif
