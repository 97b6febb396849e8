/**
 * Methods that differ in their settings only look alike in charts.
 */
#ifndef VITRINE_METHOD_FAMILY_H
#define VITRINE_METHOD_FAMILY_H

#include <array>
#include <string>
#include <vector>

namespace program
{

/** How the members of a family are drawn. */
struct MethodFamily
{
  std::string Name;                   ///< how its members' names begin
  std::array<unsigned char, 3> Color; ///< red, green, blue
  std::string Marker; ///< plus, cross, circle, square or diamond; one after "open-" has a hole
};

/** All families, the last of which is of methods that belong to no other. */
const std::vector<MethodFamily>& MethodFamilies();

/** The family of a method. */
const MethodFamily& FamilyOf(const std::string& method);

}
#endif
