#include "Core/ranks/SentLists.h"

#include <algorithm>
#include <limits>

namespace vitrine
{
namespace
{

// The numbers of nodes of a sequence of pixels as runs of equal ones. The lowest bit of a run's number tells whether it
// has more than one pixel. The other bits are the nodes of each pixel. The number of a longer run is followed by how many
// pixels it has.
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

// Copies `count` nodes.
void CopyNodes(
  const ListNodes& from, std::size_t first, std::size_t count, ListNodes& to, std::size_t at)
{
  const auto words = static_cast<std::size_t>(from.TexelWords);
  std::copy_n(&from.Texels[first * words], count * words, &to.Texels[at * words]);
  if (from.HasThirdWords)
  {
    std::copy_n(&from.ThirdWords[first], count, &to.ThirdWords[at]);
  }
}

// The lists of a message, in the order of pixels.
struct Sender
{
  std::vector<std::uint32_t> Counts;
  ListNodes Nodes;
  std::size_t Next = 0; // The first node of the next pixel.
};

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

bool Unpack(const Message& message, std::size_t pixels, Sender& sender)
{
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
  std::uint64_t nodes = 0;
  for (const std::uint32_t count : sender.Counts)
  {
    nodes += count;
  }
  if (reader.Left() != nodes * sender.Nodes.Words() * sizeof(std::uint32_t))
  {
    return false;
  }
  sender.Nodes.Resize(nodes);
  reader.TakeWords(sender.Nodes.Texels.data(), sender.Nodes.Texels.size());
  reader.TakeWords(sender.Nodes.ThirdWords.data(), sender.Nodes.ThirdWords.size());
  return true;
}

}

void ListNodes::Resize(std::size_t nodes)
{
  this->Texels.resize(nodes * this->TexelWords);
  this->ThirdWords.resize(this->HasThirdWords ? nodes : 0);
}

std::uint64_t CountNodes(const PixelLists& lists, const std::vector<PixelRegion>& tiles)
{
  std::uint64_t nodes = 0;
  ForEachPixel(
    tiles, [&](int x, int y) { nodes += lists.Counts[std::size_t(y) * lists.Width + x]; });
  return nodes;
}

void PackLists(const PixelLists& lists, const std::vector<PixelRegion>& tiles, Message& message)
{
  const std::uint64_t nodes = CountNodes(lists, tiles);
  if (nodes == 0)
  {
    return;
  }
  RunWriter runs(message);
  ForEachPixel(
    tiles, [&](int x, int y) { runs.Add(lists.Counts[std::size_t(y) * lists.Width + x]); });
  runs.End();
  message.reserve(message.size() + nodes * lists.Nodes.Words() * sizeof(std::uint32_t));
  MessageWriter writer(message);
  const auto append = [&](const std::vector<std::uint32_t>& words, std::size_t wordsOfNode)
  {
    ForEachPixel(tiles,
      [&](int x, int y)
      {
        const std::size_t pixel = std::size_t(y) * lists.Width + x;
        writer.AddWords(
          words.data() + lists.Starts[pixel] * wordsOfNode, lists.Counts[pixel] * wordsOfNode);
      });
  };
  append(lists.Nodes.Texels, lists.Nodes.TexelWords);
  if (lists.Nodes.HasThirdWords)
  {
    append(lists.Nodes.ThirdWords, 1);
  }
}

std::string JoinLists(const PixelLists& own, const std::vector<PixelRegion>& tiles,
  const std::vector<Message>& received, std::uint64_t most, PixelLists& joined)
{
  std::size_t pixels = 0;
  for (const PixelRegion& tile : tiles)
  {
    pixels += std::size_t(tile.Width) * tile.Height;
  }
  std::vector<Sender> senders(received.size());
  std::size_t nodes = CountNodes(own, tiles);
  for (std::size_t i = 0; i < received.size(); ++i)
  {
    senders[i].Nodes.TexelWords = own.Nodes.TexelWords;
    senders[i].Nodes.HasThirdWords = own.Nodes.HasThirdWords;
    if (!Unpack(received[i], pixels, senders[i]))
    {
      return "the fragments that another rank sent do not fit the picture";
    }
    nodes += senders[i].Nodes.Texels.size() / own.Nodes.TexelWords;
  }
  joined.Width = own.Width;
  joined.Starts.assign(own.Starts.size(), 0u);
  joined.Counts.assign(own.Counts.size(), 0u);
  joined.Nodes.TexelWords = own.Nodes.TexelWords;
  joined.Nodes.HasThirdWords = own.Nodes.HasThirdWords;
  joined.Nodes.Resize(nodes);
  std::size_t at = 0;
  std::size_t place = 0; // of the pixel in the order of messages
  std::uint64_t longest = 0;
  ForEachPixel(tiles,
    [&](int x, int y)
    {
      const std::size_t pixel = std::size_t(y) * own.Width + x;
      const std::size_t start = at;
      const std::uint32_t ownCount = own.Counts[pixel];
      if (ownCount > 0)
      {
        CopyNodes(own.Nodes, own.Starts[pixel], ownCount, joined.Nodes, at);
        at += ownCount;
      }
      for (Sender& sender : senders)
      {
        const std::uint32_t count = sender.Counts[place];
        if (count > 0)
        {
          CopyNodes(sender.Nodes, sender.Next, count, joined.Nodes, at);
          sender.Next += count;
          at += count;
        }
      }
      joined.Starts[pixel] = static_cast<std::uint32_t>(start);
      joined.Counts[pixel] = static_cast<std::uint32_t>(at - start);
      longest = std::max<std::uint64_t>(longest, at - start);
      ++place;
    });
  return longest >= most ? "a pixel has " + std::to_string(longest) +
      " fragments of all ranks, and lists have fewer than " + std::to_string(most)
                         : std::string();
}

}
