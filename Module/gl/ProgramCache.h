/** A pass's own shader programs, compiled at first use and kept by name. */
#ifndef VITRINE_GL_PROGRAM_CACHE_H
#define VITRINE_GL_PROGRAM_CACHE_H

#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace vitrine
{

/** The reason that a pass gives if one of its own programs does not compile. */
inline constexpr const char* ProgramFailure = "the driver cannot compile a shader of the method";

/** First line of a program's shaders. VTK replaces its first tag by the GLSL version of mappers' shaders, 1.50. */
inline constexpr const char* GLSL430 = "#version 430 core\n";
inline constexpr const char* GLSL150 = "//VTK::System::Dec\n";

class ProgramCache
{
public:
  explicit ProgramCache(const char* version = GLSL430)
    : Version(version)
  {
  }

  /**
   * Bind the program of this name and these defines. At its first use `fragment` returns its fragment shader, without
   * #version and defines. Returns null if the driver cannot compile it. VTK then reports why, and it is not tried
   * again.
   */
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& name,
    const std::vector<std::string>& defines, const char* vertex,
    const std::function<std::string()>& fragment);

  /** Returns true if the program of this name and these defines is compiled already. */
  bool Has(const std::string& name, const std::vector<std::string>& defines) const;

  /** Returns true if a program did not compile. */
  bool HasFailed() const { return this->Failed; }

  void Release()
  {
    this->Programs.clear();
    this->Failed = false;
  }

private:
  const char* Version;
  bool Failed = false;
  std::map<std::string, vtkSmartPointer<vtkShaderProgram>> Programs;
};

/** Returns `#define` lines for all of `defines` ("NAME value"). */
std::string DefineLines(const std::vector<std::string>& defines);

}
#endif
