/**
 * How pictures change from step to step.
 */
#ifndef VITRINE_PICTURE_CHANGES_H
#define VITRINE_PICTURE_CHANGES_H

#include "stability/Stability.h"
#include "study/image/Image.h"

#include <vector>

namespace program
{

/** The largest difference of any channel of any pixel, as a display shows them; pictures of one size. */
double LargestDifference(const vitrine::Image& a, const vitrine::Image& b);

/** Takes a method's picture and truth's of each step in turn. */
class FlickerMeter
{
public:
  /** The next picture is no step on from the last. */
  void BeginRun();

  void Add(const vitrine::Image& method, const vitrine::Image& truth);

  /** Of the steps so far; zeros for fewer than two pictures. */
  Flicker Result() const;

private:
  /** What one step changes. */
  struct StepChange
  {
    double Largest;
    double ChangedPixels;
  };
  static StepChange Measure(const vitrine::Image& before, const vitrine::Image& after);
  static PictureChange Summarise(const std::vector<StepChange>& steps);

  vitrine::Image LastMethod;
  vitrine::Image LastTruth;
  std::vector<StepChange> MethodSteps;
  std::vector<StepChange> TruthSteps;
  double Excess = 0.0;
  double Error = 0.0;
};

}
#endif
