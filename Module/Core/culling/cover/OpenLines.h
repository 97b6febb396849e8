#ifndef VITRINE_CORE_CULLING_COVER_OPEN_LINES_H
#define VITRINE_CORE_CULLING_COVER_OPEN_LINES_H

#include "Core/culling/buffer/SBuffer.h"
#include "Core/culling/cover/ScreenPatches.h"
#include "Core/culling/screen/LineExtent.h"

#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * Finds the lines of an s-buffer on which patches may cover something new. On other lines, all tiles that patches reach
 * are covered by depths at least as near as any patch there. This test takes a few steps for eight lines. To find what
 * patches cover takes some hundred steps for each line.
 */
class OpenLines
{
public:
  /** Finds the open lines among `lines`. */
  void Find(const SBuffer& buffer, const ScreenPatches& patches, const LineRange& lines);

  /** Returns true if one of these lines is open. */
  bool IsOpen(int line) const
  {
    return this->AreOpen[static_cast<std::size_t>(line - this->First)] != 0;
  }

  bool HasAny() const { return this->HasOpen; }

private:
  int First = 0;
  bool HasOpen = false;
  std::vector<std::uint8_t> AreOpen; ///< 1 for each open line
};

}

#endif
