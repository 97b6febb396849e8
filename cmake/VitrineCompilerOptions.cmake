# Warnings and sanitizers for every target of the stand-alone build.
add_compile_options(-Wall -Wextra)
if (VITRINE_SANITIZE)
  add_compile_options(-fsanitize=${VITRINE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${VITRINE_SANITIZE})
endif ()

# Compile through ccache where there is one.
find_program(VITRINE_CCACHE ccache)
mark_as_advanced(VITRINE_CCACHE)
if (VITRINE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_C_COMPILER_LAUNCHER "${VITRINE_CCACHE}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VITRINE_CCACHE}")
endif ()

# For what takes more time to be compiled than it ever runs: tests, command lines.
set(VITRINE_QUICK_COMPILE "$<$<CONFIG:Release>:-O1>")
