/**
 * Tables for a terminal.
 */
#ifndef VITRINE_TEXT_TABLE_H
#define VITRINE_TEXT_TABLE_H

#include <string>
#include <vector>

namespace program
{

using TextRow = std::vector<std::string>;

/** A number as text, by a format of printf's. */
std::string FormatCell(const char* format, double value);

/**
 * Lines of columns right-aligned but for the first. The first row tells how many columns there are; what a
 * shorter row has behind its first cell is left as it is.
 */
std::string AlignColumns(const std::vector<TextRow>& rows);

}
#endif
