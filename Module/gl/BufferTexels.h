/** Writes items into a buffer texture. */
#ifndef VITRINE_GL_BUFFER_TEXELS_H
#define VITRINE_GL_BUFFER_TEXELS_H

#include "gl/Capabilities.h"
#include "gl/GLObjects.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * Writes `items`, each of which takes `texels` texels. A buffer that is too small is reallocated with a quarter more
 * than needed, so that it need not grow every frame. Returns an error message if there is no room, else an empty
 * string.
 * @param what  the items, as the error message names them
 */
template <class Item>
std::string WriteTexels(Buffer& buffer, const std::vector<Item>& items, GLenum format, int texels,
  const std::string& what)
{
  const std::int64_t count = static_cast<std::int64_t>(items.size());
  if (count * texels > LargestBufferTexture())
  {
    return what + " take " + std::to_string(count * texels) +
      " texels, and the driver's largest buffer texture has " +
      std::to_string(LargestBufferTexture());
  }
  const std::int64_t size = count * static_cast<std::int64_t>(sizeof(Item));
  const std::int64_t least = texels * std::int64_t{ 16 };
  if (buffer.Bytes() < std::max(size, least))
  {
    const std::int64_t roomy = std::min(
      size + size / 4, LargestBufferTexture() * (static_cast<std::int64_t>(sizeof(Item)) / texels));
    if (!buffer.Allocate(std::max(roomy, least), format))
    {
      return "the driver has no memory for " + std::to_string(size) + " bytes of " + what;
    }
  }
  if (size > 0)
  {
    buffer.Write(0, size, items.data());
  }
  return {};
}

/** Writes `items` as WriteTexels() does, unless the buffer holds the same, which `written` tells. */
template <class Item>
std::string WriteOtherTexels(Buffer& buffer, std::vector<Item>& written,
  const std::vector<Item>& items, GLenum format, int texels, const std::string& what)
{
  const bool isSame = buffer.Bytes() > 0 && items.size() == written.size() &&
    (items.empty() || std::memcmp(items.data(), written.data(), items.size() * sizeof(Item)) == 0);
  if (isSame)
  {
    return {};
  }
  written = items;
  const std::string problem = WriteTexels(buffer, written, format, texels, what);
  if (!problem.empty())
  {
    written.clear();
  }
  return problem;
}

}

#endif
