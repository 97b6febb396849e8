#include "models/Sha256.h"

#include "Errors.h"

#include <openssl/evp.h>

#include <array>

namespace program
{

std::string Sha256Of(std::string_view bytes)
{
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int length = 0;
  if (!EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr))
  {
    throw RuntimeError("libcrypto cannot compute a SHA-256");
  }
  const char* const digits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i)
  {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

}
