#include "vtkPrefixSumTransparencyPass.h"

#include "shader/ShaderText.h"
#include "transparency/abuffer/PackedListStore.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPrefixSumTransparencyPass);
vitrinePassTraitsMacro(vtkPrefixSumTransparencyPass, vitrine::TranslucentTraits);

namespace
{
vtkTransparencyPass* NewPredicting()
{
  return vtkPrefixSumTransparencyPass::New();
}

vtkTransparencyPass* NewCounting()
{
  auto* const pass = vtkPrefixSumTransparencyPass::New();
  pass->PredictionOff();
  return pass;
}
}

namespace vitrine
{

vitrineMethodsOf(vtkPrefixSumTransparencyPass)
{
  return { { "prefix-sum-predicted", true, NewPredicting }, { "prefix-sum", true, NewCounting } };
}

}

//------------------------------------------------------------------------------
vtkPrefixSumTransparencyPass::~vtkPrefixSumTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
void vtkPrefixSumTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Prediction: " << (this->Prediction ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
std::unique_ptr<vitrine::FragmentStore> vtkPrefixSumTransparencyPass::MakeStore() const
{
  return std::make_unique<vitrine::PackedListStore>();
}

//------------------------------------------------------------------------------
void vtkPrefixSumTransparencyPass::GetStoringShader(vitrine::FillShader& fill) const
{
  fill.Declarations = vitrine::shaders::PackedListFillDec;
  fill.Implementation = vitrine::shaders::PackedListFillImpl;
}

//------------------------------------------------------------------------------
std::string vtkPrefixSumTransparencyPass::RenderFragments(
  const vtkRenderState* s, const vitrine::RenderTarget& target)
{
  static_cast<vitrine::PackedListStore&>(this->GetStore()).SetPrediction(this->Prediction);
  return this->Superclass::RenderFragments(s, target);
}
