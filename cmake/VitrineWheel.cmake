# Where things lie in a wheel: all in the package's folder, beside the package vtkmodules, whose libraries they use.
set(CMAKE_INSTALL_LIBDIR vitrine)
set(CMAKE_INSTALL_BINDIR vitrine/bin)
set(vitrine_python_destination ".")
set(vitrine_versions)
set(CMAKE_INSTALL_RPATH "\$ORIGIN" "\$ORIGIN/../vtkmodules" "\$ORIGIN/.." "\$ORIGIN/../../vtkmodules")
if (APPLE)
  list(TRANSFORM CMAKE_INSTALL_RPATH REPLACE "^.ORIGIN" "@loader_path")
endif ()
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH OFF)

# On PATH.
if (VITRINE_BUILD_EXAMPLES)
  install(
    PROGRAMS    "${PROJECT_SOURCE_DIR}/Python/program.py"
    DESTINATION "${SKBUILD_SCRIPTS_DIR}"
    RENAME      vitrine
    COMPONENT   python)
endif ()
