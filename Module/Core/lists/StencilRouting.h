/**
 * Stencil routing: how the samples of a pixel take its fragments apart, one fragment each, in one pass over the geometry or
 * in several.
 *
 * K. Myers, L. Bavoil: Stencil Routed A-Buffer, SIGGRAPH 2007 sketches. A sample that begins with p + i in the stencil, where
 * p is what the test compares with, lets fragment i of the pixel's sequence through, since every fragment decrements the
 * stencil of all samples. Samples begin alike in each pass, as high as 8 bits go, and p falls by K from one pass to the
 * next: pass j takes fragments j K to j K + K - 1. The decrement ends at 0, which no pass compares with: no fragment
 * passes twice, and what is left tells how many there were. Sample 0, by which drivers mostly stand for a pixel, begins
 * highest and takes the last fragment of a pass, so that it counts farthest.
 */
#ifndef VITRINE_CORE_LISTS_STENCIL_ROUTING_H
#define VITRINE_CORE_LISTS_STENCIL_ROUTING_H

#include <vector>

namespace vitrine
{

/** The numbers of samples a pass that there are: powers of two up to 32. */
const std::vector<int>& RoutedSampleCounts();

/** The number of `samples` that take fragments, and with it what the stencil has for them. */
class StencilRoute
{
public:
  explicit StencilRoute(int samples = 1)
    : Samples(samples)
  {
  }

  int SamplesPerPass() const { return this->Samples; }

  /** What a sample begins each pass with. */
  int StartValue(int sample) const { return 255 - sample; }

  /** What lets a fragment through in a pass, from pass 0 on. */
  int PassingValue(int pass) const { return 256 - this->Samples * (pass + 1); }

  /** How many passes 8 bits have room for, if one fragment more is to be noticed. */
  int MostPasses() const { return 254 / this->Samples; }

  /** How many passes take `layers` fragments of a pixel, as far as there are as many. */
  int PassesFor(int layers) const;

private:
  int Samples;
};

}

#endif
