#include "transparency/abuffer/ErrorBounds.h"

#include "Shaders/SharedLayout.h"
#include "gl/MemoryBarriers.h"
#include "gl/RenderTarget.h"
#include "vtkShaderProgram.h"

#include <cstring>

namespace vitrine
{

std::string ErrorBounds::Begin(const RenderTarget& target)
{
  const std::string problem = "the driver has no memory for the bounds of errors";
  this->Row = 0;
  if (this->Largest.Handle() == 0 && !this->Largest.Allocate(sizeof(VitrineErrorBounds)))
  {
    return problem;
  }
  this->Largest.Clear();
  if (!this->KeepsPixels)
  {
    this->Pixels.Release();
    return {};
  }
  const std::int64_t bytes = std::int64_t(sizeof(float)) * target.Width * target.Height;
  if (this->Pixels.Bytes() != bytes && !this->Pixels.Allocate(bytes, GL_R32F))
  {
    return problem;
  }
  this->Pixels.Clear();
  this->Row = target.Width;
  return {};
}

void ErrorBounds::SetUniforms(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("toleratedBound"))
  {
    program->SetUniformf("toleratedBound", static_cast<float>(this->Tolerated));
    program->SetUniformi("boundsOfRow", this->Row);
    if (this->HasFixedBound())
    {
      program->SetUniformf("fixedBound", static_cast<float>(this->FixedBound));
    }
  }
}

VitrineErrorBounds ErrorBounds::Read() const
{
  VitrineErrorBounds bounds = {};
  BarrierBeforeReadingBuffers();
  this->Largest.Read(0, sizeof(bounds), &bounds);
  return bounds;
}

double ErrorBounds::ReadLargest() const
{
  const VitrineErrorBounds bounds = this->Read();
  float largest = 0.0f;
  std::memcpy(&largest, &bounds.Largest, sizeof(largest));
  return largest;
}

std::int64_t ErrorBounds::ReadHidden() const
{
  return this->Read().Hidden;
}

std::vector<float> ErrorBounds::ReadPixels() const
{
  std::vector<float> bounds;
  if (this->Row > 0)
  {
    bounds.resize(static_cast<std::size_t>(this->Pixels.Bytes()) / sizeof(float));
    BarrierBeforeReadingBuffers();
    this->Pixels.Read(0, this->Pixels.Bytes(), bounds.data());
  }
  return bounds;
}

void ErrorBounds::Release()
{
  this->Largest.Release();
  this->Pixels.Release();
  this->Row = 0;
}

ScopedErrorBounds::ScopedErrorBounds(const ErrorBounds& bounds)
  : Largest(VITRINE_BINDING_BOUNDS, bounds.LargestBuffer())
  , Pixels(VITRINE_IMAGE_BOUNDS, bounds.PixelsTexture(), GL_R32F)
{
}

}
