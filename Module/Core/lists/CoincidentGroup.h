#ifndef VITRINE_CORE_LISTS_COINCIDENT_GROUP_H
#define VITRINE_CORE_LISTS_COINCIDENT_GROUP_H

#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * Composites fragments that lie at one depth and so have no order. The result is the mean over all orders.
 *
 * In a random order of k fragments, the number m of fragments in front of fragment i is uniform in 0 to k - 1. Hence
 * the weight of fragment i is
 *
 *     w_i = alpha_i / k * sum over m of M_m
 *
 * where M_m is the mean, over all choices of m other fragments, of the product of their (1 - alpha). The means are
 * updated fragment by fragment, like binomial coefficients in Pascal's triangle. This takes k^2 steps. All terms are
 * positive, so there is no cancellation for any number of fragments. The order of Add() affects only the last bits.
 *
 * One order is composited as in T. Porter, T. Duff: Compositing digital images, SIGGRAPH 1984. The mean over orders is
 * a Shapley value (L. S. Shapley: A Value for n-Person Games, 1953).
 */
class CoincidentGroup
{
public:
  /** Add a fragment. Its alpha is in [0, 1]. Its colour is not premultiplied and may be infinite. */
  void Add(double alpha, const double rgb[3]) { this->Add(alpha, alpha, rgb); }

  /** Add an additive fragment, which hides nothing behind it. Its colour is premultiplied. */
  void AddLight(const double rgb[3]) { this->Add(0.0, 1.0, rgb); }

  /** Add the group's mean premultiplied colour times `factor` to `sum`. Fragments of weight 0 add nothing. */
  void AddColor(double factor, double sum[3]) const;

  /** Returns the group's transmittance: the product of all (1 - alpha). */
  double Transmittance() const { return this->Through.back(); }

private:
  struct Premultiplied
  {
    double Rgb[3];
  };

  void Add(double alpha, double weight, const double rgb[3]);

  /** By m: the mean transmittance of m random fragments of the group. */
  std::vector<double> Through{ 1.0 };
  /** By m: the mean premultiplied colour of one random fragment behind m random others. */
  std::vector<Premultiplied> Behind;
};

}

#endif
