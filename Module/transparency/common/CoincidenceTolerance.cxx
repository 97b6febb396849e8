#include "transparency/common/CoincidenceTolerance.h"

#include "Shaders/SharedLayout.h"
#include "gl/RenderTarget.h"
#include "transparency/common/FillShader.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace vitrine
{

std::string CoincidenceTolerance::FindProblemIn(const RenderTarget& target) const
{
  return !this->IsOn() || target.Samples <= VITRINE_COINCIDENCE_SAMPLES
    ? std::string()
    : "a coincidence tolerance can be had with " + std::to_string(VITRINE_COINCIDENCE_SAMPLES) +
      " samples a pixel at most, and the target has " + std::to_string(target.Samples);
}

void CoincidenceTolerance::AddTo(FillShader& fill) const
{
  if (this->IsOn())
  {
    fill.Defines.emplace_back("VITRINE_COINCIDENCE");
    fill.UniformFlow = "vitrineTakeSlope(gl_FragCoord.z);";
  }
}

void CoincidenceTolerance::SetUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("vitrineTolerance"))
  {
    const float tolerance[2] = { static_cast<float>(std::ldexp(this->Steps, -24)),
      static_cast<float>(this->Slope) };
    program->SetUniform2f("vitrineTolerance", tolerance);
  }
}

}
