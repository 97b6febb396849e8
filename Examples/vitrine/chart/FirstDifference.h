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
 * Returns the first value that differs, as in "NAME.KEY.0 was 9 and is 3". `name` names the documents. Long values are
 * cut. If the size or the time of a file differs, the text is "FILE has changed". It is empty if the documents are
 * alike.
 */
std::string FirstDifference(const std::string& name, const Json& before, const Json& now);

}
#endif
