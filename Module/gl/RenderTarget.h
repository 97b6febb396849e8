/** The framebuffer that is bound when a render pass begins. The pass draws into it. */
#ifndef VITRINE_GL_RENDER_TARGET_H
#define VITRINE_GL_RENDER_TARGET_H

#include "Core/geometry/PixelRegion.h"
#include "gl/AttachedImage.h"
#include "gl/VitrineOpenGL.h"

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkTextureObject;

namespace vitrine
{

/**
 * The images of a framebuffer in which VTK draws a window. As long as they are equal, so are their formats and samples:
 * VTK's framebuffers change them only by new texture objects.
 */
struct ImagesOfVTK
{
  struct Image
  {
    const vtkTextureObject* Object = nullptr;
    std::uint64_t Time = 0; // When the object was made or changed. No two objects have the same.
    unsigned int Size[2] = {};
    int Name = 0; // The name of the image that OpenGL has attached.

    bool operator==(const Image& other) const;
  };
  Image Color;
  Image Depth;

  /** Read the images if the bound `framebuffer` is that of the window, and VTK's textures are attached to it. */
  static ImagesOfVTK Of(vtkOpenGLRenderWindow* window, GLuint framebuffer);

  bool AreKnown() const { return this->Color.Object && this->Depth.Object; }
  bool operator==(const ImagesOfVTK& other) const
  {
    return this->Color == other.Color && this->Depth == other.Depth;
  }
};

/** Returns true if `framebuffer` is that in which VTK draws the window, and VTK gave it one colour image. */
bool HasOneColorOfVTK(vtkOpenGLRenderWindow* window, GLuint framebuffer);

/** Returns the region to draw: the scissor box if the test is on, else the viewport, cut to the size of the target. */
PixelRegion DrawnRegion(vtkOpenGLState* state, int width, int height);

/** The properties of a draw framebuffer: its images, size, samples and the region to draw. */
struct RenderTarget
{
  GLuint Framebuffer = 0;
  GLenum DrawBuffer = GL_NONE;
  ImagesOfVTK Images; // Unknown in framebuffers other than VTK's own.
  AttachedImage Color;
  AttachedImage Depth;
  bool DepthHasStencil = false;
  int Width = 0;
  int Height = 0;
  int Samples = 0;          // Samples of a pixel, 0 if single-sampled.
  bool FixedPoint = true;   // Colours are normalised fixed point, not float.
  bool EncodesSRGB = false; // Colours are stored with sRGB's curve.
  bool EightBit = true;     // Colours are linear, with 8 bits a channel.
  double DepthSteps = 0.0;  // 2^bits - 1 of a fixed-point depth buffer of at most 24 bits, else 0.
  // The depth is single-sampled fixed point of more than 24 bits. It is copied as 32-bit integers.
  bool DepthIntegers = false;
  // Largest error of depth read by samplers if multisampled fixed-point depth has more than 24 bits, else 0.
  double DepthLoss = 0.0;
  PixelRegion Viewport;
  // The scissor box cut to the target, or the viewport if the scissor test is off.
  PixelRegion Region;

  /**
   * Read the bound draw framebuffer. What is certain since `last`, the target of the last frame, is not asked again.
   * Returns why a pass cannot draw into it, or an empty string. Changes no state.
   */
  std::string Probe(vtkOpenGLRenderWindow* window, const RenderTarget& last);

  /**
   * Bind `framebuffer`, which has this target's depth, and set the state to rasterise translucent geometry into
   * `region`. Fragments are tested against the opaque depth, which is not written. There is no blending. In a
   * multisampled target the shaders cut out the region (FragmentCapture.glsl).
   */
  void BindForFill(vtkOpenGLState* state, GLuint framebuffer, const PixelRegion& region) const;

  /**
   * Returns as which attachment an image of this target's depth format is attached to the framebuffer that is bound for
   * drawing. A stencil that was attached with the depth of a former target is removed, or the framebuffer would not be
   * complete.
   */
  GLenum ReadyDepthAttachment() const;

  /** Attach this target's depth to the framebuffer bound for drawing, so that the depth test uses the opaque depth. */
  void AttachDepth() const;

private:
  std::string Describe();
};

}
#endif
