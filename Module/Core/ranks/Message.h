/** Bytes that ranks send each other, and numbers in them. */
#ifndef VITRINE_CORE_RANKS_MESSAGE_H
#define VITRINE_CORE_RANKS_MESSAGE_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace vitrine
{

using Message = std::vector<unsigned char>;

/** Returns the bytes of a value. */
template <class Value>
Message MessageOf(const Value& value)
{
  static_assert(std::is_trivially_copyable<Value>::value, "bytes are copied");
  Message message(sizeof(value));
  std::memcpy(message.data(), &value, sizeof(value));
  return message;
}

/** Takes the value of a message of MessageOf(). Returns false if it has another size. */
template <class Value>
bool TakeValue(const Message& message, Value& value)
{
  const bool fits = message.size() == sizeof(value);
  if (fits)
  {
    std::memcpy(&value, message.data(), sizeof(value));
  }
  return fits;
}

/** Appends numbers to a message. */
class MessageWriter
{
public:
  explicit MessageWriter(Message& message)
    : Bytes(message)
  {
  }

  /** Append a number by 7 bits a byte, the lowest first. The highest bit of a byte tells that another one follows. */
  void AddNumber(std::uint64_t number);

  /** Append words as they stand in memory. Ranks have one order of bytes. */
  void AddWords(const std::uint32_t* words, std::size_t count);

private:
  Message& Bytes;
};

/** Reads a message from its beginning. What lies beyond its end reads as 0. */
class MessageReader
{
public:
  explicit MessageReader(const Message& message)
    : Bytes(message)
  {
  }

  std::uint64_t TakeNumber();
  void TakeWords(std::uint32_t* words, std::size_t count);

  /** Returns how many bytes are left. */
  std::size_t Left() const { return this->Bytes.size() - this->At; }

  /** Returns false if more was read than there is. */
  bool IsGood() const { return this->Good; }

private:
  const Message& Bytes;
  std::size_t At = 0;
  bool Good = true;
};

}

#endif
