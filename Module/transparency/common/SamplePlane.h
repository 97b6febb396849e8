/** An image of one sample of each pixel of a target. Through it samples are read to the CPU and written. */
#ifndef VITRINE_TRANSPARENCY_COMMON_SAMPLE_PLANE_H
#define VITRINE_TRANSPARENCY_COMMON_SAMPLE_PLANE_H

#include "gl/GLObjects.h"
#include "gl/ProgramCache.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

namespace vitrine
{

struct RenderTarget;

/** Call Prepare() and Compile() in each frame first. All calls change the framebuffer bindings, tests and masks. */
class SamplePlane
{
public:
  /** The format of the image, and the one in which the CPU has its pixels. */
  struct Format
  {
    GLenum Image;
    GLenum Pixels;
    GLenum Type;
    bool HasDepth = false; ///< The pixels are depths. They are written as such.
  };

  /** Make the image. Returns an error message if the driver cannot hold it, else an empty string. */
  std::string Prepare(vtkOpenGLState* state, const RenderTarget& target, const Format& format);

  /** Compile the shaders. Returns false if the driver cannot. */
  bool Compile(vtkOpenGLRenderWindow* window, const RenderTarget& target);

  /** Read sample `sample` of all pixels of `source`, which has the size and samples of the target. */
  void Read(vtkOpenGLRenderWindow* window, const RenderTarget& target, const Image2D& source,
    int sample, void* pixels);

  /** Write a sample of the pixels of the target's region. `pixels` are those of all pixels. */
  void Write(
    vtkOpenGLRenderWindow* window, const RenderTarget& target, int sample, const void* pixels);

  std::int64_t Bytes() const { return this->Picture.Bytes(); }
  void Release();

private:
  vtkShaderProgram* ReadyRead(vtkOpenGLRenderWindow* window, const RenderTarget& target);
  vtkShaderProgram* ReadyWrite(vtkOpenGLRenderWindow* window);
  void Draw(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const Image2D& source);

  Format Transfer = { GL_NONE, GL_NONE, GL_NONE };
  Image2D Picture;
  Framebuffer Target; // of Picture
  EmptyVertexArray VertexArray;
  ProgramCache Programs;
};

}
#endif
