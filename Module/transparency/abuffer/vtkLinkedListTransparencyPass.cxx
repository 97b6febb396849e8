#include "vtkLinkedListTransparencyPass.h"

#include "scene/PassTraits.h"
#include "shader/ShaderText.h"
#include "transparency/abuffer/LinkedListStore.h"
#include "transparency/common/FillShader.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLinkedListTransparencyPass);
vitrinePassTraitsMacro(vtkLinkedListTransparencyPass, vitrine::TranslucentTraits);

//------------------------------------------------------------------------------
vtkLinkedListTransparencyPass::~vtkLinkedListTransparencyPass()
{
  this->ReleaseBeforeDestruction();
}

//------------------------------------------------------------------------------
std::unique_ptr<vitrine::FragmentStore> vtkLinkedListTransparencyPass::MakeStore() const
{
  return std::make_unique<vitrine::LinkedListStore>();
}

//------------------------------------------------------------------------------
void vtkLinkedListTransparencyPass::GetStoringShader(vitrine::FillShader& fill) const
{
  fill.Declarations = vitrine::shaders::LinkedListFillDec;
  fill.Implementation = vitrine::shaders::LinkedListFillImpl;
}
