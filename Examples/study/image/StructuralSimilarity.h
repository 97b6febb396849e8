#ifndef VITRINE_STUDY_IMAGE_STRUCTURAL_SIMILARITY_H
#define VITRINE_STUDY_IMAGE_STRUCTURAL_SIMILARITY_H

#include "study/image/Image.h"

namespace vitrine
{

/**
 * Returns the mean structural similarity of two pictures of the same size, which is 1 for equal pictures. It uses a
 * Gaussian window of 11 x 11 pixels with sigma 1.5, K1 = 0.01, K2 = 0.03, values in [0, 1], and the mean over the
 * channels.
 *
 * As in scikit-image, the mean excludes the border of 5 pixels that the window overlaps. Along an axis of less than 11
 * pixels nothing would remain, so there nothing is excluded and the picture is mirrored. Pictures without pixels are
 * equal.
 */
double StructuralSimilarity(const Image& a, const Image& b);

}

#endif
