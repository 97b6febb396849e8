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
 * A frame, 8-bit RGB from the bottom, and to its right what vtkHierarchicalSBufferCuller::GetBufferImage() holds of it in the same
 * size: the nearest white, the farthest dark grey, black where nothing is covered. All is black without an image.
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
