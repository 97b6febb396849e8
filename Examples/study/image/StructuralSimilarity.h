#ifndef VITRINE_STUDY_IMAGE_STRUCTURAL_SIMILARITY_H
#define VITRINE_STUDY_IMAGE_STRUCTURAL_SIMILARITY_H

#include "study/image/Image.h"

namespace vitrine
{

/**
 * The mean structural similarity of two pictures of the same size, 1 for equal ones: Gaussian window
 * of 11 x 11 pixels with sigma 1.5, K1 = 0.01, K2 = 0.03, values in [0, 1], mean over the channels.
 *
 * As scikit-image does, the mean leaves out the border of 5 pixels that the window overlaps. Along
 * an axis of less than 11 pixels nothing would be left, so there nothing is left out and the picture
 * goes on mirrored. Pictures without pixels are equal.
 */
double StructuralSimilarity(const Image& a, const Image& b);

}

#endif
