/**
 * The JSON that commands which compare methods write.
 */
#ifndef VITRINE_COMPARISON_JSON_H
#define VITRINE_COMPARISON_JSON_H

#include "commands/Comparison.h"
#include "report/Json.h"

#include <string>

namespace program
{

/** {"opacity", "view", "orbit", "multisamples"}. */
Json ToJson(const ComparisonSettings& settings);

/** One method's row; {"scene", "method", "width", "height", "skipped"} if it could not run. */
Json ToJsonRow(const ComparisonResult& comparison, const MethodResult& result);

/** {"vitrine", "build", "device", "settings", "results": rows}; device and settings are those of `comparison`. */
std::string ToJsonDocument(const ComparisonResult& comparison, const Json& rows);

}
#endif
