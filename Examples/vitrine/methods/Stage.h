/**
 * A window in which one method draws one scene.
 */
#ifndef VITRINE_STAGE_H
#define VITRINE_STAGE_H

#include "methods/Device.h"
#include "methods/Method.h"
#include "scene/Scene.h"
#include "study/image/Image.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTruthTransparencyPass.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace program
{

struct PictureSize
{
  int Width;
  int Height;

  double Aspect() const { return static_cast<double>(this->Width) / this->Height; }
};

/** Behind everything: a grey of this brightness. */
inline constexpr double Background = 0.95;

class Stage
{
public:
  /**
   * Build the window; nothing is drawn yet. The scene's geometry is shared between stages, nothing
   * else is.
   */
  Stage(const Scene& scene, std::unique_ptr<Method> method, PictureSize size, int multisamples);
  ~Stage();

  /**
   * Draw another scene from now on. Everything that the method and the window have built so far stays. Throws
   * InputError if the scene has more lights than the method draws.
   */
  void SetScene(const Scene& scene);

  /** Draw the scene's parts in another order, a permutation of their indices. */
  void SetPartOrder(const std::vector<std::size_t>& order);

  void SetSize(PictureSize size);

  /**
   * Draw a frame, finished on the device. Returns the wall time in milliseconds. Throws
   * RuntimeError if there is no OpenGL to draw with.
   */
  double Draw(vtkCamera* camera);

  /** The last frame as the window holds it: 8-bit RGB, rows from the bottom. */
  std::vector<std::uint8_t> ReadPixels();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /** The index of the scene's part that an actor draws. Absent if it draws none. */
  std::optional<std::size_t> PartOf(const vtkProp* actor) const;

  const Method& GetMethod() const { return *this->DrawingMethod; }
  PictureSize GetSize() const { return this->Size; }
  Device GetDevice();

  /** Of a pixel of the last frame: as many as the device has of those that were asked for. */
  int GetSamples();

private:
  std::unique_ptr<Method> DrawingMethod;
  PictureSize Size;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkActor>> Actors; ///< in the order of the scene's parts
  std::optional<std::array<double, 2>> ClippingRange;
};

/** Throw InputError if the scene has more lights than `most`. */
void RequireFewLights(const Scene& scene, std::size_t most);

/** An 8-bit picture as numbers in [0, 1]. */
vitrine::Image ToImage(const std::vector<std::uint8_t>& pixels, PictureSize size);

/** A picture as a display shows it, 8-bit RGB, rounded; what is not a number is black. */
std::vector<std::uint8_t> ToPixels(const vitrine::Image& image);

/** A stage whose method is truth, with its pictures before they are rounded. */
class TruthStage
{
public:
  TruthStage(
    const Scene& scene, PictureSize size, int multisamples, const Coincidence& coincidence = {});

  /** Draw and return the picture. Null if truth cannot run here. */
  std::unique_ptr<vitrine::Image> Draw(vtkCamera* camera);

  Stage& GetStage() { return this->Window; }
  MethodStatistics Statistics() const { return this->Window.GetMethod().Statistics(); }
  std::string WhyNotRun() const { return this->Window.GetMethod().WhyNotRun(); }

private:
  vtkNew<vtkTruthTransparencyPass> Pass;
  Stage Window;
};

}
#endif
