#ifndef VITRINE_CORE_GEOMETRY_BEYOND_ALL_H
#define VITRINE_CORE_GEOMETRY_BEYOND_ALL_H

namespace vitrine
{

/** Farther from zero than all columns, lines, depths and distances, and finite: differences of it are numbers. */
inline constexpr float BeyondAll = 3e38f;

}

#endif
