/**
 * Finds opacities of the parts in front, such that a part behind them shows and as much as possible of them remains.
 */
#ifndef VITRINE_CORE_REVEAL_MOST_CONTEXT_H
#define VITRINE_CORE_REVEAL_MOST_CONTEXT_H

#include "Core/reveal/FrontStacks.h"

#include <vector>

namespace vitrine
{

/** A column of a reveal: a part in front. Depths are optical depths: -ln(1 - opacity). */
struct FadedPart
{
  double Weight = 1.0; // what its opacity counts for: its area in pixels
  double Least = 0.0;  // range of its optical depth
  double Most = 0.0;   // may be infinite, as that of an opaque part is
};

/** Optical depths, and the proof that they are good. */
struct FadedParts
{
  std::vector<double> Depths; // column by column
  double Context = 0.0;       // sum of weight * opacity
  double Bound = 0.0;         // no optical depths that are allowed give more than this context
  double Deepest = 0.0;       // largest optical depth of a stack that is not near
  int Steps = 0;              // steps of Newton's method

  /** Returns the share of the best possible context that is proved to be reached, 0 to 1. */
  double ProvedShare() const { return this->Bound > 0.0 ? this->Context / this->Bound : 1.0; }
};

/**
 * Maximises the context: the sum of weight * opacity over all parts in front. Each stack's optical depth has a limit.
 * With the limit d, at least exp(-d) of the light of what is behind passes.
 *
 * Stacks are linear in optical depths, and the context is concave in them. So there is one optimum. An interior-point
 * method approaches it and stays within all limits. Multipliers of the stacks give a bound on the context (Lagrange
 * duality), and the method ends when the bound is near. Of the many nearly best answers it gives one in the middle: no
 * part vanishes altogether unless it must, and the answer changes little if the stacks change little. A linear
 * programme in optical depths has its answers in corners, and these jump.
 *
 * The work does not depend on the machine's time, and the same input gives the same bits.
 *
 * @param parts   as many as stacks.Parts(). With all parts at their least depths, no stack may be deeper than its
 *                limit.
 * @param limits  the optical depth that each stack may have: 0 or more, or infinite
 * @param gap     the context may fall short of the bound by this share of it
 */
FadedParts MostContext(const FrontStacks& stacks, const std::vector<FadedPart>& parts,
  const std::vector<double>& limits, double gap = 0.01);

/** Returns the optical depth of a stack, given those of columns. */
double DepthOf(const FrontStacks& stacks, std::size_t stack, const std::vector<double>& depths);

}

#endif
