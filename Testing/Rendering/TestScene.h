/**
 * Small scenes with known answers, and pictures of them.
 */
#ifndef VITRINE_TEST_SCENE_H
#define VITRINE_TEST_SCENE_H

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkActor;
class vtkTransparencyPass;

using Rgba = std::array<double, 4>;

/** The bytes of a window, RGBA, row 0 at the bottom. */
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  Rgba At(int x, int y) const;
  bool operator==(const Picture& other) const { return this->Bytes == other.Bytes; }
};

Picture ReadPicture(vtkRenderWindow* window);

/** The largest difference of any colour channel, in steps of 1/255. */
int LargestDifference(const Picture& a, const Picture& b);

/** A headless window with one renderer, parallel projection over [-1, 1] in both directions, looking along -z. */
struct TestScene
{
  explicit TestScene(int width = 64, int height = 48, int multisamples = 0);

  /** A plate that fills the view at height z in (-1, 1), unlit. */
  vtkSmartPointer<vtkActor> AddPlate(double z, const Rgba& color);

  /** Any rectangle, unlit. */
  vtkSmartPointer<vtkActor> AddRectangle(
    double x0, double y0, double x1, double y1, double z, const Rgba& color);

  /** A lit sphere. */
  vtkSmartPointer<vtkActor> AddSphere(
    double x, double y, double z, double radius, const Rgba& color, int resolution = 16);

  /** Draw the translucent geometry by `pass`, the rest as VTK does. */
  void Use(vtkTransparencyPass* pass);

  Picture Render();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/** Plates composited front to back in double precision over a background; plates are given front to back. */
Rgba CompositePlates(const std::vector<Rgba>& plates, const Rgba& background);

/** Numbers from a seeded generator that is the same everywhere (splitmix64, public domain algorithm by S. Vigna). */
class TestRandom
{
public:
  explicit TestRandom(std::uint64_t seed)
    : State(seed)
  {
  }
  std::uint64_t Next();
  double Unit(); // [0, 1)

private:
  std::uint64_t State;
};

#endif
