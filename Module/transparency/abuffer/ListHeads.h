/**
 * The heads of lists: an image of two words for each pixel, and the framebuffers in which it is cleared and filled.
 * Linked lists: the newest page, and the number of fragments. Packed lists: where the room begins, and fragments and
 * room in one word.
 */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_LIST_HEADS_H
#define VITRINE_TRANSPARENCY_ABUFFER_LIST_HEADS_H

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
   * Make room for the target's pixels, with width and height rounded up to a `multiple`, in an attachment that
   * shaders fetch from or an image for atomics. Changes the framebuffer binding. Returns an empty string, or why the driver cannot.
   */
  std::string Prepare(
    vtkOpenGLState* state, const RenderTarget& target, bool framebufferFetch, int multiple = 1);

  /**
   * Set the heads of a region to `first` and 0. Changes the framebuffer binding, scissor box and colour mask.
   */
  void Clear(vtkOpenGLState* state, const PixelRegion& region, GLuint first);

  /**
   * Set the state to draw a region's heads: of uvec2 in an attachment that shaders fetch from, else rows of first and
   * of second words in turn.
   */
  void BindForWriting(vtkOpenGLState* state, const PixelRegion& region);

  /** All heads, two words a pixel, row by row from the bottom; waits for the device. */
  std::vector<std::uint32_t> Read(vtkOpenGLState* state);

  /** To draw the lists' fragments into: it has the target's depth. */
  GLuint FillFramebuffer() { return this->FillTarget.Handle(); }

  /** Pixels in a row, those by which it was rounded up included. */
  int RowLength() const { return this->Width; }

  bool AreFetched() const { return this->Fetched; }

  const Image2D& Image() const { return this->Heads; }

  void Release();

private:
  void Attach(vtkOpenGLState* state, const RenderTarget& target);

  bool Fetched = false;
  int Width = 0;
  int Height = 0;
  Image2D Heads;
  Framebuffer FillTarget;  // opaque depth, and the heads where shaders fetch them
  Framebuffer WriteTarget; // the heads
};

}
#endif
