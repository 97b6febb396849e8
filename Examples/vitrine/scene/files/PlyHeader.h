/**
 * The header of a PLY file.
 */
#ifndef VITRINE_PLY_HEADER_H
#define VITRINE_PLY_HEADER_H

#include <cstddef>
#include <string>
#include <vector>

namespace program
{

struct PlyType
{
  std::size_t Bytes = 0;
  bool IsFloat = false;
  bool IsSigned = false;
};

struct PlyProperty
{
  std::string Name;
  PlyType Type;
  bool IsList = false;
  PlyType CountType; ///< of a list
};

struct PlyElement
{
  std::string Name;
  std::size_t Count = 0;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  bool IsText = false;
  bool IsBigEndian = false;
  std::vector<PlyElement> Elements;
  std::size_t Bytes = 0; ///< the body begins here
};

/** Parse the header. Throws InputError if there is none or it is not understood. */
PlyHeader ParsePlyHeader(const std::string& path, const std::string& bytes);

/** The element of that name, or null. */
const PlyElement* FindPlyElement(const PlyHeader& header, const std::string& name);

/** The property of that name, or null. */
const PlyProperty* FindPlyProperty(const PlyElement& element, const std::string& name);

}
#endif
