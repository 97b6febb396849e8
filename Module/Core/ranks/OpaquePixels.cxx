#include "Core/ranks/OpaquePixels.h"

#include <algorithm>
#include <iterator>

namespace vitrine
{
namespace
{

// The samples of pixels in the order of messages. A place is one of them.
class SamplePlaces
{
public:
  SamplePlaces(const OpaquePixels& picture, const OwnedPixels& pixels)
    : Samples(static_cast<std::size_t>(picture.Samples))
    , Numbers(pixels.data())
    , Places(pixels.size() * this->Samples)
  {
    if (this->HasSamples())
    {
      this->Expand(pixels, static_cast<std::uint32_t>(picture.Depths.size() / this->Samples));
    }
  }
  SamplePlaces(const SamplePlaces&) = delete;
  void operator=(const SamplePlaces&) = delete;

  std::size_t Count() const { return this->Places; }
  bool HasSamples() const { return this->Samples > 1; }

  // Returns where the picture has the depth of a place.
  std::size_t operator[](std::size_t place) const { return this->Numbers[place]; }

  bool AreOfOnePixel(std::size_t a, std::size_t b) const
  {
    return a / this->Samples == b / this->Samples;
  }

private:
  void Expand(const OwnedPixels& pixels, std::uint32_t picturePixels)
  {
    this->Expanded.reserve(this->Places);
    for (const std::uint32_t pixel : pixels)
    {
      for (std::size_t sample = 0; sample < this->Samples; ++sample)
      {
        this->Expanded.push_back(static_cast<std::uint32_t>(sample) * picturePixels + pixel);
      }
    }
    this->Numbers = this->Expanded.data();
  }

  std::size_t Samples;
  const std::uint32_t* Numbers;
  std::size_t Places;
  std::vector<std::uint32_t> Expanded;
};

// Runs of places: how many are left out and how many are taken, in turn, up to the last that is taken.
struct Runs
{
  std::vector<std::size_t> Lengths;
  std::vector<std::size_t> Taken; // the places
};

template <class IsTaken>
Runs RunsOf(std::size_t places, const IsTaken& isTaken)
{
  Runs runs;
  runs.Lengths.push_back(0);
  bool takes = false;
  for (std::size_t place = 0; place < places; ++place)
  {
    if (isTaken(place) != takes)
    {
      takes = !takes;
      runs.Lengths.push_back(0);
    }
    ++runs.Lengths.back();
    if (takes)
    {
      runs.Taken.push_back(place);
    }
  }
  return runs;
}

void AppendRuns(const Runs& runs, Message& message)
{
  MessageWriter writer(message);
  const std::size_t pairs = runs.Lengths.size() / 2; // A last run that is left out is not told.
  writer.AddNumber(pairs);
  for (std::size_t i = 0; i < 2 * pairs; ++i)
  {
    writer.AddNumber(runs.Lengths[i]);
  }
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

const std::uint32_t* ColorAt(const OpaquePixels& picture, std::size_t sample)
{
  return &picture.Colors[sample * picture.ColorWords];
}

// Compares alpha first, then blue, green and red, as bytes in a word and words of floats stand backwards.
bool IsLess(const std::uint32_t* a, const std::uint32_t* b, int words)
{
  return std::lexicographical_compare(std::make_reverse_iterator(a + words),
    std::make_reverse_iterator(a), std::make_reverse_iterator(b + words),
    std::make_reverse_iterator(b));
}

// Appends the colours of `count` samples. `placeOf` returns the place of the sample with this number. With several
// samples a pixel, runs tell the samples whose colour is not that of the sample before in their pixel. The first one of
// a pixel is not among them.
template <class PlaceOf>
void AppendColors(const OpaquePixels& picture, const SamplePlaces& places, std::size_t count,
  const PlaceOf& placeOf, Message& message)
{
  const auto follows = [&](std::size_t i)
  { return i > 0 && places.AreOfOnePixel(placeOf(i - 1), placeOf(i)); };
  const auto differs = [&](std::size_t i)
  {
    const std::uint32_t* const color = ColorAt(picture, places[placeOf(i)]);
    return !std::equal(color, color + picture.ColorWords, ColorAt(picture, places[placeOf(i - 1)]));
  };
  if (places.HasSamples())
  {
    AppendRuns(RunsOf(count, [&](std::size_t i) { return follows(i) && differs(i); }), message);
  }
  MessageWriter writer(message);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!places.HasSamples() || !follows(i) || differs(i))
    {
      writer.AddWords(ColorAt(picture, places[placeOf(i)]), picture.ColorWords);
    }
  }
}

// Reads what AppendColors() wrote to where `colorOf` has the colour of the sample with this number. Returns false if
// there is not so much.
template <class PlaceOf, class ColorOf>
bool TakeColorsOf(MessageReader& reader, int words, const SamplePlaces& places, std::size_t count,
  const PlaceOf& placeOf, const ColorOf& colorOf)
{
  std::vector<std::size_t> differing;
  if (places.HasSamples() && !TakeRuns(reader, count, differing))
  {
    return false;
  }
  auto next = differing.begin();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool differs = next != differing.end() && *next == i;
    next += differs ? 1 : 0;
    if (differs || !places.HasSamples() || i == 0 ||
      !places.AreOfOnePixel(placeOf(i - 1), placeOf(i)))
    {
      reader.TakeWords(colorOf(i), words);
    }
    else
    {
      std::copy_n(colorOf(i - 1), words, colorOf(i));
    }
  }
  return reader.IsGood();
}

}

