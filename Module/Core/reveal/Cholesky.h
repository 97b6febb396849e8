#ifndef VITRINE_CORE_REVEAL_CHOLESKY_H
#define VITRINE_CORE_REVEAL_CHOLESKY_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace vitrine
{

/**
 * A symmetric positive definite matrix, dense, of which the lower triangle is kept row by row. Solve() replaces it by
 * its Cholesky factor.
 */
class Cholesky
{
public:
  explicit Cholesky(std::size_t size)
    : Size(size)
    , Values(size * size)
    , Column(size)
  {
  }

  void Clear() { this->Values.assign(this->Values.size(), 0.0); }
  double* Row(std::size_t row) { return this->Values.data() + row * this->Size; }

  /** Replaces x by the solution of M * solution = x. */
  void Solve(std::vector<double>& x)
  {
    this->Factorise();
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      const double* row = this->Row(i);
      for (std::size_t j = 0; j < i; ++j)
      {
        x[i] -= row[j] * x[j];
      }
      x[i] /= row[i];
    }
    for (std::size_t i = this->Size; i-- > 0;)
    {
      const double* row = this->Row(i);
      x[i] /= row[i];
      for (std::size_t j = 0; j < i; ++j)
      {
        x[j] -= row[j] * x[i];
      }
    }
  }

private:
  void Factorise()
  {
    for (std::size_t k = 0; k < this->Size; ++k)
    {
      const double pivot = std::sqrt(this->Row(k)[k]);
      this->Row(k)[k] = pivot;
      for (std::size_t i = k + 1; i < this->Size; ++i)
      {
        this->Column[i] = this->Row(i)[k] /= pivot;
      }
      for (std::size_t i = k + 1; i < this->Size; ++i)
      {
        const double factor = this->Column[i];
        if (factor != 0.0)
        {
          double* row = this->Row(i);
          for (std::size_t j = k + 1; j <= i; ++j)
          {
            row[j] -= factor * this->Column[j];
          }
        }
      }
    }
  }

  std::size_t Size;
  std::vector<double> Values;
  std::vector<double> Column;
};

}

#endif
