#include "scene/papers/Textures.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace program
{

namespace
{
const int Side = 128;          // texels
const int Cells = 8;           // of the coarse noise; the fine one has twice as many
const double FineShare = 0.35; // of the sum of both
const double LeastOpacity = 0.04;
const double MostOpacity = 0.4;
const double Contrast = 2.2;

/** Random values at the corners of a square grid that repeats. */
class Lattice
{
public:
  Lattice(int cells, Random& random)
    : Cells(cells)
  {
    for (int i = 0; i < cells * cells; ++i)
    {
      this->Values.push_back(random.Unit());
    }
  }

  /** Between the corners, smoothly; u and v in [0, 1). */
  double At(double u, double v) const
  {
    const int column = static_cast<int>(u * this->Cells);
    const int row = static_cast<int>(v * this->Cells);
    const double x = Smooth(u * this->Cells - column);
    const double y = Smooth(v * this->Cells - row);
    const double low = Mix(this->Corner(column, row), this->Corner(column + 1, row), x);
    const double high = Mix(this->Corner(column, row + 1), this->Corner(column + 1, row + 1), x);
    return Mix(low, high, y);
  }

  static double Mix(double a, double b, double share) { return a + (b - a) * share; }

private:
  static double Smooth(double t) { return t * t * (3.0 - 2.0 * t); }

  double Corner(int column, int row) const
  {
    return this->Values[row % this->Cells * this->Cells + column % this->Cells];
  }

  int Cells;
  std::vector<double> Values;
};

class Clouds
{
public:
  explicit Clouds(Random& random)
    : Coarse(Cells, random)
    , Fine(2 * Cells, random)
  {
  }

  /** In [0, 1]. */
  double At(double u, double v) const
  {
    const double value = Lattice::Mix(this->Coarse.At(u, v), this->Fine.At(u, v), FineShare);
    return std::clamp(0.5 + Contrast * (value - 0.5), 0.0, 1.0);
  }

private:
  Lattice Coarse;
  Lattice Fine;
};

using Color = std::array<double, 3>;

/** Never grey: one component is high, one is low. */
Color RandomColor(Random& random)
{
  std::vector<double> components = { 0.15, random.Unit(), 0.9 };
  random.Shuffle(components);
  return { components[0], components[1], components[2] };
}

std::uint8_t ToByte(double unit)
{
  return static_cast<std::uint8_t>(unit * 255.0 + 0.5);
}

vtkSmartPointer<vtkImageData> MakePicture(Random& random)
{
  const Color dark = RandomColor(random);
  const Color bright = RandomColor(random);
  const Clouds hues(random);
  const Clouds opacities(random);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(Side, Side, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texel = static_cast<std::uint8_t*>(picture->GetScalarPointer());
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      const double u = (x + 0.5) / Side;
      const double v = (y + 0.5) / Side;
      for (int i = 0; i < 3; ++i)
      {
        *texel++ = ToByte(Lattice::Mix(dark[i], bright[i], hues.At(u, v)));
      }
      const double opacity = opacities.At(u, v);
      *texel++ = ToByte(Lattice::Mix(LeastOpacity, MostOpacity, opacity * opacity));
    }
  }
  return picture;
}
}

std::vector<vtkSmartPointer<vtkTexture>> MakeCloudTextures(int count, Random& random)
{
  std::vector<vtkSmartPointer<vtkTexture>> textures;
  for (int i = 0; i < count; ++i)
  {
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputDataObject(MakePicture(random));
    texture->SetColorModeToDirectScalars();
    texture->InterpolateOn();
    texture->RepeatOn();
    textures.push_back(texture);
  }
  return textures;
}

}
