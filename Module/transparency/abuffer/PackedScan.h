/**
 * Finds where the lists of a packed buffer begin, by prefix sums in compute shaders.
 *
 * The scan goes block by block: M. Harris, S. Sengupta, J. D. Owens: Parallel Prefix Sum (Scan) with CUDA, GPU Gems 3,
 * 2007. Here one invocation adds VITRINE_SCAN_FANOUT values, so that no invocation waits for another.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_PACKED_SCAN_H
#define VITRINE_TRANSPARENCY_ABUFFER_PACKED_SCAN_H

#include "Core/lists/PixelBlocks.h"
#include "Shaders/SharedLayout.h"
#include "gl/ComputeProgram.h"
#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"
#include "transparency/abuffer/ListLayout.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class ListHeads;

class PackedScan
{
public:
  PackedScan();

  /**
   * Give each pixel of `region` room for the fragments that its head counted in the last fill. No room lies beyond
   * `capacity` nodes. Other pixels keep their counts. Returns an error message, empty on success.
   */
  std::string PlaceCounted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    const ListHeads& heads, const PixelRegion& region, std::uint32_t capacity);

  /**
   * Give each pixel of `blocks` room for the longest list of its block and the neighbouring blocks, as stored in the
   * image `longestLists`. No room lies beyond `capacity` nodes. Changes the state that full-screen draws set. Returns
   * an error message, empty on success.
   */
  std::string PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    ListHeads& heads, GLuint longestLists, const BlockRange& blocks, std::uint32_t capacity);

  /**
   * Set whether predicted rooms are a quarter and two fragments larger than the longest list that they are predicted
   * from. The default is that they are not.
   */
  void SetReserve(bool has) { this->HasReserve = has; }

  /**
   * Read the number of nodes that the last call asked for, including those beyond the capacity. It saturates at
   * UINT32_MAX. Waits for the device.
   */
  std::uint32_t ReadTotal() const;

  ///@{
  /** The buffer that holds that number on the device, and where it holds it, in bytes. */
  const Buffer& TotalBuffer() const { return this->Sums; }
  std::int64_t TotalOffset() const
  {
    return this->Levels.back().Offset * std::int64_t(sizeof(uint));
  }
  ///@}

  /** Returns true if the driver could not compile one of the shaders. */
  bool HasFailed() const;

  std::int64_t Bytes() const { return this->Sums.Bytes(); }

  void Release();

private:
  struct Level
  {
    int Offset; // Position in Sums, in values.
    int Count;
  };

  std::string Prepare(const BlockRange& blocks);
  bool RunOverBlocks(ComputeProgram& program, vtkOpenGLRenderWindow* window,
    const ListLayout& layout, const PixelRegion& region, std::uint32_t capacity = 0);
  bool DrawPredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout, ListHeads& heads,
    const BlockRange& blocks, std::uint32_t capacity);
  bool ScanSums(vtkOpenGLRenderWindow* window);
  bool RunOverLevel(ComputeProgram& program, vtkOpenGLRenderWindow* window, std::size_t level);

  std::vector<Level> Levels; // From the sums of the blocks to the sum of all.
  int OfBlocks = 0; // Position in Sums of each block's second value, the room of one pixel.
  bool HasReserve = false;
  Buffer Sums;
  ComputeProgram Counts;
  ComputeProgram Prediction;
  ComputeProgram Up;
  ComputeProgram Down;
  ComputeProgram Counted;
  ProgramCache Predicted;
  EmptyVertexArray VertexArray;
};

}
#endif
