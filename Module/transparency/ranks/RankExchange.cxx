#include "transparency/ranks/RankExchange.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>

namespace vitrine
{
namespace
{

constexpr int Tag = 0x5649;                                // of all messages
constexpr std::size_t LargestPiece = std::size_t(1) << 30; // MPI counts bytes by an int.

}

void RankExchange::SetController(vtkMultiProcessController* controller)
{
  this->Ranks = controller;
  this->WhyFailed.clear();
}

// In round r, ranks a and b meet if a + b is r modulo the number of ranks. So each pair meets once, a rank meets one
// other at a time, and of each pair the lower one sends first. Nothing can wait in a circle.
std::vector<Message> RankExchange::Exchange(std::vector<Message> messages)
{
  const int count = this->Count();
  const int rank = this->Rank();
  std::vector<Message> received(count);
  for (int round = 0; round < count; ++round)
  {
    const int other = (round - rank + count) % count;
    if (other == rank)
    {
      received[rank] = std::move(messages[rank]);
    }
    else if (rank < other)
    {
      this->Send(messages[other], other);
      received[other] = this->Receive(other);
    }
    else
    {
      received[other] = this->Receive(other);
      this->Send(messages[other], other);
    }
  }
  return received;
}

std::vector<Message> RankExchange::GatherAll(const Message& message)
{
  return this->Exchange(std::vector<Message>(this->Count(), message));
}

std::vector<std::vector<std::uint64_t>> RankExchange::GatherNumbers(
  const std::vector<std::uint64_t>& numbers)
{
  Message message;
  MessageWriter writer(message);
  for (const std::uint64_t number : numbers)
  {
    writer.AddNumber(number);
  }
  std::vector<std::vector<std::uint64_t>> all;
  for (const Message& told : this->GatherAll(message))
  {
    MessageReader reader(told);
    std::vector<std::uint64_t> taken(numbers.size());
    std::generate(taken.begin(), taken.end(), [&] { return reader.TakeNumber(); });
    all.push_back(std::move(taken));
  }
  return all;
}

std::vector<std::uint32_t> RankExchange::Sums(const std::vector<std::uint32_t>& words)
{
  Message message;
  MessageWriter(message).AddWords(words.data(), words.size());
  std::vector<std::uint32_t> sums(words.size());
  std::vector<std::uint32_t> taken(words.size());
  for (const Message& told : this->GatherAll(message))
  {
    MessageReader(told).TakeWords(taken.data(), taken.size());
    std::transform(sums.begin(), sums.end(), taken.begin(), sums.begin(), std::plus<>());
  }
  return sums;
}

std::uint64_t RankExchange::Least(std::uint64_t number)
{
  for (const std::vector<std::uint64_t>& told : this->GatherNumbers({ number }))
  {
    number = std::min(number, told[0]);
  }
  return number;
}

std::string RankExchange::Agree(const std::string& problem)
{
  const std::vector<Message> problems = this->GatherAll(Message(problem.begin(), problem.end()));
  std::vector<std::string> told;
  std::string all;
  for (std::size_t rank = 0; rank < problems.size(); ++rank)
  {
    const std::string text(problems[rank].begin(), problems[rank].end());
    if (!text.empty() && std::find(told.begin(), told.end(), text) == told.end())
    {
      told.push_back(text);
      all += (all.empty() ? "rank " : ", rank ") + std::to_string(rank) + ": " + text;
    }
  }
  return this->WhyFailed.empty() ? all : this->WhyFailed;
}

void RankExchange::Send(const Message& message, int rank)
{
  std::array<unsigned char, sizeof(std::uint64_t)> size{};
  const std::uint64_t count = message.size();
  std::memcpy(size.data(), &count, sizeof(count));
  if (this->Transfer(true, size.data(), size.size(), rank))
  {
    this->Transfer(true, const_cast<unsigned char*>(message.data()), message.size(), rank);
  }
  this->Bytes += static_cast<std::int64_t>(size.size() + message.size());
}

Message RankExchange::Receive(int rank)
{
  std::array<unsigned char, sizeof(std::uint64_t)> size{};
  std::uint64_t count = 0;
  Message message;
  if (this->Transfer(false, size.data(), size.size(), rank))
  {
    std::memcpy(&count, size.data(), sizeof(count));
    message.resize(count);
    if (!this->Transfer(false, message.data(), message.size(), rank))
    {
      message.clear();
    }
  }
  return message;
}

bool RankExchange::Transfer(bool isSending, unsigned char* bytes, std::size_t count, int rank)
{
  for (std::size_t at = 0; at < count && this->WhyFailed.empty(); at += LargestPiece)
  {
    const auto piece = static_cast<vtkIdType>(std::min(LargestPiece, count - at));
    const int done = isSending ? this->Ranks->Send(bytes + at, piece, rank, Tag)
                               : this->Ranks->Receive(bytes + at, piece, rank, Tag);
    if (!done)
    {
      this->WhyFailed = "rank " + std::to_string(rank) + " cannot be reached";
    }
  }
  return this->WhyFailed.empty();
}

}
