/** An image for each sample of a multisampled target, in the target's format. A shader writes them in one draw. */
#ifndef VITRINE_TRANSPARENCY_ABUFFER_SAMPLE_IMAGES_H
#define VITRINE_TRANSPARENCY_ABUFFER_SAMPLE_IMAGES_H

#include "gl/GLObjects.h"

#include <string>

class vtkOpenGLState;

namespace vitrine
{

struct RenderTarget;

class SampleImages
{
public:
  /**
   * Make images for the target's samples. Changes the framebuffer binding. Returns an error message if the driver
   * cannot hold them, else an empty string.
   */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target);

  void Release();

  /** Output s of a shader goes to the image of sample s. */
  GLuint FramebufferHandle() { return this->Target.Handle(); }

  /** The images: the layers of an array. */
  const Image2D& Colors() const { return this->Layers; }

private:
  Image2D Layers;
  std::uint64_t Attached = 0; // Number() of the attached images.
  Framebuffer Target;
};

}
#endif
