/**
 * Texts in texts.
 */
#ifndef VITRINE_CONTAINS_H
#define VITRINE_CONTAINS_H

#include <string>

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

#endif
