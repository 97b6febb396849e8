/**
 * The tolerance within which fragments coincide, as methods share it (Shaders/Coincidence.glsl).
 */
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
  double Steps = 0.0; ///< of 2^-24 of the window's depth
  double Slope = 0.0; ///< times the larger change of depth to a neighbouring pixel

  bool IsOn() const { return this->Steps > 0.0 || this->Slope > 0.0; }

  /** Why there is no such tolerance; empty if there is. */
  std::string FindProblem() const;

  /** Why it cannot be had in the target; empty if it can. */
  std::string FindProblemIn(const RenderTarget& target) const;

  /** What of the storing of a fragment it changes. */
  void AddTo(FillShader& fill) const;

  void SetUniforms(vtkShaderProgram* program) const;
};

}
#endif
