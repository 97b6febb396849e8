#include "culling/mappers/BlockDrawing.h"

#include "culling/mappers/BlockParts.h"

#include "vtkObjectFactory.h"

#include <functional>

namespace vitrine
{

vtkStandardNewMacro(BlockDrawing);

/** Draws the blocks. Hidden ones are made invisible while it draws. */
void BlockDrawing::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  const std::shared_ptr<const ShownParts> shown =
    this->Mapper()->GetDividedMapper()->ShownIn(renderer, actor);
  std::vector<bool*> switchedOff;
  if (shown)
  {
    const auto& blocks = static_cast<const Blocks&>(*shown->Division());
    auto part = blocks.ByAddress.begin();
    this->VisitBlocks(
      [&](vtkPolyData* data, bool& isVisible)
      {
        while (part != blocks.ByAddress.end() &&
          std::less<vtkPolyData*>()(blocks.Parts[*part].Data, data))
        {
          ++part;
        }
        if (isVisible && part != blocks.ByAddress.end() && blocks.Parts[*part].Data == data &&
          !shown->Shown()[*part])
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
