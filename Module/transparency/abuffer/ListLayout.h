/**
 * How lists of fragments are laid out: what shaders are compiled for.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_LAYOUT_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_LAYOUT_H

#include <string>
#include <vector>

namespace vitrine
{

/** How nodes keep colours. */
enum class NodeColors
{
  HalfFloat, ///< four 16-bit floats
  EightBit,  ///< RGBA8
  Compact    ///< with the depth in two words: for fixed-point targets
};

struct ListLayout
{
  bool Packed = false; ///< successive nodes of a packed buffer; else linked pages of a pool
  NodeColors Colors = NodeColors::HalfFloat;
  bool FixedPoint = true;
  bool FramebufferFetch = false;
  bool Additive = false;    ///< some fragments are added to what is behind them
  bool Coincidence = false; ///< depths are intervals: with a tolerance
  int Samples = 0;
  int PageSize = 1;

  /** What names the kind of colours in shaders; null for 8 bits. */
  const char* ColorDefine() const;

  /** The shaders' defines for this layout. */
  std::vector<std::string> Defines() const;

  /** Bytes of a node: 8, 12 or 16. */
  int NodeBytes() const;
};

}
#endif
