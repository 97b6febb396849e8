/** A render pass that draws the numbers of chosen parts into an image of the viewport. */
#ifndef VITRINE_LOOK_PART_MASK_H
#define VITRINE_LOOK_PART_MASK_H

#include "Core/geometry/PixelRegion.h"
#include "gl/GLObjects.h"
#include "gl/HeldContext.h"
#include "look/ChosenParts.h"
#include "look/NumberShader.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkTimeStamp.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * The image has the number of the nearest chosen part in its first three channels (Shaders/PartMaskImpl.glsl), whatever
 * is before it, and in its last channel 1 where an excluded part is drawn. Parts are drawn by their own mappers, so the
 * mask agrees with clipping planes, sections and hidden blocks.
 */
class PartMask : public vtkOpenGLRenderPass
{
public:
  static PartMask* New();
  vtkTypeMacro(PartMask, vtkOpenGLRenderPass);

  /**
   * Draw the mask of a region of a renderer's viewport. Pixels outside of the region are undefined. The window's
   * context is current, and the renderer has drawn its frame. Returns why that is not possible, or an empty string.
   * OpenGL's state stays as it was.
   */
  std::string Draw(vtkRenderer* renderer, const PixelRegion& viewport, const PixelRegion& region,
    const ChosenParts& chosen, const std::vector<vtkProp*>& props, const ChosenParts& excluded);

  /** The texture of the last mask. It has the size of the viewport. */
  GLuint Texture() const { return this->Image.Handle(); }

  std::int64_t Bytes() const { return this->Image.Bytes() + this->Depth.Bytes(); }

  void Render(const vtkRenderState*) override {}
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertexArray) override;
  vtkMTimeType GetShaderStageMTime() override { return this->Stage.GetMTime(); }
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Release what is held, in the context that holds it. Does nothing if there is none. */
  void ReleaseHeld();

protected:
  PartMask() = default;
  ~PartMask() override;

private:
  std::string Prepare(const PixelRegion& viewport, const PixelRegion& region);
  void DrawProps(
    vtkRenderer* renderer, const ChosenParts& parts, std::vector<vtkProp*> props, bool isExcluded);

  HeldContext Context;
  Image2D Image;
  Image2D Depth;
  Framebuffer Target;
  NumberShader Numbers;
  vtkProp* Drawn = nullptr;
  bool WritesDepth = true;
  std::string Problem; ///< what a mapper's shader lacks
  vtkTimeStamp Stage;
};

}

#endif
