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
 * Lines of an s-buffer on which some patches may cover something: on others all tiles that they reach are covered by what is at least as near as any of them is there. To
 * find that takes a few steps for eight lines, to look for what they cover some hundreds for each.
 */
class OpenLines
{
public:
  /** Of some lines. */
  void Find(const SBuffer& buffer, const ScreenPatches& patches, const LineRange& lines);

  /** Of those lines. */
  bool IsOpen(int line) const
  {
    return this->AreOpen[static_cast<std::size_t>(line - this->First)] != 0;
  }

  bool HasAny() const { return this->HasOpen; }

private:
  int First = 0;
  bool HasOpen = false;
  std::vector<std::uint8_t> AreOpen; ///< each line
};

}

#endif
