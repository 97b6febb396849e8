/**
 * The heads of the linked lists: an image of each pixel's newest page and its number of fragments, and the framebuffers
 * in which it is cleared and filled.
 */
#ifndef VITRINE_LIST_HEADS_H
#define VITRINE_LIST_HEADS_H

#include "gl/GLObjects.h"
#include "gl/RenderTarget.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLState;

namespace vitrine
{

class ListHeads
{
public:
  /**
   * Make room for the target's pixels, in an attachment that shaders fetch from or an image for atomics. Changes the
   * framebuffer binding. Returns an empty string, or why the driver cannot.
   */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, bool framebufferFetch);

  /** Empty the lists of a region. Changes the framebuffer binding, scissor box and colour mask. */
  void Clear(vtkOpenGLState* state, const PixelRegion& region);

  /** Fragments of each pixel, row by row from the bottom; waits for the device. */
  std::vector<std::uint32_t> ReadCounts(vtkOpenGLState* state);

  /** To draw the lists' fragments into: it has the target's depth. */
  GLuint FillFramebuffer() { return this->FillTarget.Handle(); }

  const Image2D& Image() const { return this->Heads; }

  void Release();

private:
  void Attach(vtkOpenGLState* state, const RenderTarget& target);

  bool Fetched = false;
  int Width = 0;
  int Height = 0;
  Image2D Heads;
  Framebuffer FillTarget;  // opaque depth, and the heads where shaders fetch them
  Framebuffer ClearTarget; // the heads
};

}
#endif
