/**
 * The heads of the lists, two words for each pixel, and the framebuffers in which they are cleared and filled.
 *
 * A head of a linked list holds the newest page and the number of fragments. A head of a packed list holds the start of
 * the pixel's room, and one word with both fragments and room.
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
   * Make room for the target's pixels. Width and height are rounded up to a multiple of `multiple`. With
   * `framebufferFetch` the heads are an attachment that shaders fetch from, else an image for atomics. The first word
   * of an empty list is `emptyFirst` in an attachment, and 0 in an image for atomics. The second word is 0. All lists
   * of a new image are empty. Changes the framebuffer binding, and for a new image the scissor test, its box and the
   * colour mask. Returns an error message, empty on success.
   */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, bool framebufferFetch,
    GLuint emptyFirst, int multiple = 1);

  /** Empty the lists of `region`. Changes the framebuffer binding, the scissor test, its box and the colour mask. */
  void Clear(vtkOpenGLState* state, const PixelRegion& region);

  /**
   * Set the state for a draw that writes the heads of `region`. With framebuffer fetch a texel is a uvec2. Else rows of
   * first words and rows of second words alternate.
   */
  void BindForWriting(vtkOpenGLState* state, const PixelRegion& region);

  /** Read all heads, two words per pixel, by rows from the bottom. Waits for the device. */
  std::vector<std::uint32_t> Read(vtkOpenGLState* state);

  /** Write all heads, as Read() returns them. */
  void Write(vtkOpenGLState* state, const std::vector<std::uint32_t>& pairs);

  /** The framebuffer into which fragments are filled. It has the target's depth. */
  GLuint FillFramebuffer() { return this->FillTarget.Handle(); }

  /** Pixels in a row, including those added by rounding up. */
  int RowLength() const { return this->Width; }

  bool AreFetched() const { return this->Fetched; }

  const Image2D& Image() const { return this->Heads; }

  void Release();

private:
  void Attach(vtkOpenGLState* state, const RenderTarget& target);

  bool Fetched = false;
  int Width = 0;
  int Height = 0;
  GLuint EmptyFirst = 0;
  Image2D Heads;
  Framebuffer FillTarget;  // Opaque depth, and the heads if shaders fetch them.
  Framebuffer WriteTarget; // The heads alone.
};

}
#endif
