/**
 * Whole files in memory.
 */
#ifndef VITRINE_FILE_BYTES_H
#define VITRINE_FILE_BYTES_H

#include <cstddef>
#include <cstdint>
#include <string>

namespace program
{

/** Throw InputError unless `path` is a file with something in it that may be read. */
void CheckReadable(const std::string& path);

/** The bytes of a file. Throws InputError if it cannot be read. */
std::string ReadBytes(const std::string& path);

/** A 32-bit number, least significant byte first. `offset` + 4 must lie in `bytes`. */
std::uint32_t ReadUInt32(const std::string& bytes, std::size_t offset);

}
#endif
