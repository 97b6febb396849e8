#include "vtkCulledCompositePolyDataMapper.h"

#include "culling/mappers/BlockDrawing.h"
#include "culling/mappers/BlockParts.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCulledCompositePolyDataMapper);

vtkCulledCompositePolyDataMapper::vtkCulledCompositePolyDataMapper()
  : Blocks(std::make_unique<vitrine::BlockParts>(this))
{
}

vtkCulledCompositePolyDataMapper::~vtkCulledCompositePolyDataMapper() = default;

vitrine::DividedMapper* vtkCulledCompositePolyDataMapper::GetDividedMapper()
{
  return this->Blocks.get();
}

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3
vtkCompositeMapperHelper2* vtkCulledCompositePolyDataMapper::CreateHelper()
{
  return vitrine::BlockDrawing::New();
}
#else
vtkCompositePolyDataMapperDelegator* vtkCulledCompositePolyDataMapper::CreateADelegator()
{
  return vitrine::BlockDelegator::New();
}
#endif
