/**
 * Finds the clusters that contain a lit pixel of a G-buffer.
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
   * Returns nonzero marks for the clusters that contain a lit pixel. It is empty if the driver cannot find them, as
   * without OpenGL 4.3. It draws over the viewport, without visible effect, so the state must be set for that.
   * @param unit     the texture unit of the G-buffer
   * @param samples  the number of samples of the G-buffer; 0 without multisampling
   */
  std::vector<std::uint8_t> Find(
    vtkOpenGLRenderWindow* window, const ViewGrid& grid, int unit, int samples);

  void Release();

  /** Returns the GPU memory in bytes. */
  std::int64_t Bytes() const { return this->Marks.Bytes(); }

private:
  ProgramCache Programs;
  EmptyVertexArray VertexArray;
  Buffer Marks;
};

}

#endif
