/** The opaque pictures of ranks, and the nearest of them in each pixel. */
#ifndef VITRINE_CORE_RANKS_OPAQUE_PIXELS_H
#define VITRINE_CORE_RANKS_OPAQUE_PIXELS_H

#include "Core/ranks/Message.h"
#include "Core/ranks/TileOwners.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Depths and colours of a picture. Pixels are counted by rows from the bottom. A multisampled picture begins with
 * sample 0 of all pixels, then has sample 1, and so on. Depths are words whose order is that of the depths: integers,
 * or bits of floats that are not negative.
 */
struct OpaquePixels
{
  int Samples = 1;                      ///< of a pixel
  int ColorWords = 1;                   ///< 1 for 8 bits a channel, 4 for floats
  std::uint32_t Farthest = 0xffffffffu; ///< the depth at which nothing was drawn
  std::vector<std::uint32_t> Depths;
  std::vector<std::uint32_t> Colors; ///< ColorWords of each sample
};

/**
 * Appends the samples of `pixels` in which something was drawn: runs of samples to leave out and to take, and depths
 * and colours. Messages list all samples of a pixel, then those of the next. A colour that is that of the sample before
 * in the same pixel is not repeated. Appends nothing if nothing was drawn.
 */
void PackOpaque(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message);

/**
 * Takes the samples of another rank that are nearer than those of `picture`. Of equal depths the larger colour is
 * taken, so that the order of ranks does not matter: by alpha, then blue, green and red, as JoinLayers() does. Sets
 * `depths` to the other rank's depth of each sample of the `pixels`. Returns false if the message does not fit.
 */
bool TakeNearer(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture,
  std::vector<std::uint32_t>& depths);

/** Appends the depths of the samples in which `picture` is nearer than `known`, in runs as PackOpaque(). */
void PackDepths(const OpaquePixels& picture, const OwnedPixels& pixels,
  const std::vector<std::uint32_t>& known, Message& message);

/** Takes the depths of a message of PackDepths(). Returns false if it does not fit. */
bool TakeDepths(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture);

/** Appends the colours of all samples of the `pixels`, as PackOpaque() does. */
void PackColors(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message);

/** Takes the colours of a message of PackColors(). Returns false if it does not fit. */
bool TakeColors(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture);

}

#endif
