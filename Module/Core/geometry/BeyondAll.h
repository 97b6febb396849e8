#ifndef VITRINE_CORE_GEOMETRY_BEYOND_ALL_H
#define VITRINE_CORE_GEOMETRY_BEYOND_ALL_H

namespace vitrine
{

/** A number farther from zero than all columns, lines, depths and distances. Its differences from them are finite. */
inline constexpr float BeyondAll = 3e38f;

}

#endif
