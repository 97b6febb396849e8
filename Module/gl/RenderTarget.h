/**
 * What a render pass draws into: the framebuffer bound when the pass begins, whatever VTK made it of.
 */
#ifndef VITRINE_GL_RENDER_TARGET_H
#define VITRINE_GL_RENDER_TARGET_H

#include "Core/geometry/PixelRegion.h"
#include "gl/AttachedImage.h"
#include "gl/VitrineOpenGL.h"

#include <string>

class vtkOpenGLState;

namespace vitrine
{

/**
 * The draw framebuffer as it is: its images, size, samples and the region to draw.
 */
struct RenderTarget
{
  GLuint Framebuffer = 0;
  GLenum DrawBuffer = GL_NONE;
  AttachedImage Color;
  AttachedImage Depth;
  bool DepthHasStencil = false;
  int Width = 0;
  int Height = 0;
  int Samples = 0;         // 0: single-sampled
  bool FixedPoint = true;  // colours are normalised fixed point, not float
  double DepthSteps = 0.0; // 2^bits - 1 of a fixed-point depth buffer of at most 24 bits, else 0
  bool DepthIntegers =
    false; // single-sampled fixed-point depth of more bits, which is copied as integers of 32
  double DepthLoss =
    0.0; // how far sampled depth may be off where multisampled depth is of more bits, else 0
  PixelRegion Viewport;
  PixelRegion Region; // scissor box within the target, or the viewport where the test is off

  /**
   * Read the bound draw framebuffer. Returns an empty string, or why a pass cannot draw into it. Changes
   * no state.
   */
  std::string Probe(vtkOpenGLState* state);

  /**
   * Bind `framebuffer`, which has this target's depth, and set the state to rasterise translucent geometry into
   * `region`: tested against the opaque depth, which stays, and without blending. Where the target is multisampled
   * the shaders cut out the region (FragmentCapture.glsl).
   */
  void BindForFill(vtkOpenGLState* state, GLuint framebuffer, const PixelRegion& region) const;

  /** Attach this target's depth to the framebuffer bound for drawing, so that its tests see opaque depth. */
  void AttachDepth() const;
};

}
#endif
