/**
 * @class   vtkTolerantTransparencyPass
 * @brief   what the methods share that have a tolerance for coincidence
 *
 * Fragments of mating faces lie in one place, and float noise orders them. Within the tolerance they have no order.
 */
#ifndef vtkTolerantTransparencyPass_h
#define vtkTolerantTransparencyPass_h

#include "vtkTransparencyPass.h"

namespace vitrine
{
struct CoincidenceTolerance;
}

class VTKVITRINERENDERING_EXPORT vtkTolerantTransparencyPass : public vtkTransparencyPass
{
public:
  vtkAbstractTypeMacro(vtkTolerantTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The tolerance within which fragments coincide; what truth is to methods depends on it as they do.
   * As glPolygonOffset reckons, a fragment's tolerance is Steps * 2^-24 + Slope * max(|dz/dx|, |dz/dy|): a number of the
   * smallest steps that a 24-bit depth buffer has, and a share of the larger change of its depth to the next pixel.
   * Fragments whose depths are within the sum of their tolerances coincide, and so do those that others between them
   * join. They are composited as the mean over all their orders, so that neither their order nor noise below the
   * tolerance shows. Two come out the same to the bit in any order, more of them up to the last bits of a 32-bit float.
   * Where nothing coincides, the picture is what it is without.
   *
   * Both are 0 by default, which is no tolerance: fragments of exactly equal depth are ordered by packed colour. What
   * is near for other reasons coincides too: front and back of a part along its silhouette, within about Slope / 2
   * pixels of it, and layers closer than the tolerance. At the rims of impostors, whose shaders throw fragments away,
   * the slope is what the driver makes of it. Fragments of alpha 0 coincide with none and join none. Opaque geometry
   * has no tolerance: what it hides is decided by the depth test. A fragment in an A-buffer takes 4 bytes more, unless
   * the target is multisampled. Numbers below 0, infinite ones and NaN are errors, and change nothing. Targets of more
   * than 16 samples are refused.
   */
  void SetCoincidenceSteps(double steps);
  vtkGetMacro(CoincidenceSteps, double);
  void SetCoincidenceSlope(double slope);
  vtkGetMacro(CoincidenceSlope, double);
  ///@}

protected:
  vtkTolerantTransparencyPass();
  ~vtkTolerantTransparencyPass() override;

  vitrine::CoincidenceTolerance GetTolerance() const;

  double CoincidenceSteps = 0.0;
  double CoincidenceSlope = 0.0;

private:
  vtkTolerantTransparencyPass(const vtkTolerantTransparencyPass&) = delete;
  void operator=(const vtkTolerantTransparencyPass&) = delete;

  void SetTolerance(const vitrine::CoincidenceTolerance& tolerance);
};

#endif
