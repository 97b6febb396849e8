/**
 * Whether pictures can be given to VTK's readers.
 */
#ifndef VITRINE_IMAGE_CHECK_H
#define VITRINE_IMAGE_CHECK_H

#include <string>

namespace program
{

enum class ImageFormat
{
  PNG,
  JPEG
};

/**
 * Throw InputError unless the bytes are a whole PNG or JPEG; `name` tells which of the pictures in
 * the file `path`. VTK's readers crash on damaged PNGs and read beyond the end of truncated ones.
 */
ImageFormat CheckImage(const std::string& path, const std::string& name, const std::string& bytes);

}
#endif
