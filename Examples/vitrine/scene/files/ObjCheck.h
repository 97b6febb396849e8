/**
 * Whether OBJ and MTL files can be given to VTK's reader, and the names of their parts.
 */
#ifndef VITRINE_OBJ_CHECK_H
#define VITRINE_OBJ_CHECK_H

#include <string>
#include <vector>

namespace program
{

struct ObjContents
{
  std::vector<std::string> PartNames; ///< of what VTK's reader makes a part of: each `usemtl` line
  std::string MaterialLibrary;        ///< of the first `mtllib` line
};

/**
 * Throw InputError unless vertices are finite, corners of faces and lines are among them, and lines
 * are such as VTK's reader can take.
 */
ObjContents CheckObj(const std::string& path, const std::string& bytes);

/**
 * The names of the textures. Throws InputError where a line has more numbers than VTK's reader has
 * room for.
 */
std::vector<std::string> CheckMtl(const std::string& path, const std::string& bytes);

}
#endif
