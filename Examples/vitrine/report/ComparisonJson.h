/**
 * What commands that compare methods write for programs, as DESIGN.md fixes it.
 */
#ifndef VITRINE_COMPARISON_JSON_H
#define VITRINE_COMPARISON_JSON_H

#include "commands/Comparison.h"

#include <nlohmann/json.hpp>

#include <string>

namespace program
{

using Json = nlohmann::ordered_json;

template <typename T>
Json OrNull(const std::optional<T>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

/** One method's row; {"scene", "method", "width", "height", "skipped"} if it could not run. */
Json ToJsonRow(const ComparisonResult& comparison, const MethodResult& result);

/** {"vitrine", "device", "settings", "results": rows}; device and settings are those of `comparison`. */
std::string ToJsonDocument(const ComparisonResult& comparison, const Json& rows);

}
#endif
