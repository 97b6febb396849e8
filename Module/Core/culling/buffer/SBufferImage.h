#ifndef VITRINE_CORE_CULLING_BUFFER_S_BUFFER_IMAGE_H
#define VITRINE_CORE_CULLING_BUFFER_S_BUFFER_IMAGE_H

#include <vector>

namespace vitrine
{

class SBuffer;

/**
 * Returns an s-buffer as an image: the reversed depth of the cover at the centre of each column of each line, 0 where
 * nothing covers it. With sample depths it is the least depth of the column's samples.
 * @returns  Columns() times Lines() depths, line by line from the bottom
 */
std::vector<float> DepthImage(const SBuffer& buffer);

}

#endif
