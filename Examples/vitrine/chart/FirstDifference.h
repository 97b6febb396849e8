/**
 * In what two documents of settings differ, for people.
 */
#ifndef VITRINE_FIRST_DIFFERENCE_H
#define VITRINE_FIRST_DIFFERENCE_H

#include "report/Json.h"

#include <string>

namespace program
{

/**
 * The first value that differs: "NAME.KEY.0 was 9 and is 3", where `name` is what the documents are. Long values are cut. Where
 * the size or the time of a file differs, "FILE has changed". Empty if they are alike.
 */
std::string FirstDifference(const std::string& name, const Json& before, const Json& now);

}
#endif