void PackOpaque(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message)
{
  const SamplePlaces places(picture, pixels);
  const Runs drawn = RunsOf(places.Count(),
    [&](std::size_t place) { return picture.Depths[places[place]] < picture.Farthest; });
  if (drawn.Taken.empty())
  {
    return;
  }
  AppendRuns(drawn, message);
  MessageWriter writer(message);
  for (const std::size_t place : drawn.Taken)
  {
    writer.AddWords(&picture.Depths[places[place]], 1);
  }
  AppendColors(
    picture, places, drawn.Taken.size(), [&](std::size_t i) { return drawn.Taken[i]; }, message);
}

bool TakeNearer(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture,
  std::vector<std::uint32_t>& depths)
{
  const SamplePlaces places(picture, pixels);
  depths.assign(places.Count(), picture.Farthest);
  if (message.empty())
  {
    return true;
  }
  MessageReader reader(message);
  std::vector<std::size_t> drawn;
  if (!TakeRuns(reader, places.Count(), drawn))
  {
    return false;
  }
  const auto words = static_cast<std::size_t>(picture.ColorWords);
  const std::vector<std::uint32_t> nearer = TakeWordsOf(reader, drawn.size());
  std::vector<std::uint32_t> colors(drawn.size() * words);
  if (!places.HasSamples())
  {
    reader.TakeWords(colors.data(), colors.size());
  }
  else if (!TakeColorsOf(
             reader, picture.ColorWords, places, drawn.size(),
             [&](std::size_t i) { return drawn[i]; },
             [&](std::size_t i) { return colors.data() + i * words; }))
  {
    return false;
  }
  if (!IsEnded(reader))
  {
    return false;
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const std::size_t sample = places[drawn[i]];
    const auto first = colors.begin() + i * words;
    const auto own = picture.Colors.begin() + sample * words;
    depths[drawn[i]] = nearer[i];
    const bool isTaken = nearer[i] < picture.Depths[sample] ||
      (nearer[i] == picture.Depths[sample] && IsLess(&*own, &*first, picture.ColorWords));
    if (isTaken)
    {
      picture.Depths[sample] = nearer[i];
      std::copy_n(first, words, own);
    }
  }
  return true;
}

void PackDepths(const OpaquePixels& picture, const OwnedPixels& pixels,
  const std::vector<std::uint32_t>& known, Message& message)
{
  const SamplePlaces places(picture, pixels);
  const Runs nearer = RunsOf(places.Count(),
    [&](std::size_t place) { return picture.Depths[places[place]] < known[place]; });
  if (nearer.Taken.empty())
  {
    return;
  }
  AppendRuns(nearer, message);
  MessageWriter writer(message);
  for (const std::size_t place : nearer.Taken)
  {
    writer.AddWords(&picture.Depths[places[place]], 1);
  }
}

bool TakeDepths(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture)
{
  if (message.empty())
  {
    return true;
  }
  const SamplePlaces places(picture, pixels);
  MessageReader reader(message);
  std::vector<std::size_t> nearer;
  if (!TakeRuns(reader, places.Count(), nearer))
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
    picture.Depths[places[nearer[i]]] = depths[i];
  }
  return true;
}

void PackColors(const OpaquePixels& picture, const OwnedPixels& pixels, Message& message)
{
  const SamplePlaces places(picture, pixels);
  AppendColors(
    picture, places, places.Count(), [](std::size_t i) { return i; }, message);
}

bool TakeColors(const Message& message, const OwnedPixels& pixels, OpaquePixels& picture)
{
  const SamplePlaces places(picture, pixels);
  MessageReader reader(message);
  const auto words = static_cast<std::size_t>(picture.ColorWords);
  const bool hasColors = TakeColorsOf(
    reader, picture.ColorWords, places, places.Count(), [](std::size_t i) { return i; },
    [&](std::size_t place) { return picture.Colors.data() + places[place] * words; });
  return hasColors && IsEnded(reader);
}

}
