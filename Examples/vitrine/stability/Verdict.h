/**
 * What measurements of a cell mean.
 */
#ifndef VITRINE_VERDICT_H
#define VITRINE_VERDICT_H

#include "stability/Stability.h"

namespace program
{

/** Fill in the outcome and the verdict from what was measured. */
void Judge(StabilityCell& cell);

/** The outcome in a word, as in JSON. */
const char* Name(StabilityOutcome outcome);

}
#endif
