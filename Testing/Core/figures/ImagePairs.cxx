#include "ImagePairs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace vitrine
{

namespace
{

// lowbias32 by C. Wellons.
std::uint32_t Mix(std::uint32_t value)
{
  value = (value ^ (value >> 16)) * 0x7feb352du;
  value = (value ^ (value >> 15)) * 0x846ca68bu;
  return value ^ (value >> 16);
}

int Noise(std::uint32_t seed, int x, int y, int c, std::uint32_t modulus)
{
  return static_cast<int>(Mix(Mix(Mix(seed) + x) + 4 * y + c) % modulus);
}

int Clamped(int value)
{
  return std::clamp(value, 0, 255);
}

int Ramp(int x, int y, int c)
{
  return Clamped(3 * x + 2 * y * c);
}

int Plates(int x, int y, int c)
{
  return (x / 8 + y / 8) % 2 * 150 + 20 + 30 * c;
}

// One of three primaries, in blocks of 4 x 5 pixels.
int Primary(int x, int y, int c)
{
  return (x / 4 + y / 5) % 3 == c ? 255 : 0;
}

// Lines of one pixel, steep and shallow, on grey.
int Lines(int x, int y, int contrast)
{
  return 128 + ((2 * x + 7 * y) % 41 < 2 || (9 * x - y + 1000) % 67 < 9 ? contrast : 0);
}

// The colour, times 255, of the plate at `depth`, the same for a whole column of 16 pixels.
int PlateColor(int depth, int x, int c)
{
  return Noise(11, x / 16, depth, c, 256);
}

constexpr int plateAlpha = 77; // of 255

// `layers` plates over black, those at two neighbouring depths swapped where `swapped` is the nearer.
int Stack(int layers, int swapped, int x, int c)
{
  int color = 0; // times 255
  for (int depth = layers - 1; depth >= 0; --depth)
  {
    const int shown = depth == swapped ? depth + 1 : depth == swapped + 1 ? depth - 1 : depth;
    color = (plateAlpha * 255 * PlateColor(shown, x, c) + (255 - plateAlpha) * color) / 255;
  }
  return (color + 127) / 255;
}

// What a weighted average makes of the stack: all plates have the mean colour.
int AveragedStack(int layers, int x, int c)
{
  int sum = 0;
  int transmittance = 255 * 255;
  for (int depth = 0; depth < layers; ++depth)
  {
    sum += PlateColor(depth, x, c);
    transmittance = transmittance * (255 - plateAlpha) / 255;
  }
  return (sum / layers * (255 * 255 - transmittance) + 255 * 255 / 2) / (255 * 255);
}

int LayersAt(int y)
{
  return 2 + y / 8;
}

// A shaded sphere of radius 60 about (64, 64), lit from the left above.
int Sphere(int x, int y, int c)
{
  const int dx = x - 64;
  const int dy = y - 64;
  const int z2 = 60 * 60 - dx * dx - dy * dy;
  if (z2 < 0)
  {
    return 230;
  }
  const int z = static_cast<int>(std::sqrt(static_cast<double>(z2)));
  const int light = std::max(0, (2 * z - dx - dy) * 255 / 148);
  return Clamped(30 + light * (3 - c) / 4);
}

// Two translucent discs that overlap, the red one in front of the blue one or behind it.
int Discs(int x, int y, int c, bool redInFront)
{
  const auto covers = [x, y](int centerX)
  { return (x - centerX) * (x - centerX) + (y - 90) * (y - 90) < 70 * 70; };
  const int red[3] = { 220, 40, 30 };
  const int blue[3] = { 20, 60, 210 };
  int color = 200 + 10 * c;
  const auto composite = [&](bool isCovered, const int(&disc)[3])
  { color = isCovered ? (disc[c] + color) / 2 : color; };
  composite(covers(redInFront ? 150 : 90), redInFront ? blue : red);
  composite(covers(redInFront ? 90 : 150), redInFront ? red : blue);
  return color;
}

const std::vector<ImagePair> pairs{
  // Noise, ramps, edges.
  { "noise", 40, 30, [](int x, int y, int c) { return Noise(1, x, y, c, 256); },
    [](int x, int y, int c)
    { return Clamped(Noise(1, x, y, c, 256) + Noise(2, x, y, c, 21) - 10); } },
  { "other-noise", 61, 59, [](int x, int y, int c) { return Noise(4, x, y, c, 256); },
    [](int x, int y, int c) { return Noise(5, x, y, c, 256); } },
  { "ramps-off-by-a-step", 64, 48, Ramp,
    [](int x, int y, int c) { return Clamped(Ramp(x, y, c) + Noise(3, x, y, c, 3) - 1); } },
  { "brighter-by-a-step", 30, 20, Plates, [](int x, int y, int c) { return Plates(x, y, c) + 1; } },
  { "darker-by-two-steps", 41, 23, Plates,
    [](int x, int y, int c) { return Plates(x, y, c) - 2; } },
  { "moved-edges", 51, 37, Plates, [](int x, int y, int c) { return Plates(x + 1, y, c); } },
  { "lines-moved", 101, 67, [](int x, int y, int) { return Lines(x, y, 100); },
    [](int x, int y, int) { return Lines(x + 1, y, 100); } },
  { "faint-lines-lost", 97, 71, [](int x, int y, int) { return Lines(x, y, 6); },
    [](int, int, int) { return 128; } },
  { "checkers-inverted", 64, 64, [](int x, int y, int) { return (x + y) % 2 * 255; },
    [](int x, int y, int) { return (x + y + 1) % 2 * 255; } },
  // Colours.
  { "primaries", 33, 47, Primary, [](int x, int y, int c) { return Primary(x + 4, y, c); } },
  { "green-for-blue", 17, 13, [](int, int, int c) { return c == 1 ? 255 : 0; },
    [](int, int, int c) { return c == 2 ? 255 : 0; } },
  { "white-for-black", 24, 24, [](int, int, int) { return 0; }, [](int, int, int) { return 255; } },
  { "saturated", 53, 29, [](int x, int y, int c) { return c == 0 ? 255
                                                     : c == 1    ? 4 * x
                                                                 : 8 * y; },
    [](int x, int y, int c) { return c == 0 ? 255
                                : c == 1    ? 4 * x + 40
                                            : 8 * y; } },
  { "faint-in-the-dark", 43, 61, [](int x, int y, int c) { return Noise(6, x, y, c, 6); },
    [](int x, int y, int c) { return Noise(6, x, y, c, 6) + (Noise(7, x, y, c, 9) == 0); } },
  // As methods err.
  { "stack-averaged", 160, 96, [](int x, int y, int c) { return Stack(LayersAt(y), -2, x, c); },
    [](int x, int y, int c) { return AveragedStack(LayersAt(y), x, c); } },
  { "stack-swapped-in-bands", 113, 89,
    [](int x, int y, int c) { return Stack(LayersAt(y), -2, x, c); },
    [](int x, int y, int c) { return Stack(LayersAt(y), y / 16 % 2 ? y / 16 - 1 : -2, x, c); } },
  { "sphere-in-few-steps", 131, 127, Sphere,
    [](int x, int y, int c) { return Sphere(x, y, c) / 12 * 12; } },
  { "sphere-without-a-pixel", 127, 131, Sphere,
    [](int x, int y, int c) { return x == 70 && y == 50 ? 255 : Sphere(x, y, c); } },
  { "discs-out-of-order", 240, 180, [](int x, int y, int c) { return Discs(x, y, c, true); },
    [](int x, int y, int c) { return Discs(x, y, c, false); } },
  // Sizes: smaller than the windows of the measures, wide, tall, one pixel.
  { "as-small-as-the-window", 11, 11, [](int x, int y, int c) { return Noise(1, x, y, c, 256); },
    [](int x, int y, int c)
    { return Clamped(Noise(1, x, y, c, 256) + Noise(2, x, y, c, 21) - 10); } },
  { "smaller-than-the-window", 5, 7, [](int x, int y, int c) { return Noise(1, x, y, c, 256); },
    [](int x, int y, int c)
    { return Clamped(Noise(1, x, y, c, 256) + Noise(2, x, y, c, 21) - 10); } },
  { "wide", 307, 9, Plates, [](int x, int y, int c) { return Plates(x + 1, y, c); } },
  { "tall", 2, 211, Ramp, [](int x, int y, int c) { return Ramp(x, y + 3, c); } },
  { "a-pixel", 1, 1, [](int, int, int c) { return 90 + 20 * c; },
    [](int, int, int c) { return 100 + 10 * c; } },
};

}

const std::vector<ImagePair>& ImagePairs()
{
  return pairs;
}

const ImagePair& FindImagePair(const std::string& name)
{
  const auto pair = std::find_if(pairs.begin(), pairs.end(),
    [&name](const ImagePair& candidate) { return candidate.Name == name; });
  if (pair == pairs.end())
  {
    throw std::out_of_range("no pair of pictures has the name " + name);
  }
  return *pair;
}

Image MakeImage(int width, int height, PixelFormula formula)
{
  Image image{ width, height, {} };
  image.Rgb.reserve(static_cast<std::size_t>(width) * height * 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        image.Rgb.push_back(static_cast<float>(formula(x, y, c) / 255.0));
      }
    }
  }
  return image;
}

}
