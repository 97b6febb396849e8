#ifndef VITRINE_SCENE_PART_NUMBERS_H
#define VITRINE_SCENE_PART_NUMBERS_H

#include "vtkWeakPointer.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

class vtkDataObject;
class vtkProp;
class vtkRenderer;

namespace vitrine
{

/** A part as a user points at it: a prop, or a block of a prop whose mapper draws composite data. */
struct ShownPart
{
  vtkProp* Prop = nullptr; ///< null if there is no such part
  unsigned int Block = 0;  ///< flat index of the block, 0 for a prop that has no blocks
};

/** Returns the composite data that the prop's mapper draws, or null. */
vtkDataObject* CompositeDataOf(vtkProp* prop);

/**
 * Returns the composite data that the prop's mapper draws, or null if its blocks are no parts. Those of
 * vtkCompositePolyDataMapper before VTK 9.3 are none: it has mappers of its own for them, and no attributes.
 */
vtkDataObject* BlocksOf(vtkProp* prop);

/** Returns the number of nodes of composite data with its root and empty ones, or 1 for other data. */
std::uint32_t NumberOfNodes(vtkDataObject* data);

/**
 * The numbers of the parts of one renderer. A number is from 1 to MaximumNumber; 0 is no part.
 *
 * A prop keeps its numbers while it lives. If its composite data grow, it gets new ones. A number of a prop that is
 * gone is not given to another prop before all numbers have been used.
 */
class PartNumbers
{
public:
  /** Numbers fit in 31 bits, so that a word has room for the side of a face. */
  static constexpr std::uint32_t MaximumNumber = 0x7fffffffu;

  /** Returns the numbers of a renderer. They are gone with it. */
  static PartNumbers& Of(vtkRenderer* renderer);

  /**
   * Returns the number of the first part of a prop, which is an actor within an assembly or a prop of its own. The
   * numbers of its parts are this one + the flat index of the block.
   */
  std::uint32_t FirstOf(vtkProp* prop);

  /** Returns the part that has a number. Its prop is null for 0, for numbers not given, and if it is deleted. */
  ShownPart PartOf(std::uint32_t number) const;

private:
  /** The numbers of a prop. */
  struct Range
  {
    std::uint32_t First;
    std::uint32_t Count;
    vtkWeakPointer<vtkProp> Prop;
  };

  std::uint32_t Give(vtkProp* prop, std::uint32_t count);
  void ForgetDeleted();

  std::vector<Range> Ranges; ///< in ascending order of numbers
  std::unordered_map<vtkProp*, Range> Current;
  std::uint32_t Next = 1;
  std::size_t MostRanges =
    1024; ///< the number of ranges from which those of deleted props are removed
};

}

#endif
