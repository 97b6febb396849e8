/**
 * Which of several choices nobody beats in two things at once.
 *
 * V. Pareto, Manuale di economia politica, 1906, as the term is used today; the staircase by one sweep in order of cost is
 * that of H. T. Kung, F. Luccio, F. P. Preparata: On Finding the Maxima of a Set of Vectors, JACM 1975.
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
 * The indices of the choices than which no other has at most the cost and at most the error and one of them less, in order of
 * cost, of equals in order of index. Choices with a NaN are left out.
 */
std::vector<std::size_t> FindParetoFront(const std::vector<CostAndError>& choices);

}
#endif
