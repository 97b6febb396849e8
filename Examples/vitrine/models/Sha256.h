/**
 * Hashes of files.
 */
#ifndef VITRINE_SHA256_H
#define VITRINE_SHA256_H

#include <string>
#include <string_view>

namespace program
{

/** The SHA-256 of some bytes, as 64 hexadecimal digits in lower case. */
std::string Sha256Of(std::string_view bytes);

}
#endif
