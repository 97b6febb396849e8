/** Constants that C++ and GLSL share for the measured sorts (SortHarness.glsl). */
#ifndef VITRINE_STUDY_SHADERS_SORT_LAYOUT_H
#define VITRINE_STUDY_SHADERS_SORT_LAYOUT_H

// Number of lists per row of pixels.
#define VITRINE_SORT_ROW 256

// The odd constants of a list's checksum (study/sorts/ListChecksum).
#define VITRINE_CHECKSUM_FACTOR 0x9e3779b1u
#define VITRINE_CHECKSUM_KEY 0x85ebca6bu
#define VITRINE_CHECKSUM_PAYLOAD 0xc2b2ae35u

#endif
