/**
 * Pareto fronts: the choices that no other choice beats in two measures at once.
 *
 * V. Pareto, Manuale di economia politica, 1906, as the term is used today. The sweep in order of cost is that of H. T.
 * Kung, F. Luccio, F. P. Preparata: On Finding the Maxima of a Set of Vectors, JACM 1975.
 */
#ifndef VITRINE_PARETO_FRONT_H
#define VITRINE_PARETO_FRONT_H

#include <cstddef>
#include <vector>

namespace program
{

/** What a choice costs and how wrong it is; less is better. */
struct CostAndError
{
  double Cost;
  double Error;
};

/**
 * Returns the indices of the choices on the Pareto front, in order of cost, and of index among equals. A choice is on
 * the front if no other one is at most as large in both cost and error and smaller in one. Choices with a NaN are left
 * out.
 */
std::vector<std::size_t> FindParetoFront(const std::vector<CostAndError>& choices);

}
#endif
