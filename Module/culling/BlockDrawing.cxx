#include "culling/BlockDrawing.h"

#include "culling/DividedMapper.h"

#include "vtkObjectFactory.h"

#include <functional>

namespace vitrine
{

vtkStandardNewMacro(BlockDrawing);

/** Hidden blocks are made invisible for as long as it takes to draw. Parts stand in the same order as blocks. */
void BlockDrawing::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  const std::shared_ptr<const ShownParts> shown =
    this->Mapper()->GetDividedMapper()->ShownIn(renderer, actor);
  std::vector<bool*> switchedOff;
  if (shown)
  {
    const std::vector<MapperPart>& parts = shown->Of()->Parts;
    std::size_t part = 0;
    this->VisitBlocks(
      [&](vtkPolyData* data, bool& isVisible)
      {
        while (part < parts.size() && std::less<vtkPolyData*>()(parts[part].Data, data))
        {
          ++part;
        }
        if (isVisible && part < parts.size() && parts[part].Data == data && !shown->Shown()[part])
        {
          isVisible = false;
          switchedOff.push_back(&isVisible);
        }
      });
  }
  this->Superclass::RenderPieceDraw(renderer, actor);
  for (bool* isVisible : switchedOff)
  {
    *isVisible = true;
  }
}

#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 3

vtkStandardNewMacro(BlockDelegator);

BlockDelegator::BlockDelegator()
{
  this->GLDelegate = BlockDrawing::New();
  this->Delegate = vtk::TakeSmartPointer(this->GLDelegate);
}

#endif

}
