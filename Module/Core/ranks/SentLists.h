/** Lists of fragments as ranks send them to the owners of pixels, and their union. */
#ifndef VITRINE_CORE_RANKS_SENT_LISTS_H
#define VITRINE_CORE_RANKS_SENT_LISTS_H

#include "Core/ranks/Message.h"
#include "Core/ranks/TileOwners.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * Nodes of packed lists: the words of texels, 2 or 4 a node, and in nodes of 3 words a third word in an array of its
 * own (transparency/abuffer/NodeBuffers).
 */
struct ListNodes
{
  int TexelWords = 2;
  bool HasThirdWords = false;
  std::vector<std::uint32_t> Texels;
  std::vector<std::uint32_t> ThirdWords;

  /** Words of a node. */
  int Words() const { return this->TexelWords + (this->HasThirdWords ? 1 : 0); }

  void Resize(std::size_t nodes);
};

/** The lists of a picture's pixels. Pixels are counted by rows from the bottom. */
struct PixelLists
{
  std::vector<std::uint32_t> Starts; ///< The first node of each pixel.
  std::vector<std::uint32_t> Counts; ///< The number of nodes of each pixel.
  ListNodes Nodes;
};

/** Adds up the nodes of pixels. */
std::uint64_t CountNodes(const PixelLists& lists, const OwnedPixels& pixels);

/**
 * Appends the lists of pixels to a message: the numbers of nodes, as runs of equal ones, and the nodes
 * without gaps. Appends nothing if there are no nodes.
 */
void PackLists(const PixelLists& lists, const OwnedPixels& pixels, Message& message);

/**
 * Joins a rank's own lists of the `pixels` that it owns and those that other ranks sent to it. Other pixels have no
 * nodes. The order within a list is that of the ranks, which no picture depends on.
 * Returns an error message, empty on success: a message that does not fit, or a pixel with `most` nodes or more.
 */
std::string JoinLists(const PixelLists& own, const OwnedPixels& pixels,
  const std::vector<Message>& received, std::uint64_t most, PixelLists& joined);

}

#endif
