/**
 * Files from the network.
 */
#ifndef VITRINE_DOWNLOAD_H
#define VITRINE_DOWNLOAD_H

#include <cstddef>
#include <functional>
#include <string>

namespace program
{

/**
 * Get a file of `bytes` bytes by http or https. `tell` is called with the number of bytes that are there. Throws
 * InputError if there is no such file, if it has another size, or if the network fails.
 */
std::string Download(
  const std::string& address, std::size_t bytes, const std::function<void(std::size_t)>& tell);

}
#endif
