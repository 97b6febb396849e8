#ifndef VITRINE_CORE_LISTS_SORTING_NETWORK_TABLES_H
#define VITRINE_CORE_LISTS_SORTING_NETWORK_TABLES_H

#include "Core/lists/SortingNetwork.h"

namespace vitrine
{

/**
 * The smallest known network for `size` inputs as text: two characters per comparator, the wires'
 * numbers as digits of base 64 (0-9, A-Z, a-z, +, -); a space ends a layer. Null where there is no
 * table: below 2 and above 64 inputs.
 */
const char* BestKnownNetworkText(int size);

/** The network that a text in the format above says. */
SortingNetwork DecodeNetwork(int size, const char* text);

}

#endif
