/** A compute shader. VTK's shader programs have none. */
#ifndef VITRINE_GL_COMPUTE_PROGRAM_H
#define VITRINE_GL_COMPUTE_PROGRAM_H

#include "gl/GLObjects.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace vitrine
{

class ComputeProgram
{
public:
  /** Takes GLSL 4.30 without #version and defines. */
  explicit ComputeProgram(const char* source)
    : Source(source)
  {
  }

  /**
   * Bind the program. It is compiled at first use, and again if `defines` ("NAME value") differ. Returns false if the
   * driver cannot compile it. A failure is reported, and not tried again. Unbinds the current program of VTK's shader
   * cache.
   */
  bool Use(vtkOpenGLRenderWindow* window, const std::vector<std::string>& defines);

  ///@{
  /** Set a uniform of the bound program. A uniform that the driver optimised away is ignored. */
  void Set(const char* name, int value);
  void Set(const char* name, unsigned int value);
  void Set(const char* name, const int (&value)[2]);
  ///@}

  /**
   * Run at least one invocation for each of `count` items, in groups of `groupSize`. There may be more invocations than
   * items.
   */
  static void DispatchFor(std::int64_t count, int groupSize);

  bool HasFailed() const { return this->Failed; }

  void Release();

private:
  void Compile(const std::string& text);
  int Location(const char* name);

  const char* Source;
  std::string Defines;
  ObjectName Name;
  std::map<std::string, int> Locations; // Locations of the uniforms that were set before.
  bool Failed = false;
};

}
#endif
