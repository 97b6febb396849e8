#include "vtkStencilMaskTransparencyPass.h"

#include "Core/lists/StencilMasks.h"
#include "gl/BackdropCopy.h"
#include "gl/Capabilities.h"
#include "gl/DeviceTraits.h"
#include "gl/RenderTarget.h"
#include "gl/ScopedState.h"
#include "gl/StageTimer.h"
#include "scene/Settings.h"
#include "shader/ShaderText.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "transparency/stencil/MaskResolver.h"
#include "transparency/stencil/MaskTarget.h"
#include "transparency/stencil/PixelSizedPrimitives.h"
#include "transparency/stencil/ViewDepth.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkStencilMaskTransparencyPass);
vitrineTransparencyMethodMacro(
  vtkStencilMaskTransparencyPass, "stencil-mask-8", false, vitrine::TranslucentTraitsOfOwnTarget);

namespace
{

const vitrine::NumberChoice LayersOfMasks{ { 4, 8, 9, 16 } };
const vitrine::EnumNames StoragesOfMasks{ { "full float", "half float" } };

}

struct vtkStencilMaskTransparencyPass::Internals
{
  vitrine::MaskGroup Group;
  vitrine::MaskTarget Masks;
  vitrine::BackdropCopy Backdrop;
  vitrine::MaskResolver Resolver;
  vitrine::ViewDepth Depth; // Depth conversion of the current frame.
  vitrine::MaskRepair Repair;
  int FirstPixel[2] = { 0, 0 };
};

//------------------------------------------------------------------------------
vtkStencilMaskTransparencyPass::vtkStencilMaskTransparencyPass()
  : Private(new Internals)
{
}

//------------------------------------------------------------------------------
vtkStencilMaskTransparencyPass::~vtkStencilMaskTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "DepthStorage: " << this->GetDepthStorageAsString() << "\n";
  os << indent << "Filter: " << (this->Filter ? "On" : "Off") << "\n";
  os << indent << "ShowMarks: " << (this->ShowMarks ? "On" : "Off") << "\n";
  os << indent << "DepthLimit: " << this->DepthLimit << "\n";
  os << indent << "ColorLimit: " << this->ColorLimit << "\n";
}

