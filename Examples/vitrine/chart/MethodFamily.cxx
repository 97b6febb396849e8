#include "chart/MethodFamily.h"

namespace program
{

const std::vector<MethodFamily>& MethodFamilies()
{
  // The colours of M. Okabe and K. Ito, which the colour-blind tell apart, black, and greys.
  static const std::vector<MethodFamily> families = {
    { "blend", { { 128, 128, 128 } }, "cross" },
    { "vtk-oit", { { 213, 94, 0 } }, "open-diamond" },
    { "vtk-peeling", { { 230, 159, 0 } }, "square" },
    { "linked-list", { { 0, 114, 178 } }, "circle" },
    { "prefix-sum", { { 86, 180, 233 } }, "diamond" },
    { "stencil-mask", { { 0, 158, 115 } }, "open-circle" },
    { "stencil-routed", { { 204, 121, 167 } }, "plus" },
    { "automatic", { { 0, 0, 0 } }, "open-square" },
    { "other", { { 96, 96, 96 } }, "open-cross" },
  };
  return families;
}

const MethodFamily& FamilyOf(const std::string& method)
{
  for (const MethodFamily& family : MethodFamilies())
  {
    if (method.compare(0, family.Name.size(), family.Name) == 0)
    {
      return family;
    }
  }
  return MethodFamilies().back();
}

}
