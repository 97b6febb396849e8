/**
 * Which clusters hold something of what a G-buffer shows to be lit.
 */
#ifndef VITRINE_LIGHTING_DEFERRED_MARKED_CLUSTERS_H
#define VITRINE_LIGHTING_DEFERRED_MARKED_CLUSTERS_H

#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class ViewGrid;

class MarkedClusters
{
public:
  /**
   * Nonzero for each cluster that does; empty where the driver cannot tell. The state is that of a draw that covers the viewport; it draws nothing
   * that could be seen.
   * @param unit     of texture, of the G-buffer
   * @param samples  of the G-buffer; 0 for one that is not multisampled
   */
  std::vector<std::uint8_t> Find(
    vtkOpenGLRenderWindow* window, const ViewGrid& grid, int unit, int samples);

  void Release();

  /** GPU memory. */
  std::int64_t Bytes() const { return this->Marks.Bytes(); }

private:
  ProgramCache Programs;
  EmptyVertexArray VertexArray;
  Buffer Marks;
};

}

#endif
