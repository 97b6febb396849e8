#ifndef VITRINE_CORE_LISTS_SORTING_NETWORK_H
#define VITRINE_CORE_LISTS_SORTING_NETWORK_H

#include <string>
#include <vector>

namespace vitrine
{

/**
 * Compares the values on two wires and leaves the smaller one on Low, the larger one on High.
 * Equal values stay where they are.
 */
struct Comparator
{
  int Low;
  int High;
};

/**
 * A fixed sequence of comparators over Size wires, numbered from 0. Applied in order it leaves the
 * smallest value on wire 0 and the largest on wire Size - 1, whatever the input, if it sorts.
 */
struct SortingNetwork
{
  int Size;
  std::vector<Comparator> Comparators;
};

/** The largest number of inputs for which BestKnownNetwork() has a table, and the prover an answer. */
constexpr int LargestProvableNetwork = 64;

/**
 * Batcher's odd-even merge sort for any number of inputs. 63 comparators for 16 inputs, 191 for 32,
 * 543 for 64.
 *
 * K. E. Batcher: Sorting networks and their applications. AFIPS 1968; for sizes that are no power
 * of two: D. E. Knuth, The Art of Computer Programming 3, 5.2.2, Algorithm M.
 */
SortingNetwork OddEvenMergeNetwork(int size);

/**
 * The network with the fewest comparators known for `size` inputs, in layer order: 60 comparators
 * for 16 inputs, 185 for 32, 521 for 64. Beyond 64 inputs, Batcher's.
 */
SortingNetwork BestKnownNetwork(int size);

/**
 * Whether the network sorts every input, decided over all of its 2^Size inputs of zeros and ones
 * (the 0-1 principle: Knuth, The Art of Computer Programming 3, 5.3.4, Theorem Z). False for a
 * network with a comparator that does not join two different wires of it.
 *
 * Inputs are not counted out one by one: each group of wires that comparators have joined so far
 * carries the set of the 0-1 vectors that can occur on it, and sets multiply only where a
 * comparator joins two groups. Two sorted runs of 32 are 33 vectors each, so sizes up to 64 take
 * milliseconds where the network sorts and merges by halves or quarters.
 *
 * @param network  of at most LargestProvableNetwork inputs
 * @throws std::length_error when more than 2^22 vectors would have to be held; nothing is decided then
 */
bool SortsAllZeroOneInputs(const SortingNetwork& network);

/**
 * The network as the body of a GLSL function without branches or indexing: one `macro(a, b);` per
 * comparator, in order, eight to a line. The operands are register names: `prefix` followed by the
 * number of the wire, so that the shader needs no token pasting, which GLSL lacks.
 *
 * @param macro   name of a macro or function that orders its two operands
 * @param prefix  of the registers' names; empty leaves plain numbers
 */
std::string EmitGlsl(
  const SortingNetwork& network, const std::string& macro, const std::string& prefix = "");

}

#endif
