#include "vtkLinkedListTransparencyPass.h"

#include "transparency/FillShader.h"
#include "transparency/LinkedListStore.h"
#include "transparency/ShaderText.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLinkedListTransparencyPass);

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
