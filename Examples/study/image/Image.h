#ifndef VITRINE_STUDY_IMAGE_IMAGE_H
#define VITRINE_STUDY_IMAGE_IMAGE_H

#include <vector>

namespace vitrine
{

/** A picture as displayed: sRGB values in [0, 1]. */
struct Image
{
  int Width = 0;
  int Height = 0;
  /** Height * Width triples of red, green and blue. Rows start at the bottom. */
  std::vector<float> Rgb;
};

}

#endif
