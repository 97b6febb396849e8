/**
 * Small scenes with known answers, and pictures of them.
 */
#ifndef VITRINE_TEST_SCENE_H
#define VITRINE_TEST_SCENE_H

#include "TestPicture.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkActor;
class vtkAlgorithm;
class vtkRenderPass;

/** What stands behind everything: colours that 8 bits hold exactly, and none of it opaque. */
constexpr Rgba TestBackground = { 0.2, 0.6, 0.4, 0.0 };

/** A headless window with one renderer, parallel projection over [-1, 1] in both directions, looking along -z. */
struct TestScene
{
  explicit TestScene(int width = 64, int height = 48, int multisamples = 0);

  /** A plate that fills the view at height z in (-1, 1), unlit. */
  vtkSmartPointer<vtkActor> AddPlate(double z, const Rgba& color);

  /**
   * Plates that fill the view, front to back, evenly between z = 0.9 and -0.9, as one unlit actor. Their quads come
   * in an order shuffled by `seed`. Colours are rounded to 8 bits, see RoundedTo8Bits().
   */
  vtkSmartPointer<vtkActor> AddPlates(const std::vector<Rgba>& plates, std::uint64_t seed);

  /** The same, each at a height of its own. */
  vtkSmartPointer<vtkActor> AddPlates(
    const std::vector<Rgba>& plates, const std::vector<double>& heights, std::uint64_t seed);

  /** A triangle with a height of its own at each corner, unlit; corners are x, y, z. */
  vtkSmartPointer<vtkActor> AddTriangle(
    const std::array<std::array<double, 3>, 3>& corners, const Rgba& color);

  /** Any rectangle, unlit. */
  vtkSmartPointer<vtkActor> AddRectangle(
    double x0, double y0, double x1, double y1, double z, const Rgba& color);

  /** A lit sphere. */
  vtkSmartPointer<vtkActor> AddSphere(
    double x, double y, double z, double radius, const Rgba& color, int resolution = 16);

  /** Two translucent spheres that cut each other, and an opaque one. */
  void AddParts();

  /** A polygonal source with a mapper of its own, lit. */
  vtkSmartPointer<vtkActor> AddSource(vtkAlgorithm* source, const Rgba& color);

  /** Draw the translucent geometry by `pass`, the rest as VTK does. */
  void Use(vtkRenderPass* pass);

  /** Draw a frame as VTK does where it has no pass, which is what methods do that refuse it. */
  Picture RenderAsVTK();

  /** Draw a frame, and catch what OpenGL complains about. */
  Picture Render();

  /** Expect the same frame of a pass after each way in which it, its window or its context may be released. */
  void ExpectTheSameAfterReleases(vtkRenderPass* pass);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/** Plates composited front to back in double precision over a background; plates are given front to back. */
Rgba CompositePlates(const std::vector<Rgba>& plates, const Rgba& background);

/** Expect that no channel is farther off than `tolerance` steps of 1/255. */
void ExpectColor(const Rgba& color, const Rgba& expected, double tolerance);

/** A colour rounded to multiples of 1/255. */
Rgba RoundedTo8Bits(const Rgba& color);

/** Plates of random colours, rounded to 8 bits, all with the same alpha. */
std::vector<Rgba> RandomPlates(int count, double alpha, std::uint64_t seed);

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
