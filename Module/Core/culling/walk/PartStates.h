#ifndef VITRINE_CORE_CULLING_WALK_PART_STATES_H
#define VITRINE_CORE_CULLING_WALK_PART_STATES_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vitrine
{

/**
 * What a walk knows of each part, in one byte. Parts come in any order, and each access to another place in memory
 * takes as long as some tens of steps.
 */
class PartStates
{
public:
  static constexpr std::uint8_t IsDrawn = 1;   ///< the frame draws the part
  static constexpr std::uint8_t IsVisited = 2; ///< the part was visited before its turn
  static constexpr std::uint8_t IsShown = 4;
  /** The mesh of the part had few points when it was last asked for. */
  static constexpr std::uint8_t WasSmall = 8;
  /** All faces were found hidden one by one, wherever a device draws them. */
  static constexpr std::uint8_t AreFacesHidden = 16;
  static constexpr std::uint8_t WasIdle = 32;     ///< it was inserted in vain (LastOwners)
  static constexpr std::uint8_t HasSamples = 64;  ///< it owns samples as the frame ends
  static constexpr std::uint8_t HadSamples = 128; ///< it owned samples as the last frame ended

  /**
   * Begins a frame. Of each part only IsDrawn, HadSamples, WasSmall and WasIdle are known then.
   * @param drawn  0 for parts that the frame does not draw
   * @returns      the number of parts that the frame draws
   */
  std::uint32_t Begin(const std::vector<std::uint8_t>& drawn)
  {
    static_assert(IsDrawn == 1, "as a comparison tells it");
    static_assert(HadSamples == HasSamples << 1, "as it is shifted");
    this->States.resize(drawn.size(), 0);
    std::uint8_t* const states = this->States.data();
    const std::uint8_t* const areDrawn = drawn.data();
    const std::size_t parts = drawn.size();
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < parts; ++i)
    {
      const std::uint8_t isDrawn = areDrawn[i] != 0;
      const int had = (states[i] & HasSamples) << 1;
      states[i] = static_cast<std::uint8_t>((states[i] & (WasSmall | WasIdle)) | had | isDrawn);
      count += isDrawn;
    }
    return count;
  }

  std::size_t Count() const { return this->States.size(); }

  /** Returns all bits of a part. */
  std::uint8_t operator[](std::uint32_t part) const { return this->States[part]; }

  bool Has(std::uint32_t part, std::uint8_t bit) const { return (this->States[part] & bit) != 0; }

  void Set(std::uint32_t part, std::uint8_t bit, bool is = true)
  {
    std::uint8_t& state = this->States[part];
    state = static_cast<std::uint8_t>(is ? state | bit : state & ~bit);
  }

private:
  std::vector<std::uint8_t> States;
};

}

#endif
