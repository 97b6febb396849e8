#ifndef VITRINE_CORE_CULLING_BUFFER_S_BUFFER_IMAGE_H
#define VITRINE_CORE_CULLING_BUFFER_S_BUFFER_IMAGE_H

#include <vector>

namespace vitrine
{

class SBuffer;

/**
 * An s-buffer as a picture: the reversed depth of what covers the middle of each column of each line, 0 where nothing does. Of an s-buffer of samples, the least of those in the column.
 * @returns Columns() times Lines() depths, line after line from the bottom
 */
std::vector<float> DepthImage(const SBuffer& buffer);

}

#endif
