# VITRINE_VTK_CHECKS_STATE: whether this VTK compares what it recorded of OpenGL's state with OpenGL at each call, and
# warns. VTK built without NDEBUG does so, as that of Debian's ParaView. Only then its library has CheckState().
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LIBRARIES VTK::RenderingOpenGL2)
check_cxx_source_compiles(
  "#include <vtkOpenGLState.h>
   struct State : vtkOpenGLState { static void Check(State* state) { state->CheckState(); } };
   int main() { State::Check(nullptr); }"
  VITRINE_VTK_CHECKS_STATE)
unset(CMAKE_REQUIRED_LIBRARIES)
