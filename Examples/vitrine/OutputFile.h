/**
 * Files that are there whole or not at all.
 */
#ifndef VITRINE_OUTPUT_FILE_H
#define VITRINE_OUTPUT_FILE_H

#include <functional>
#include <string>

namespace program
{

/** Throw InputError if `path` is a folder, lies in none, or may not be written. */
void CheckWritable(const std::string& path);

/**
 * Have `write` make a file under a temporary name beside `path`, and give it its name when it is
 * whole. `write` returns false if it could not. Throws InputError, and leaves what was there
 * before.
 */
void WriteWholeFile(
  const std::string& path, const std::function<bool(const std::string& temporary)>& write);

/** Write text to a file. */
void WriteTextFile(const std::string& path, const std::string& text);

}
#endif
