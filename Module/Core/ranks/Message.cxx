#include "Core/ranks/Message.h"

#include <algorithm>
#include <cstring>

namespace vitrine
{
namespace
{

constexpr int BitsOfByte = 7;
constexpr unsigned char Continues = 1 << BitsOfByte;

}

void MessageWriter::AddNumber(std::uint64_t number)
{
  for (; number >= Continues; number >>= BitsOfByte)
  {
    this->Bytes.push_back(static_cast<unsigned char>(number) | Continues);
  }
  this->Bytes.push_back(static_cast<unsigned char>(number));
}

void MessageWriter::AddWords(const std::uint32_t* words, std::size_t count)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(words);
  this->Bytes.insert(this->Bytes.end(), bytes, bytes + count * sizeof(*words));
}

std::uint64_t MessageReader::TakeNumber()
{
  std::uint64_t number = 0;
  for (int shift = 0; this->At < this->Bytes.size() && shift < 64; shift += BitsOfByte)
  {
    const unsigned char byte = this->Bytes[this->At++];
    number |= std::uint64_t(byte & (Continues - 1)) << shift;
    if ((byte & Continues) == 0)
    {
      return number;
    }
  }
  this->Good = false;
  return 0;
}

void MessageReader::TakeWords(std::uint32_t* words, std::size_t count)
{
  if (count > this->Left() / sizeof(*words))
  {
    this->Good = false;
    std::fill_n(words, count, 0u);
    return;
  }
  std::memcpy(words, this->Bytes.data() + this->At, count * sizeof(*words));
  this->At += count * sizeof(*words);
}

}
