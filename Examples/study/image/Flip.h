#ifndef VITRINE_STUDY_IMAGE_FLIP_H
#define VITRINE_STUDY_IMAGE_FLIP_H

#include "study/image/Image.h"
#include "study/image/SeparableFilter.h"

namespace vitrine
{

/**
 * The difference that an observer sees when alternating between two pictures of the same size, pixel
 * by pixel: 0 for none, 1 for the largest. LDR-FLIP of Andersson and others, 2020, for its default
 * observer, 0.7 m from a monitor 0.7 m wide with 3840 pixels: 67.02 pixels per degree.
 */
Plane FlipErrorMap(const Image& test, const Image& reference);

}

#endif
