/**
 * Tables of the smallest known sorting networks as text.
 */
#ifndef VITRINE_CORE_LISTS_SORTING_NETWORK_TABLES_H
#define VITRINE_CORE_LISTS_SORTING_NETWORK_TABLES_H

#include "Core/lists/SortingNetwork.h"

namespace vitrine
{

/**
 * Returns the smallest known network for `size` inputs as text. A comparator is two characters: the wires' numbers as
 * base-64 digits (0-9, A-Z, a-z, +, -). A space ends a layer. It is null below 2 and above 64 inputs.
 */
const char* BestKnownNetworkText(int size);

/** Returns the network that such a text encodes. */
SortingNetwork DecodeNetwork(int size, const char* text);

}

#endif
