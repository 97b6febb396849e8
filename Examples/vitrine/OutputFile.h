/**
 * Files that are there whole or not at all.
 */
#ifndef VITRINE_OUTPUT_FILE_H
#define VITRINE_OUTPUT_FILE_H

#include <string>
#include <string_view>

namespace program
{

/** Throw InputError if `path` is empty or a folder, lies in none, or may not be written. */
void CheckWritable(const std::string& path);

/** Whether two paths lead to the same place. */
bool AreSame(const std::string& path, const std::string& other);

/** Make a folder, in one that is there, unless it is there already. Throws InputError. */
void MakeFolder(const std::string& path);

/** Whether WriteWholeFile() replaces `path`, as often as one likes: it is neither a device nor a pipe. */
bool CanBeReplaced(const std::string& path);

/**
 * Write a file under a temporary name beside `path`, or beside the file that the link `path` leads to, and give
 * it its name when it is whole. Devices and pipes are written to as they are. Throws InputError, and leaves what
 * was there before.
 */
void WriteWholeFile(const std::string& path, std::string_view bytes);

}
#endif
