/**
 * Pictures on disk.
 */
#ifndef VITRINE_OUTPUT_PICTURE_H
#define VITRINE_OUTPUT_PICTURE_H

#include "methods/Stage.h"

#include <cstdint>
#include <string>
#include <vector>

namespace program
{

/** Throw InputError unless `path` names a PNG that could be written. */
void CheckPicturePath(const std::string& path);

/** 8-bit RGB, rows from the bottom, as the bytes of a PNG. */
std::string EncodePicture(const std::vector<std::uint8_t>& pixels, PictureSize size);

/** Write 8-bit RGB, rows from the bottom, as PNG; whole or not at all. */
void WritePicture(
  const std::string& path, const std::vector<std::uint8_t>& pixels, PictureSize size);

}
#endif
