#include "vtkLinkedListTransparencyPass.h"

#include "shader/ShaderText.h"
#include "transparency/abuffer/LinkedListStore.h"
#include "transparency/common/FillShader.h"
#include "transparency/common/MethodTable.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLinkedListTransparencyPass);
vitrineTransparencyMethodMacro(
  vtkLinkedListTransparencyPass, "linked-list", true, vitrine::TranslucentTraits);

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
