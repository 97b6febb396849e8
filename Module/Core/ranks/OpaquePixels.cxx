#include "Core/ranks/OpaquePixels.h"

#include <algorithm>

namespace vitrine
{
namespace
{

// Appends runs of places: how many are left out and how many are taken, in turn, up to the last that is taken. Returns
// the taken ones. Without any nothing is appended.
template <class IsTaken>
std::vector<std::size_t> AppendRuns(std::size_t places, const IsTaken& isTaken, Message& message)
{
  std::vector<std::size_t> taken;
  std::vector<std::size_t> runs(1, 0);
  bool takes = false;
  for (std::size_t place = 0; place < places; ++place)
  {
    if (isTaken(place) != takes)
    {
      takes = !takes;
      runs.push_back(0);
    }
    ++runs.back();
    if (takes)
    {
      taken.push_back(place);
    }
  }
  if (taken.empty())
  {
    return taken;
  }
  MessageWriter writer(message);
  const std::size_t pairs = runs.size() / 2; // A last run that is left out is not told.
  writer.AddNumber(pairs);
  for (std::size_t i = 0; i < 2 * pairs; ++i)
  {
    writer.AddNumber(runs[i]);
  }
  return taken;
}

// Reads what AppendRuns() wrote. Returns false if there are not so many places.
bool TakeRuns(MessageReader& reader, std::size_t places, std::vector<std::size_t>& taken)
{
  const std::uint64_t pairs = reader.TakeNumber();
  std::size_t place = 0;
  for (std::uint64_t i = 0; i < pairs; ++i)
  {
    const std::uint64_t left = reader.TakeNumber();
    const std::uint64_t length = reader.TakeNumber();
    if (!reader.IsGood() || left > places - place || length > places - place - left)
    {
      return false;
    }
    place += left;
    for (std::uint64_t n = 0; n < length; ++n)
    {
      taken.push_back(place++);
    }
  }
  return reader.IsGood();
}

// Reads one word of each taken place.
std::vector<std::uint32_t> TakeWordsOf(MessageReader& reader, std::size_t count)
{
  if (count > reader.Left() / sizeof(std::uint32_t))
  {
    count = reader.Left() / sizeof(std::uint32_t) + 1; // which fails
  }
  std::vector<std::uint32_t> words(count);
  reader.TakeWords(words.data(), words.size());
  return words;
}

bool IsEnded(const MessageReader& reader)
{
  return reader.IsGood() && reader.Left() == 0;
}

}

void PackOpaque(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message)
{
  const std::vector<std::size_t> drawn = AppendRuns(
    pixels.size(),
    [&](std::size_t place) { return picture.Depths[pixels[place]] < picture.Farthest; }, message);
  MessageWriter writer(message);
  for (const std::size_t place : drawn)
  {
    writer.AddWords(&picture.Depths[pixels[place]], 1);
  }
  for (const std::size_t place : drawn)
  {
    writer.AddWords(
      &picture.Colors[std::size_t(pixels[place]) * picture.ColorWords], picture.ColorWords);
  }
}

bool TakeNearer(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture,
  std::vector<std::uint32_t>& depths)
{
  depths.assign(pixels.size(), picture.Farthest);
  if (message.empty())
  {
    return true;
  }
  MessageReader reader(message);
  std::vector<std::size_t> drawn;
  if (!TakeRuns(reader, pixels.size(), drawn))
  {
    return false;
  }
  const auto words = static_cast<std::size_t>(picture.ColorWords);
  const std::vector<std::uint32_t> nearer = TakeWordsOf(reader, drawn.size());
  const std::vector<std::uint32_t> colors = TakeWordsOf(reader, drawn.size() * words);
  if (!IsEnded(reader))
  {
    return false;
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const std::size_t pixel = pixels[drawn[i]];
    const auto first = colors.begin() + i * words;
    const auto own = picture.Colors.begin() + pixel * words;
    depths[drawn[i]] = nearer[i];
    const bool isTaken = nearer[i] < picture.Depths[pixel] ||
      (nearer[i] == picture.Depths[pixel] &&
        std::lexicographical_compare(own, own + words, first, first + words));
    if (isTaken)
    {
      picture.Depths[pixel] = nearer[i];
      std::copy_n(first, words, own);
    }
  }
  return true;
}

void PackDepths(const OpaquePixels& picture, const OwnedPixels& pixels,
  const std::vector<std::uint32_t>& known, Message& message)
{
  const std::vector<std::size_t> nearer = AppendRuns(
    pixels.size(), [&](std::size_t place) { return picture.Depths[pixels[place]] < known[place]; },
    message);
  MessageWriter writer(message);
  for (const std::size_t place : nearer)
  {
    writer.AddWords(&picture.Depths[pixels[place]], 1);
  }
}

bool TakeDepths(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture)
{
  if (message.empty())
  {
    return true;
  }
  MessageReader reader(message);
  std::vector<std::size_t> nearer;
  if (!TakeRuns(reader, pixels.size(), nearer))
  {
    return false;
  }
  const std::vector<std::uint32_t> depths = TakeWordsOf(reader, nearer.size());
  if (!IsEnded(reader))
  {
    return false;
  }
  for (std::size_t i = 0; i < nearer.size(); ++i)
  {
    picture.Depths[pixels[nearer[i]]] = depths[i];
  }
  return true;
}

void PackColors(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message)
{
  MessageWriter writer(message);
  for (const std::size_t pixel : pixels)
  {
    writer.AddWords(&picture.Colors[pixel * picture.ColorWords], picture.ColorWords);
  }
}

bool TakeColors(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture)
{
  MessageReader reader(message);
  for (const std::size_t pixel : pixels)
  {
    reader.TakeWords(&picture.Colors[pixel * picture.ColorWords], picture.ColorWords);
  }
  return IsEnded(reader);
}

}
