/**
 * @file
 * Draws the blocks of a vtkCulledCompositePolyDataMapper, and hides the differences between versions of VTK. Up to VTK
 * 9.2 the mapper has helpers. From 9.3 on it has mappers of batches, and a delegator that gives these their blocks.
 */
#ifndef VITRINE_CULLING_MAPPERS_BLOCK_DRAWING_H
#define VITRINE_CULLING_MAPPERS_BLOCK_DRAWING_H

#include "gl/VitrineOpenGL.h"

#include "vtkCulledCompositePolyDataMapper.h"

#include "vtkCompositeDataDisplayAttributes.h"

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 3

#include "vtkCompositeMapperHelper2.h"

namespace vitrine
{

/** Returns true if a block has colours of its own, other than a plain one. */
inline bool HasColorsOfItsOwn(vtkCompositeDataDisplayAttributes*, vtkDataObject*)
{
  return false;
}

/** Draws blocks as VTK does, without the hidden ones. */
class BlockDrawing : public vtkCompositeMapperHelper2
{
public:
  static BlockDrawing* New();
  vtkTypeMacro(BlockDrawing, vtkCompositeMapperHelper2);

protected:
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

  vtkCulledCompositePolyDataMapper* Mapper() const
  {
    return static_cast<vtkCulledCompositePolyDataMapper*>(this->Parent);
  }

  /** Calls `visit` with each block's data and visibility, in ascending order of the data's addresses. */
  template <class Visit>
  void VisitBlocks(const Visit& visit)
  {
    for (const auto& block : this->Data)
    {
      visit(block.first, block.second->Visibility);
    }
  }
};

}

#else

#include "vtkOpenGLBatchedPolyDataMapper.h"
#include "vtkOpenGLCompositePolyDataMapperDelegator.h"

namespace vitrine
{

/** Returns true if a block has colours of its own, other than a plain one. */
inline bool HasColorsOfItsOwn(vtkCompositeDataDisplayAttributes* attributes, vtkDataObject* block)
{
  return attributes->HasBlockScalarVisibility(block) || attributes->HasBlockColorMode(block) ||
    attributes->HasBlockScalarMode(block) || attributes->HasBlockArrayAccessMode(block) ||
    attributes->HasBlockArrayComponent(block) || attributes->HasBlockArrayId(block) ||
    attributes->HasBlockArrayName(block) || attributes->HasBlockFieldDataTupleId(block) ||
    attributes->HasBlockLookupTable(block) || attributes->HasBlockTexture(block);
}

/** Draws blocks as VTK does, without the hidden ones. */
class BlockDrawing : public vtkOpenGLBatchedPolyDataMapper
{
public:
  static BlockDrawing* New();
  vtkTypeMacro(BlockDrawing, vtkOpenGLBatchedPolyDataMapper);

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

  vtkCulledCompositePolyDataMapper* Mapper() const
  {
    return static_cast<vtkCulledCompositePolyDataMapper*>(this->Parent);
  }

  /** Calls `visit` with each block's data and visibility, in ascending order of the data's addresses. */
  template <class Visit>
  void VisitBlocks(const Visit& visit)
  {
    for (const auto& block : this->VTKPolyDataToGLBatchElement)
    {
      visit(block.second->Parent.PolyData, block.second->Parent.Visibility);
    }
  }

private:
  vtkTexture* FindBlockTexturePrototype(vtkActor* actor);

  vtkTexture* Prototype = nullptr; ///< of the base class
};

/** Gives blocks to BlockDrawing. */
class BlockDelegator : public vtkOpenGLCompositePolyDataMapperDelegator
{
public:
  static BlockDelegator* New();
  vtkTypeMacro(BlockDelegator, vtkOpenGLCompositePolyDataMapperDelegator);

protected:
  BlockDelegator();
};

}

#endif
#endif
