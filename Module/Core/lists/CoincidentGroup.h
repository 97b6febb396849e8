#ifndef VITRINE_CORE_LISTS_COINCIDENT_GROUP_H
#define VITRINE_CORE_LISTS_COINCIDENT_GROUP_H

#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * Fragments that lie at one depth and so have no order: composited as the mean over all orders.
 *
 * Of k fragments, m random others lie in front of fragment i with each m from 0 to k - 1 as likely. So its weight is
 *
 *     w_i = alpha_i / k * sum over m of M_m
 *
 * where M_m is the mean, over all choices of m others, of the product of their (1 - alpha). The means follow from each
 * other fragment by fragment, as binomial coefficients do in Pascal's triangle, and all terms are positive: k^2 steps, and
 * no cancellation with any number of fragments. The order of Add() matters for the last bits only.
 *
 * The compositing of one order is T. Porter, T. Duff: Compositing digital images, SIGGRAPH 1984. The sum over orders is
 * that of a Shapley value: L. S. Shapley: A Value for n-Person Games, 1953.
 */
class CoincidentGroup
{
public:
  /** Add a fragment: alpha in [0, 1], colour not premultiplied, which may be infinite. */
  void Add(double alpha, const double rgb[3]) { this->Add(alpha, alpha, rgb); }

  /** Add a fragment that is added to what is behind it, and hides nothing of it: its colour, premultiplied. */
  void AddLight(const double rgb[3]) { this->Add(0.0, 1.0, rgb); }

  /** Add the mean colour of the group, premultiplied, times `factor`, to `sum`. What has no weight adds nothing. */
  void AddColor(double factor, double sum[3]) const;

  /** The share of light that the group lets through: the product of (1 - alpha). */
  double Transmittance() const { return this->Through.back(); }

private:
  struct Premultiplied
  {
    double Rgb[3];
  };

  void Add(double alpha, double weight, const double rgb[3]);

  /** By m: mean transmittance of m random fragments of the group. */
  std::vector<double> Through{ 1.0 };
  /** By m: mean of one random fragment's premultiplied colour behind m random others. */
  std::vector<Premultiplied> Behind;
};

}

#endif
