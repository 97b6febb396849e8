/** The tolerance within which fragments coincide (Shaders/Coincidence.glsl). */
#ifndef VITRINE_TRANSPARENCY_COMMON_COINCIDENCE_TOLERANCE_H
#define VITRINE_TRANSPARENCY_COMMON_COINCIDENCE_TOLERANCE_H

#include <string>

class vtkShaderProgram;

namespace vitrine
{

struct FillShader;
struct RenderTarget;

struct CoincidenceTolerance
{
  double Steps = 0.0; ///< In units of 2^-24 of the window depth range.
  double Slope = 0.0; ///< Factor of the larger depth difference to a neighbouring pixel.

  bool IsOn() const { return this->Steps > 0.0 || this->Slope > 0.0; }

  /** Returns why the tolerance cannot be applied in `target`, or an empty string. */
  std::string FindProblemIn(const RenderTarget& target) const;

  /** Add the tolerance's define and slope code to `fill`. */
  void AddTo(FillShader& fill) const;

  void SetUniforms(vtkShaderProgram* program) const;
};

}
#endif
