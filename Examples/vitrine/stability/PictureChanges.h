/**
 * How pictures change from step to step.
 */
#ifndef VITRINE_PICTURE_CHANGES_H
#define VITRINE_PICTURE_CHANGES_H

#include "Core/Image.h"
#include "stability/Stability.h"

#include <vector>

namespace program
{

/** Takes a method's picture and truth's of each step in turn. */
class FlickerMeter
{
public:
  void Add(const vitrine::Image& method, const vitrine::Image& truth);

  /** Of the steps so far; zeros for fewer than two pictures. */
  Flicker Result() const;

private:
  vitrine::Image LastMethod;
  vitrine::Image LastTruth;
  std::vector<double> MethodChanges;
  std::vector<double> TruthChanges;
  double Excess = 0.0;
  double Error = 0.0;
};

}
#endif
