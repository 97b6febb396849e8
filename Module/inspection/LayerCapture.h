/** A render pass that captures all fragments of a rectangle of pixels, of opaque and translucent props. */
#ifndef VITRINE_INSPECTION_LAYER_CAPTURE_H
#define VITRINE_INSPECTION_LAYER_CAPTURE_H

#include "Core/geometry/PixelRegion.h"
#include "Core/lists/PixelLayers.h"
#include "gl/GLObjects.h"
#include "gl/HeldContext.h"
#include "inspection/PropsInRegion.h"
#include "scene/PartShader.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

class vtkOpenGLState;

namespace vitrine
{

/**
 * Draws the props of a renderer into a framebuffer without images, and takes what their mappers' shaders write. Frames,
 * OpenGL's state and statistics stay as they were. All that is visible is drawn, also what a culler has left out.
 */
class LayerCapture : public vtkOpenGLRenderPass
{
public:
  static LayerCapture* New();
  vtkTypeMacro(LayerCapture, vtkOpenGLRenderPass);

  /** What to capture, in pixels of the window's framebuffer. */
  struct Request
  {
    vtkRenderer* Renderer = nullptr;
    PixelRegion Pixels;
    int Width = 0; ///< size of the framebuffer
    int Height = 0;
    int Samples = 0;         ///< samples of its pixels, 0 if it is single-sampled
    bool FixedPoint = true;  ///< it clamps colours to [0, 1]
    bool Translucent = true; ///< whether translucent props are drawn, beside the opaque ones
  };

  static const char* const TooMany; ///< the message if there is no room for all fragments

  /**
   * Append the fragments of the rectangle to `fragments`. Returns an error message, empty on success. The window's
   * context is current, and the renderer has drawn a frame.
   */
  std::string Capture(const Request& request, std::vector<LayerFragment>& fragments);

  void Render(const vtkRenderState*) override {}
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Release what is held, in the context that holds it. Does nothing if there is none. */
  void ReleaseHeld();

protected:
  LayerCapture() = default;
  ~LayerCapture() override;

private:
  std::string Prepare(const Request& request);
  std::string FindVariant(vtkOpenGLRenderWindow* window);
  void Draw(const std::vector<vtkProp*>& props);
  void DrawProp(vtkProp* prop);
  std::string DrawAll(const Request& request, std::vector<LayerFragment>& fragments);
  void NoteBlocks(vtkAbstractMapper* mapper, vtkProp* prop);
  void PlaceBlocks(LayerFragment* fragments, std::size_t count) const;
  std::string Problem; ///< what a mapper's shader lacks

  Request Now;
  bool DrawsOpaque = false;
  std::uint32_t PropPlace = 0; ///< of the prop that is drawn, in the order of drawing
  std::uint32_t LastPlace = 0; ///< of the props and blocks that were drawn so far
  std::unordered_map<std::uint32_t, std::uint32_t>
    BlockPlaces; ///< of opaque ones, by their numbers
  bool Version430 = false;
  std::string Refused; ///< why the driver refuses the shaders; empty if it does not
  bool IsTried = false;
  HeldContext Context;
  PropsInRegion Props;
  PartShader Parts;
  Framebuffer Target;
  Buffer Counter;
  Buffer Fragments;
  vtkTimeStamp Stage;
};

}

#endif
