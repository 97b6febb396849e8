/**
 * A compute shader, which VTK's shader programs do not have.
 */
#ifndef VITRINE_GL_COMPUTE_PROGRAM_H
#define VITRINE_GL_COMPUTE_PROGRAM_H

#include "gl/GLObjects.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class ComputeProgram
{
public:
  /** GLSL 4.30 without #version and defines. */
  explicit ComputeProgram(const char* source)
    : Source(source)
  {
  }

  /**
   * Bind the program, compiled at first use and again when `defines` ("NAME value") are others. Returns false where
   * the driver cannot compile it, which is tried once and reported. VTK's shader cache has no program bound then.
   */
  bool Use(vtkOpenGLRenderWindow* window, const std::vector<std::string>& defines);

  ///@{
  /** Set a uniform of the bound program; one that the driver has left out is none. */
  void Set(const char* name, int value) const;
  void Set(const char* name, unsigned int value) const;
  void Set(const char* name, const int (&value)[2]) const;
  ///@}

  /** Run an invocation for each of `count` items, in groups of `groupSize`, and maybe some more. */
  static void DispatchFor(std::int64_t count, int groupSize);

  bool HasFailed() const { return this->Failed; }

  void Release();

private:
  void Compile(const std::string& text);

  const char* Source;
  std::string Defines;
  ObjectName Name;
  bool Failed = false;
};

}
#endif
