#ifndef VITRINE_CORE_OCTREE_ITEM_BOXES_H
#define VITRINE_CORE_OCTREE_ITEM_BOXES_H

#include "Core/geometry/Box.h"

#include <cstddef>
#include <cstdint>

namespace vitrine
{

/**
 * Provides the bounding boxes of items, such as triangles or parts, which are numbered from 0. An octree keeps no boxes
 * and asks whenever it needs one, so boxes of triangles need not be stored.
 */
class ItemBoxes
{
public:
  virtual ~ItemBoxes() = default;

  virtual std::uint32_t Count() const = 0;

  /** Writes the boxes of `count` items. The box of an item with NaN must contain NaN. */
  virtual void Read(const std::uint32_t* items, std::size_t count, Box* boxes) const = 0;

  Box At(std::uint32_t item) const
  {
    Box box;
    this->Read(&item, 1, &box);
    return box;
  }
};

/** An item and its box. */
struct BoxedItem
{
  Box Extent;
  std::uint32_t Item;
};

/** Boxes in an array of the caller, which must outlive this object. */
class BoxArray : public ItemBoxes
{
public:
  BoxArray(const Box* boxes, std::uint32_t count)
    : Boxes(boxes)
    , Size(count)
  {
  }

  std::uint32_t Count() const override { return this->Size; }

  void Read(const std::uint32_t* items, std::size_t count, Box* boxes) const override
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      boxes[i] = this->Boxes[items[i]];
    }
  }

private:
  const Box* Boxes;
  std::uint32_t Size;
};

}

#endif
