/**
 * Where the lists of a packed buffer begin and end: prefix sums over the picture, in compute shaders.
 *
 * M. Harris, S. Sengupta, J. D. Owens: Parallel Prefix Sum (Scan) with CUDA, GPU Gems 3, 2007, for scans block by block;
 * the sums of VITRINE_SCAN_FANOUT values are one invocation's work, so that no invocation waits for another.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_PACKED_SCAN_H
#define VITRINE_TRANSPARENCY_ABUFFER_PACKED_SCAN_H

#include "Core/lists/PixelBlocks.h"
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
   * Give each pixel of `region` room for as many fragments as its head counted in the last fill, and none beyond
   * `capacity` nodes. Other pixels keep their counts. Returns an empty string, or why the driver cannot.
   */
  std::string PlaceCounted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    const ListHeads& heads, const PixelRegion& region, std::uint32_t capacity);

  /**
   * The same, for as many fragments as the image `longestLists` says of the pixel's block and its neighbours. Changes
   * the state of full-screen draws.
   */
  std::string PlacePredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout,
    ListHeads& heads, GLuint longestLists, const BlockRange& blocks, std::uint32_t capacity);

  /** Nodes for which the last call asked, those beyond the capacity included; 2^32 - 1 for more. Waits for the device. */
  std::uint32_t ReadTotal() const;

  /** Whether the driver could not compile one of the shaders. */
  bool HasFailed() const;

  std::int64_t Bytes() const { return this->Sums.Bytes(); }

  void Release();

private:
  struct Level
  {
    int Offset; // in the buffer, in values
    int Count;
  };

  std::string Prepare(const BlockRange& blocks);
  bool RunOverBlocks(ComputeProgram& program, vtkOpenGLRenderWindow* window,
    const ListLayout& layout, const PixelRegion& region, std::uint32_t capacity = 0);
  bool DrawPredicted(vtkOpenGLRenderWindow* window, const ListLayout& layout, ListHeads& heads,
    const BlockRange& blocks, std::uint32_t capacity);
  bool ScanSums(vtkOpenGLRenderWindow* window);
  bool RunOverLevel(ComputeProgram& program, vtkOpenGLRenderWindow* window, std::size_t level);

  std::vector<Level> Levels; // from the blocks' sums to that of all
  int OfBlocks = 0;          // in the buffer: a value of each block that is kept beside its sum
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
