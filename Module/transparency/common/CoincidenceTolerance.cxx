#include "transparency/common/CoincidenceTolerance.h"

#include "Shaders/SharedLayout.h"
#include "gl/RenderTarget.h"
#include "transparency/common/FillShader.h"
#include "vtkShaderProgram.h"

#include <cmath>

namespace vitrine
{
namespace
{

bool IsTolerance(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

}

std::string CoincidenceTolerance::FindProblem() const
{
  return IsTolerance(this->Steps) && IsTolerance(this->Slope)
    ? std::string()
    : "CoincidenceSteps and CoincidenceSlope are finite numbers of at least 0, not " +
      std::to_string(this->Steps) + " and " + std::to_string(this->Slope) + ".";
}

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
