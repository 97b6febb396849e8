/**
 * How lists of fragments are laid out: what shaders are compiled for.
 */
#ifndef VITRINE_LIST_LAYOUT_H
#define VITRINE_LIST_LAYOUT_H

#include <string>
#include <vector>

namespace vitrine
{

struct ListLayout
{
  bool Packed = false; ///< successive nodes of a packed buffer; else linked pages of a pool
  bool HalfFloat = true;
  bool FixedPoint = true;
  bool FramebufferFetch = false;
  int Samples = 0;
  int PageSize = 1;

  /** The shaders' defines for this layout. */
  std::vector<std::string> Defines() const;

  /** Bytes of a node: 8, 12 or 16. */
  int NodeBytes() const;
};

}
#endif
