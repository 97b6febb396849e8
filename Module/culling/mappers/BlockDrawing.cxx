#include "culling/mappers/BlockDrawing.h"

#include "culling/mappers/BlockParts.h"

#include "vtkObjectFactory.h"
#include "vtkTexture.h"

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

/**
 * From VTK 9.4 on each mapper loads a texture that stands for blocks without one, and keeps its unit forever. So 32
 * mappers would take all units that most drivers have. Where no block has a texture the unit is freed.
 */
void BlockDrawing::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceStart(renderer, actor);
  for (const auto& block : this->VTKPolyDataToGLBatchElement)
  {
    if (block.second->Parent.Texture)
    {
      return;
    }
  }
  if (!this->Prototype)
  {
    this->Prototype = this->FindBlockTexturePrototype(actor);
  }
  if (this->Prototype)
  {
    this->Prototype->PostRender(renderer);
  }
}

/** VTK's texture for blocks without one, or null if there are no blocks, or before VTK 9.4. */
vtkTexture* BlockDrawing::FindBlockTexturePrototype(vtkActor* actor)
{
  if (this->VTKPolyDataToGLBatchElement.empty())
  {
    return nullptr;
  }
  // VTK tells the texture only where a block has one.
  vtkSmartPointer<vtkTexture>& texture =
    this->VTKPolyDataToGLBatchElement.begin()->second->Parent.Texture;
  texture = vtkSmartPointer<vtkTexture>::New();
  vtkTexture* found = nullptr;
  for (const texinfo& told : this->GetTextures(actor))
  {
    found = told.second == "blocktexture" ? told.first : found;
  }
  texture = nullptr;
  return found;
}

BlockDelegator::BlockDelegator()
{
  this->GLDelegate = BlockDrawing::New();
  this->Delegate = vtk::TakeSmartPointer(this->GLDelegate);
}

#endif

}
