/**
 * Pictures in pages for browsers.
 */
#ifndef VITRINE_PAGE_PICTURE_H
#define VITRINE_PAGE_PICTURE_H

#include <string>

namespace program
{

/** A picture as a page holds it. */
struct PagePicture
{
  std::string Uri; ///< data:image/png;base64,...
  int Shrink = 1;  ///< each of its pixels is the mean of a square with so many on a side
};

/**
 * Read a PNG. One that is larger than a page can show is scaled down. Throws InputError if the file is missing, a link,
 * or not a complete PNG.
 */
PagePicture ReadPagePicture(const std::string& path);

}
#endif
