/**
 * What measurements of a cell mean.
 */
#ifndef VITRINE_VERDICT_H
#define VITRINE_VERDICT_H

#include "stability/Stability.h"

namespace program
{

/**
 * The largest error of an exact method: a step of a display. With several samples a pixel, each is rounded to 8
 * bits and so is their mean, and what the method itself rounds comes on top.
 */
double LargestExactError(int multisamples);

/**
 * The most by which a value of an exact method changes beyond truth's own change there. Rounding to 8 bits adds less
 * than a step; what the method itself rounds may take a quarter of one in either picture.
 */
double LargestExactExcess();

/** True if the frames of that window are off by more than an exact method's. */
bool IsWrong(const OtherWindow& other);

/** Fill in the outcome and the verdict from what was measured. */
void Judge(StabilityCell& cell);

/** The outcome in a word, as in JSON. */
const char* Name(StabilityOutcome outcome);

}
#endif
