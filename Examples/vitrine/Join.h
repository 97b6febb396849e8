/**
 * Words as one text.
 */
#ifndef VITRINE_JOIN_H
#define VITRINE_JOIN_H

#include <string>

namespace program
{

/** The text of each item, as `toText` gives it, with `separator` between them. */
template <typename Items, typename ToText>
std::string Join(const Items& items, const ToText& toText, const char* separator = ", ")
{
  std::string joined;
  for (const auto& item : items)
  {
    joined += (joined.empty() ? "" : separator) + std::string(toText(item));
  }
  return joined;
}

/** Texts with `separator` between them. */
template <typename Items>
std::string Join(const Items& items, const char* separator = ", ")
{
  return Join(
    items, [](const std::string& text) { return text; }, separator);
}

}
#endif
