#ifndef VITRINE_CORE_REVEAL_STEADY_REVEAL_H
#define VITRINE_CORE_REVEAL_STEADY_REVEAL_H

#include "Core/reveal/FrontStacks.h"
#include "Core/reveal/MostContext.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace vitrine
{

/**
 * The opacities of the parts in front of a part that shows, view by view.
 *
 * In each view, at least Share of the light of the part passes what is in front, in each of its pixels. Nothing takes
 * precedence over that. Opacities change by PerDegree at most for each degree by which the view has turned, but for two
 * kinds of parts, which are counted. A part that is newly in front may drop at once. A part that was in front may have
 * to drop where it comes in front of a pixel together with others; as few parts as possible do so, found greedily.
 * Near stacks (NearStacks.h) keep that rare: parts that may come together soon have less opacity, so that they can fall
 * in time. Within these limits the context is the largest possible one (MostContext.h). Parts that are in front no more
 * rise to the opacity that they had.
 */
class SteadyReveal
{
public:
  /** A part that was faded, or still is. */
  struct Part
  {
    double Opacity;
    double Original; // its opacity before it was faded
    bool IsInFront;
  };

  /** A part in front, as it would be drawn without being faded. */
  struct FrontPart
  {
    double Weight;  // its area in pixels
    double Opacity; // 0 to 1
  };

  /** What an update did. */
  struct Change
  {
    FadedParts Proof; // of the parts in front; the bound is that within the limits of change
    std::size_t NewlyInFront = 0;
    std::size_t Dropped = 0;   // of these, how many dropped by more than the limit of change
    std::size_t Forced = 0;    // other parts that dropped by more than the limit
    double MostOfOthers = 0.0; // largest change of opacity of all other parts
  };

  /**
   * @param share      the least transmittance of what is in front, above 0 and at most 1
   * @param perDegree  the largest change of an opacity, for each degree of turning
   */
  explicit SteadyReveal(double share, double perDegree = 0.05);

  /**
   * Finds the opacities of a view.
   * @param stacks   what is in front of the part
   * @param parts    as many as stacks.Parts()
   * @param degrees  by how much the view has turned since the last update. Infinite: opacities may change at once.
   */
  Change Update(const FrontStacks& stacks, const std::vector<FrontPart>& parts, double degrees);

  /** Returns the parts that are faded, by numbers. */
  const std::map<std::uint32_t, Part>& Parts() const { return this->Faded; }

private:
  std::vector<FadedPart> LimitsOf(
    const FrontStacks& stacks, const std::vector<FrontPart>& parts, double most);
  std::vector<double> DepthsOf(const FrontStacks& stacks, const std::vector<double>& depths) const;
  FadedParts Solve(
    const FrontStacks& stacks, const std::vector<FadedPart>& parts, bool isAtOnce) const;
  void Apply(const FrontStacks& stacks, double most, Change& change);
  void RaiseOthers(double most);

  double Deepest;
  double PerDegree;
  std::map<std::uint32_t, Part> Faded;
};

/**
 * Sets least depths to 0 until no stack is deeper than `deepest` where all parts are at their least depths. In each
 * step that part is chosen which takes most from the stacks that are too deep.
 */
void MakeRoom(const FrontStacks& stacks, double deepest, std::vector<FadedPart>& parts);

}

#endif
