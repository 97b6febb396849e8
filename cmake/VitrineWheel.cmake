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

# Libraries that a user's machine need not have, and what they ask for with them.
include(VitrineMeshLibraries)
get_filename_component(vitrine_meshoptimizer "${VITRINE_MESHOPTIMIZER_LIBRARY}" REALPATH)
get_filename_component(vitrine_libraries "${VITRINE_MESHOPTIMIZER_LIBRARY}" DIRECTORY)
file(GLOB vitrine_meshoptimizer_name RELATIVE "${vitrine_libraries}" "${vitrine_libraries}/libmeshoptimizer.so.*d")
install(
  FILES       "${vitrine_meshoptimizer}"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  RENAME      "${vitrine_meshoptimizer_name}"
  COMPONENT   runtime)
foreach (library IN ITEMS CORE TOOLS)
  get_filename_component(vitrine_openmesh "${VITRINE_OPENMESH_${library}_LIBRARY}" REALPATH)
  install(FILES "${vitrine_openmesh}" DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime)
endforeach ()
foreach (package IN ITEMS libdraco-dev libmeshoptimizer-dev libopenmesh-dev)
  install(
    FILES       "${vitrine_libraries}/../../share/doc/${package}/copyright"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/licenses"
    RENAME      "${package}.txt"
    COMPONENT   runtime)
endforeach ()
