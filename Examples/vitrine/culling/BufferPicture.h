/**
 * An s-buffer to look at.
 */
#ifndef VITRINE_PROGRAM_BUFFER_PICTURE_H
#define VITRINE_PROGRAM_BUFFER_PICTURE_H

#include "methods/Stage.h"

#include <cstdint>
#include <vector>

class vtkImageData;

namespace program
{

/**
 * Returns a frame, 8-bit RGB from the bottom, with the image of vtkHierarchicalSBufferCuller::GetBufferImage() in the
 * same size to its right. The nearest depth is white, the farthest dark grey, and uncovered pixels are black. Without
 * an image the right side is black.
 */
std::vector<std::uint8_t> WithBuffer(
  const std::vector<std::uint8_t>& frame, PictureSize size, vtkImageData* buffer);

/** The size of such a picture. */
inline PictureSize SizeWithBuffer(PictureSize size)
{
  return { 2 * size.Width, size.Height };
}

}

#endif
