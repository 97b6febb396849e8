#ifndef VITRINE_TESTING_IMAGE_PAIRS_H
#define VITRINE_TESTING_IMAGE_PAIRS_H

#include "study/image/Image.h"

#include <string>
#include <vector>

namespace vitrine
{

/** The value of 8 bits that a picture has at a pixel, x from the left and y from the top. */
using PixelFormula = int (*)(int x, int y, int channel);

/** Two pictures of integer formulas: what is measured, and what it should be. */
struct ImagePair
{
  const char* Name;
  int Width;
  int Height;
  PixelFormula Reference;
  PixelFormula Test;
};

/** The pairs whose errors the published implementations were asked for. */
const std::vector<ImagePair>& ImagePairs();

/** @throws std::out_of_range if no pair has this name */
const ImagePair& FindImagePair(const std::string& name);

/** The formula's picture, its values divided by 255. */
Image MakeImage(int width, int height, PixelFormula formula);

}

#endif
