/**
 * @class   vtkTolerantTransparencyPass
 * @brief   base class of the methods that have a tolerance for coincident fragments
 *
 * The fragments of mating faces have nearly the same depth, and rounding errors decide their order. Within a
 * tolerance, these fragments have no order. The tolerance of a fragment is computed as in glPolygonOffset:
 *
 *     CoincidenceSteps * 2^-24 + CoincidenceSlope * max(|dz/dx|, |dz/dy|)
 *
 * where z is the window depth, and x and y are in pixels. Two fragments of a pixel coincide if their depths differ by
 * at most the sum of their tolerances. Fragments that are joined by others between them coincide, too. Coincident
 * fragments are composited as the mean over all their orders, so neither their order nor noise below the tolerance is
 * visible. The result for two fragments is the same to the bit in any order, for more fragments up to the last bits
 * of a 32-bit float. If nothing coincides, the picture is the same as without a tolerance.
 *
 * If both settings are 0, there is no tolerance, and fragments of equal depth are ordered by their packed colour.
 *
 * Fragments also coincide if they are close for other reasons: the front and back faces of a part along its
 * silhouette, within about CoincidenceSlope / 2 pixels, and layers closer than the tolerance. At the rims of
 * impostors, whose shaders discard fragments, the slope depends on the driver. Fragments of alpha 0 coincide with no
 * others and join none. Opaque geometry has no tolerance: the depth test decides what it hides.
 *
 * With a tolerance, a fragment in an A-buffer takes 4 bytes more unless the target is multisampled. Targets of more
 * than 16 samples a pixel are refused. The picture of vtkTruthTransparencyPass depends on the tolerance as well.
 *
 * @code
 * vtkNew<vtkLinkedListTransparencyPass> method; // a vtkTolerantTransparencyPass
 * method->SetCoincidenceSteps(16.0);
 * method->SetCoincidenceSlope(0.5);
 * @endcode
 *
 * @warning
 * Subclassing outside of this module is not supported: pure virtual methods have private types.
 *
 * @sa
 * vtkABufferTransparencyPass vtkTruthTransparencyPass
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
  ///@{
  /**
   * Standard methods to identify and print the object.
   */
  vtkAbstractTypeMacro(vtkTolerantTransparencyPass, vtkTransparencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Get/Set the constant part of the tolerance, in steps of 2^-24 of the window depth, the smallest step of a 24-bit
   * depth buffer. The range is the finite numbers from 0 up, the default is 0. A value out of range is an error.
   */
  void SetCoincidenceSteps(double steps);
  vtkGetMacro(CoincidenceSteps, double);
  ///@}

  ///@{
  /**
   * Get/Set the slope-scaled part of the tolerance: the factor of the larger change of a fragment's depth to the next
   * pixel. The range is the finite numbers from 0 up, the default is 0. A value out of range is an error.
   */
  void SetCoincidenceSlope(double slope);
  vtkGetMacro(CoincidenceSlope, double);
  ///@}

protected:
  vtkTolerantTransparencyPass();
  ~vtkTolerantTransparencyPass() override;

  /**
   * Get both settings of the tolerance.
   */
  vitrine::CoincidenceTolerance GetTolerance() const;

  double CoincidenceSteps = 0.0;
  double CoincidenceSlope = 0.0;

private:
  vtkTolerantTransparencyPass(const vtkTolerantTransparencyPass&) = delete;
  void operator=(const vtkTolerantTransparencyPass&) = delete;

  void SetTolerance(const char* name, double& setting, double value);
};

#endif
