# VITRINE_HAS_EGL, and VITRINE_EGL_LIBRARIES to link: none where VTK's own loader, glad from VTK 9.4 on, opens the
# machine's EGL at run time (window/VitrineEGL.h).
set(VITRINE_EGL_LIBRARIES)
if (TARGET VTK::glad AND UNIX AND NOT APPLE)
  set(VITRINE_HAS_EGL TRUE)
else ()
  find_package(OpenGL QUIET COMPONENTS EGL)
  set(VITRINE_HAS_EGL ${OpenGL_EGL_FOUND})
  if (VITRINE_HAS_EGL)
    set(VITRINE_EGL_LIBRARIES OpenGL::EGL)
  endif ()
endif ()
