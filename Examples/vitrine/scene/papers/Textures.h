/**
 * Textures of coloured clouds with a cloudy opacity, the same to the bit on every machine.
 *
 * Value noise (K. Perlin: An Image Synthesizer, SIGGRAPH 1985, gives the family), of sums and products
 * alone, and without seams where the texture repeats.
 */
#ifndef VITRINE_PAPERS_TEXTURES_H
#define VITRINE_PAPERS_TEXTURES_H

#include "scene/Random.h"

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <vector>

namespace program
{

/** RGBA textures, each of two random colours; every opacity in them lies between 0 and 1, both excluded. */
std::vector<vtkSmartPointer<vtkTexture>> MakeCloudTextures(int count, Random& random);

}
#endif
