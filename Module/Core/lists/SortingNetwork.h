/**
 * Sorting networks: their construction, their proof, and their output as GLSL.
 */
#ifndef VITRINE_CORE_LISTS_SORTING_NETWORK_H
#define VITRINE_CORE_LISTS_SORTING_NETWORK_H

#include <string>
#include <vector>

namespace vitrine
{

/** Compares the values on two wires. The smaller one goes to Low, the larger one to High. Equal values stay. */
struct Comparator
{
  int Low;
  int High;
};

/**
 * A fixed sequence of comparators over wires 0 to Size - 1. If it sorts, it leaves the smallest value of any input on
 * wire 0 and the largest on wire Size - 1.
 */
struct SortingNetwork
{
  int Size;
  std::vector<Comparator> Comparators;
};

/** The largest number of inputs for which BestKnownNetwork() has a table and SortsAllZeroOneInputs() works. */
constexpr int LargestProvableNetwork = 64;

/**
 * Returns Batcher's odd-even merge sort for any number of inputs. It has 63 comparators for 16 inputs, 191 for 32 and
 * 543 for 64.
 *
 * K. E. Batcher: Sorting networks and their applications, AFIPS 1968. For sizes that are not a power of two: D. E.
 * Knuth, The Art of Computer Programming 3, 5.2.2, Algorithm M.
 */
SortingNetwork OddEvenMergeNetwork(int size);

/**
 * Returns the network with the fewest comparators known for `size` inputs, in layer order. It has 60 comparators for 16
 * inputs, 185 for 32 and 521 for 64. Above 64 inputs it is Batcher's network.
 */
SortingNetwork BestKnownNetwork(int size);

/**
 * Returns true if the network sorts every input. It checks all 2^Size inputs of zeros and ones, which suffices by the
 * 0-1 principle (Knuth, The Art of Computer Programming 3, 5.3.4, Theorem Z). It returns false if a comparator does not
 * join two different wires of the network.
 *
 * Inputs are not enumerated. Wires that comparators have joined so far form a group, with the set of 0-1 vectors that
 * can occur on it. Sets multiply only if a comparator joins two groups. Two sorted runs of 32 have 33 vectors each. So
 * sizes up to 64 take milliseconds for networks that sort and merge halves or quarters.
 *
 * @param network  has at most LargestProvableNetwork inputs
 * @throws std::length_error if more than 2^22 vectors would have to be held; nothing is decided then
 */
bool SortsAllZeroOneInputs(const SortingNetwork& network);

/**
 * Returns the network as the body of a branch-free GLSL function: one `macro(a, b);` for each comparator, in order,
 * eight to a line. An operand is `prefix` followed by the number of the wire. GLSL has no token pasting, so names are
 * written in full.
 *
 * @param macro   the name of a macro or function that orders its two operands
 * @param prefix  the prefix of register names; if empty, operands are plain numbers
 */
std::string EmitGlsl(
  const SortingNetwork& network, const std::string& macro, const std::string& prefix = "");

}

#endif
