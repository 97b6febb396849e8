/**
 * Stencil routing: the samples of a pixel separate its fragments, one fragment each, in one or more passes over the
 * geometry.
 *
 * K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches. The test compares the stencil with a value p,
 * and each fragment decrements the stencil of all samples. So a sample that starts with p + i lets fragment i of the
 * pixel pass.
 *
 * All passes use the same start values, the highest that 8 bits hold. p falls by K, the number of samples, from pass to
 * pass. So pass j takes fragments j K to j K + K - 1. The decrement stops at 0, to which no pass compares. So no
 * fragment passes twice, and the final value tells the number of fragments. Sample 0, which most drivers return for a
 * pixel, starts highest: it takes the last fragment of a pass and counts farthest.
 */
#ifndef VITRINE_CORE_LISTS_STENCIL_ROUTING_H
#define VITRINE_CORE_LISTS_STENCIL_ROUTING_H

#include <vector>

namespace vitrine
{

/** Returns the supported numbers of samples: powers of two up to 32. */
const std::vector<int>& RoutedSampleCounts();

/** Computes stencil values and passes from the number of samples that take fragments. */
class StencilRoute
{
public:
  explicit StencilRoute(int samples = 1)
    : Samples(samples)
  {
  }

  int SamplesPerPass() const { return this->Samples; }

  /** Returns the start value of a sample, which is the same in each pass. */
  int StartValue(int sample) const { return 255 - sample; }

  /** Returns the stencil value that lets a fragment pass in a pass. Passes are numbered from 0. */
  int PassingValue(int pass) const { return 256 - this->Samples * (pass + 1); }

  /** Returns the maximum number of passes for 8 bits. One value is reserved to detect an extra fragment. */
  int MostPasses() const { return 254 / this->Samples; }

  /** Returns the number of passes that take `layers` fragments of a pixel, limited to MostPasses(). */
  int PassesFor(int layers) const;

private:
  int Samples;
};

}

#endif
