#ifndef VITRINE_TESTING_FUZZ_BYTES_H
#define VITRINE_TESTING_FUZZ_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

/** Reads what a fuzzer made up; behind its end all is 0. */
class FuzzBytes
{
public:
  FuzzBytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Left(size)
  {
  }

  bool AreLeft() const { return this->Left > 0; }

  std::uint8_t Byte()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Data++;
  }

  /** A number below a limit, which is at most 65536. */
  unsigned Below(unsigned limit)
  {
    const unsigned low = this->Byte();
    return (limit > 256 ? low | unsigned{ this->Byte() } << 8 : low) % limit;
  }

  /**
   * Returns mostly one of a few dozen numbers, so that numbers are often equal. Else it returns any bit pattern,
   * including NaN and infinity.
   */
  float Number()
  {
    const std::uint8_t kind = this->Byte();
    if (kind < 224)
    {
      return static_cast<float>(kind % 32) / 4 - 4;
    }
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i)
    {
      bits = bits << 8 | this->Byte();
    }
    float number;
    std::memcpy(&number, &bits, sizeof(number));
    return number;
  }

private:
  const std::uint8_t* Data;
  std::size_t Left;
};

/** Ends the program, whereupon the fuzzer keeps the input. */
inline void Require(bool isTrue, const char* what)
{
  if (!isTrue)
  {
    std::fprintf(stderr, "%s\n", what);
    std::abort();
  }
}

#endif
