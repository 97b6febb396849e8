#include "Core/ranks/SentLists.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace vitrine
{
namespace
{

// The numbers of nodes of a sequence of pixels as runs of equal ones. The lowest bit of a run's number tells whether it
// has more than one pixel. The other bits are the nodes of each pixel. The number of a longer run is followed by how
// many pixels it has.
class RunWriter
{
public:
  explicit RunWriter(Message& message)
    : Writer(message)
  {
  }

  void Add(std::uint32_t count)
  {
    if (count != this->Count)
    {
      this->End();
      this->Count = count;
    }
    ++this->Length;
  }

  void End()
  {
    if (this->Length > 0)
    {
      const bool isLong = this->Length > 1;
      this->Writer.AddNumber(std::uint64_t(this->Count) << 1 | (isLong ? 1u : 0u));
      if (isLong)
      {
        this->Writer.AddNumber(this->Length);
      }
    }
    this->Length = 0;
  }

private:
  MessageWriter Writer;
  std::uint64_t Length = 0;
  std::uint32_t Count = 0;
};

// Nodes of a rank: those of a message, which may stand at any address, or the own ones.
struct Sender
{
  std::vector<std::uint32_t> Counts; // of the pixels in the order of messages
  const unsigned char* Texels = nullptr;
  const unsigned char* ThirdWords = nullptr;
  std::size_t Next = 0; // The first node of the next pixel.
};

constexpr std::size_t WordBytes = sizeof(std::uint32_t);

// Copies `count` nodes from node `first` on to node `at`.
void CopyNodes(
  const Sender& from, std::size_t first, std::size_t count, ListNodes& to, std::size_t at)
{
  const auto words = static_cast<std::size_t>(to.TexelWords);
  std::memcpy(
    &to.Texels[at * words], from.Texels + first * words * WordBytes, count * words * WordBytes);
  if (to.HasThirdWords)
  {
    std::memcpy(&to.ThirdWords[at], from.ThirdWords + first * WordBytes, count * WordBytes);
  }
}

// Returns false if the message is not one of `pixels` pixels.
bool TakeCounts(MessageReader& reader, std::size_t pixels, std::vector<std::uint32_t>& counts)
{
  while (counts.size() < pixels)
  {
    const std::uint64_t number = reader.TakeNumber();
    const std::uint64_t count = number >> 1;
    const std::uint64_t length = (number & 1u) != 0 ? reader.TakeNumber() : 1u;
    if (!reader.IsGood() || length == 0 || length > pixels - counts.size() ||
      count > std::numeric_limits<std::uint32_t>::max())
    {
      return false;
    }
    counts.insert(counts.end(), length, static_cast<std::uint32_t>(count));
  }
  return true;
}

// Finds the lists of a message, whose nodes are laid out as those of `like`. Sets the number of nodes. Returns false if
// it is not a message of `pixels` pixels.
bool Open(const Message& message, std::size_t pixels, const ListNodes& like, Sender& sender,
  std::uint64_t& nodes)
{
  nodes = 0;
  if (message.empty())
  {
    sender.Counts.assign(pixels, 0u);
    return true;
  }
  MessageReader reader(message);
  if (!TakeCounts(reader, pixels, sender.Counts))
  {
    return false;
  }
  for (const std::uint32_t count : sender.Counts)
  {
    nodes += count;
  }
  if (reader.Left() != nodes * like.Words() * WordBytes)
  {
    return false;
  }
  sender.Texels = message.data() + message.size() - reader.Left();
  sender.ThirdWords = sender.Texels + nodes * like.TexelWords * WordBytes;
  return true;
}

}

void ListNodes::Resize(std::size_t nodes)
{
  this->Texels.resize(nodes * this->TexelWords);
  this->ThirdWords.resize(this->HasThirdWords ? nodes : 0);
}

std::uint64_t CountNodes(const PixelLists& lists, const OwnedPixels& pixels)
{
  std::uint64_t nodes = 0;
  for (const std::uint32_t pixel : pixels)
  {
    nodes += lists.Counts[pixel];
  }
  return nodes;
}

void PackLists(const PixelLists& lists, const OwnedPixels& pixels, Message& message)
{
  const std::uint64_t nodes = CountNodes(lists, pixels);
  if (nodes == 0)
  {
    return;
  }
  RunWriter runs(message);
  for (const std::uint32_t pixel : pixels)
  {
    runs.Add(lists.Counts[pixel]);
  }
  runs.End();
  std::size_t at = message.size();
  message.resize(at + nodes * lists.Nodes.Words() * WordBytes);
  const auto copy = [&](const std::vector<std::uint32_t>& words, std::size_t wordsOfNode)
  {
    for (const std::uint32_t pixel : pixels)
    {
      if (lists.Counts[pixel] > 0)
      {
        const std::size_t size = lists.Counts[pixel] * wordsOfNode * WordBytes;
        std::memcpy(message.data() + at, &words[lists.Starts[pixel] * wordsOfNode], size);
        at += size;
      }
    }
  };
  copy(lists.Nodes.Texels, lists.Nodes.TexelWords);
  if (lists.Nodes.HasThirdWords)
  {
    copy(lists.Nodes.ThirdWords, 1);
  }
}

std::string JoinLists(const PixelLists& own, const OwnedPixels& pixels,
  const std::vector<Message>& received, std::uint64_t most, PixelLists& joined)
{
  std::vector<Sender> senders(received.size());
  std::uint64_t nodes = CountNodes(own, pixels);
  for (std::size_t i = 0; i < received.size(); ++i)
  {
    std::uint64_t sent = 0;
    if (!Open(received[i], pixels.size(), own.Nodes, senders[i], sent))
    {
      return "the fragments that another rank sent do not fit the picture";
    }
    nodes += sent;
  }
  Sender ownNodes;
  ownNodes.Texels = reinterpret_cast<const unsigned char*>(own.Nodes.Texels.data());
  ownNodes.ThirdWords = reinterpret_cast<const unsigned char*>(own.Nodes.ThirdWords.data());
  joined.Starts.assign(own.Starts.size(), 0u);
  joined.Counts.assign(own.Counts.size(), 0u);
  joined.Nodes.TexelWords = own.Nodes.TexelWords;
  joined.Nodes.HasThirdWords = own.Nodes.HasThirdWords;
  joined.Nodes.Resize(nodes);
  std::size_t at = 0;
  std::uint64_t longest = 0;
  for (std::size_t place = 0; place < pixels.size(); ++place)
  {
    const std::uint32_t pixel = pixels[place];
    const std::size_t start = at;
    const auto take = [&](const Sender& sender, std::size_t first, std::uint32_t count)
    {
      if (count > 0)
      {
        CopyNodes(sender, first, count, joined.Nodes, at);
        at += count;
      }
    };
    take(ownNodes, own.Starts[pixel], own.Counts[pixel]);
    for (Sender& sender : senders)
    {
      take(sender, sender.Next, sender.Counts[place]);
      sender.Next += sender.Counts[place];
    }
    joined.Starts[pixel] = static_cast<std::uint32_t>(start);
    joined.Counts[pixel] = static_cast<std::uint32_t>(at - start);
    longest = std::max<std::uint64_t>(longest, at - start);
  }
  return longest >= most ? "a pixel has " + std::to_string(longest) +
      " fragments of all ranks, and lists have fewer than " + std::to_string(most)
                         : std::string();
}

}
