/**
 * The keys of `vitrine view`. docs/reference/keys.md lists them, too.
 */
#ifndef VITRINE_VIEW_KEYS_H
#define VITRINE_VIEW_KEYS_H

#include <string>

namespace program
{

class Inspector;

/** Do what a key stands for. A name is a character, that of a key of X11, or "Ctrl+" and a letter. False for others. */
bool PressKey(const std::string& key, Inspector& inspector);

/** A line for each key. */
std::string DescribeKeys();

}
#endif
