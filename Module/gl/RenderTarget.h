/** The framebuffer that is bound when a render pass begins. The pass draws into it. */
#ifndef VITRINE_GL_RENDER_TARGET_H
#define VITRINE_GL_RENDER_TARGET_H

#include "Core/geometry/PixelRegion.h"
#include "gl/AttachedImage.h"
#include "gl/VitrineOpenGL.h"

#include <string>

class vtkOpenGLState;

namespace vitrine
{

/** The properties of a draw framebuffer: its images, size, samples and the region to draw. */
struct RenderTarget
{
  GLuint Framebuffer = 0;
  GLenum DrawBuffer = GL_NONE;
  AttachedImage Color;
  AttachedImage Depth;
  bool DepthHasStencil = false;
  int Width = 0;
  int Height = 0;
  int Samples = 0;         // Samples of a pixel, 0 if single-sampled.
  bool FixedPoint = true;  // Colours are normalised fixed point, not float.
  double DepthSteps = 0.0; // 2^bits - 1 of a fixed-point depth buffer of at most 24 bits, else 0.
  // The depth is single-sampled fixed point of more than 24 bits. It is copied as 32-bit integers.
  bool DepthIntegers = false;
  // Largest error of depth read by samplers if multisampled fixed-point depth has more than 24 bits, else 0.
  double DepthLoss = 0.0;
  PixelRegion Viewport;
  // The scissor box cut to the target, or the viewport if the scissor test is off.
  PixelRegion Region;

  /** Read the bound draw framebuffer. Returns why a pass cannot draw into it, or an empty string. Changes no state. */
  std::string Probe(vtkOpenGLState* state);

  /**
   * Bind `framebuffer`, which has this target's depth, and set the state to rasterise translucent geometry into
   * `region`. Fragments are tested against the opaque depth, which is not written. There is no blending. In a
   * multisampled target the shaders cut out the region (FragmentCapture.glsl).
   */
  void BindForFill(vtkOpenGLState* state, GLuint framebuffer, const PixelRegion& region) const;

  /** Attach this target's depth to the framebuffer bound for drawing, so that the depth test uses the opaque depth. */
  void AttachDepth() const;
};

}
#endif
