/**
 * What the statements on the order of faces save, for people and for programs.
 */
#ifndef VITRINE_FACE_ORDER_REPORT_H
#define VITRINE_FACE_ORDER_REPORT_H

#include "faces/FaceOrders.h"
#include "report/Json.h"

#include <string>

namespace program
{

/** A table with a line for every way to insert the faces of every run. */
std::string ToText(const FaceOrderComparison& comparison);

/**
 * Returns rows of {"faces", "sequence", "count", "width", "height", "statements", "comparisons", "saved", "lookups",
 * "end_checks", "insert_ms"}. If the values after "statements" could not be measured, "skipped" replaces them.
 */
Json ToJsonRows(const FaceOrderComparison& comparison);

}
#endif
