#ifndef VITRINE_STUDY_IMAGE_FLIP_H
#define VITRINE_STUDY_IMAGE_FLIP_H

#include "study/image/Image.h"
#include "study/image/SeparableFilter.h"

namespace vitrine
{

/**
 * Returns the LDR-FLIP error of each pixel: the difference that an observer sees when alternating between two pictures
 * of the same size (Andersson and others, 2020). The range is 0 (none) to 1 (largest). The default observer is 0.7 m
 * from a monitor 0.7 m wide with 3840 pixels, which is 67.02 pixels per degree.
 */
Plane FlipErrorMap(const Image& test, const Image& reference);

}

#endif