//------------------------------------------------------------------------------
const char* vtkStencilMaskTransparencyPass::GetMethodName()
{
  switch (this->NumberOfLayers)
  {
    case 4:
      return "stencil-mask-4";
    case 8:
      return "stencil-mask-8";
    case 9:
      return "stencil-mask-9";
    default:
      return "stencil-mask-16";
  }
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::SetNumberOfLayers(int layers)
{
  if (vitrine::SetInRange(this, "NumberOfLayers", this->NumberOfLayers, layers, LayersOfMasks))
  {
    this->ShaderStage.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::SetDepthStorage(int storage)
{
  vitrine::SetInRange(this, "DepthStorage", this->DepthStorage, storage, StoragesOfMasks);
}

//------------------------------------------------------------------------------
const char* vtkStencilMaskTransparencyPass::GetDepthStorageAsString()
{
  return StoragesOfMasks[this->DepthStorage];
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::SetDepthLimit(double limit)
{
  vitrine::SetInRange(this, "DepthLimit", this->DepthLimit, limit, vitrine::NotNegative);
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::SetColorLimit(double limit)
{
  vitrine::SetInRange(this, "ColorLimit", this->ColorLimit, limit, vitrine::NotNegative);
}

//------------------------------------------------------------------------------
std::string vtkStencilMaskTransparencyPass::FindMissingFeature(vtkOpenGLRenderWindow*)
{
  return vitrine::MissingFeatures(3, 2, {});
}

//------------------------------------------------------------------------------
vitrine::FillShader vtkStencilMaskTransparencyPass::GetFillShader()
{
  vitrine::FillShader fill;
  fill.Defines.push_back(vitrine::GroupDefine(this->Private->Group));
  fill.Defines.emplace_back(vitrine::LeastAlphaDefine(/* halfFloat= */ false));
  fill.Declarations = vitrine::shaders::StencilMaskFillDec;
  fill.Implementation = vitrine::shaders::StencilFillImpl;
  fill.Inputs = { "VITRINE_TO_CENTRE", "vec2(VITRINE_GROUP)", "vitrineCentreDepth" };
  if (this->GetDeviceTraits().Software)
  {
    // With anisotropic filters, which textures have by default, llvmpipe and softpipe ignore gradients.
    fill.Inputs->TextureGrad = "vitrineTextureGrad";
  }
  return fill;
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::SetFillParameters(vtkShaderProgram* program)
{
  Internals& in = *this->Private;
  program->SetUniform2i("vitrineFirstPixel", in.FirstPixel);
  program->SetUniform3f("vitrineViewDepth", in.Depth.Coefficients);
  // Props may have changed this state, by which fragments are stored.
  vtkOpenGLState* state = this->GetWindow()->GetState();
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
}

//------------------------------------------------------------------------------
std::string vtkStencilMaskTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (in.Resolver.HasFailed())
  {
    return vitrine::ProgramFailure;
  }
  std::string problem = this->PrepareFrame(s, target);
  if (problem.empty())
  {
    problem = this->Fill(s, target);
  }
  if (problem.empty())
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "resolve");
    if (!in.Resolver.Resolve(
          this->GetWindow(), in.Group, in.Masks, in.Backdrop.Image(), target, in.Repair))
    {
      problem = vitrine::ProgramFailure;
    }
  }
  this->Bytes =
    in.Masks.Bytes() + in.Resolver.Bytes() + in.Backdrop.Image().Bytes() + this->GetSharedBytes();
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkStencilMaskTransparencyPass::PrepareFrame(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  Internals& in = *this->Private;
  if (target.Samples > 0)
  {
    return "the target has " + std::to_string(target.Samples) +
      " samples a pixel, and stencil masks take one sample";
  }
  std::string problem = vitrine::FindPixelSizedPrimitives(s);
  if (!problem.empty())
  {
    return problem;
  }
  vtkOpenGLState* state = this->GetWindow()->GetState();
  in.Group = *vitrine::FindMaskGroup(this->NumberOfLayers);
  in.Resolver.SetAdditive(this->HasAdditiveFragments());
  in.Depth = vitrine::ViewDepth(s->GetRenderer()->GetActiveCamera());
  in.Repair.Shown = this->ShowMarks ? vitrine::MaskRepair::MARKS
    : this->Filter                  ? vitrine::MaskRepair::REPAIRED
                                    : vitrine::MaskRepair::AS_IT_IS;
  in.Repair.DepthLimit = static_cast<float>(this->DepthLimit);
  in.Repair.ColorLimit = static_cast<float>(this->ColorLimit);
  in.FirstPixel[0] = target.Region.X;
  in.FirstPixel[1] = target.Region.Y;
  problem = in.Backdrop.Copy(state, target);
  if (problem.empty())
  {
    problem = in.Masks.Prepare(state, target, in.Group, this->DepthStorage == HALF_FLOAT);
  }
  if (problem.empty())
  {
    problem = in.Resolver.Prepare(state, target, in.Repair);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkStencilMaskTransparencyPass::Fill(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  vtkOpenGLState* state = this->GetWindow()->GetState();
  const vitrine::ScopedStencil stencil(state);
  this->Private->Masks.BeginFill(state, target);
  std::string problem;
  {
    const vitrine::StageTimer::Section section(this->GetStageTimer(), "fill");
    problem = this->DrawTranslucentGeometry(s, target.Region);
  }
  this->TakeCounts(this->Private->Masks.Count(state));
  return problem;
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::ReleaseMethodResources()
{
  Internals& in = *this->Private;
  in.Masks.Release();
  in.Backdrop.Release();
  in.Resolver.Release();
}

//------------------------------------------------------------------------------
void vtkStencilMaskTransparencyPass::ForgetMethodResources()
{
  this->Private.reset(new Internals);
}
