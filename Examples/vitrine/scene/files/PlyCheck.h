/**
 * Whether a PLY file is whole.
 */
#ifndef VITRINE_PLY_CHECK_H
#define VITRINE_PLY_CHECK_H

#include <string>

namespace program
{

/**
 * Throw InputError unless the header makes sense to VTK's reader, everything that it announces is
 * there, and the corners of faces are among the vertices.
 *
 * G. Turk: The PLY Polygon File Format, 1994.
 */
void CheckPly(const std::string& path, const std::string& bytes);

}
#endif
