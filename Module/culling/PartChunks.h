#ifndef VITRINE_CULLING_PART_CHUNKS_H
#define VITRINE_CULLING_PART_CHUNKS_H

#include "Core/threads/ForEachInThreads.h"

#include <algorithm>
#include <cstddef>

namespace vitrine
{

/** Cuts many parts into chunks for threads. Few parts are one chunk: they are not worth a thread. */
class PartChunks
{
public:
  explicit PartChunks(std::size_t parts)
    : Parts(parts)
    , Size(parts < FewParts ? FewParts : PartsOfOne)
  {
  }

  std::size_t Count() const { return (this->Parts + this->Size - 1) / this->Size; }

  /**
   * Calls `work` for each chunk, in several threads at a time. Its arguments are the number of the chunk, the index of
   * its first part, and the index behind its last part.
   */
  template <class Work>
  void ForEach(const Work& work) const
  {
    ForEachInThreads(this->Count(),
      [&](std::size_t chunk)
      {
        const std::size_t first = chunk * this->Size;
        work(chunk, first, std::min(this->Parts, first + this->Size));
      });
  }

private:
  static constexpr std::size_t FewParts = 2048;
  static constexpr std::size_t PartsOfOne = 512;

  std::size_t Parts;
  std::size_t Size;
};

}

#endif
