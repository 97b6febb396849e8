# Build, wrap and install the module Vitrine::Rendering against an installed VTK.

set(vitrine_find_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath ParallelCore RenderingCore RenderingOpenGL2
  RenderingUI)
if (VITRINE_WRAP_PYTHON)
  list(APPEND vitrine_find_components WrappingPythonCore)
endif ()
if (BUILD_TESTING OR VITRINE_BUILD_EXAMPLES)
  list(APPEND vitrine_find_components
    CommonColor CommonTransforms FiltersCore FiltersGeneral FiltersGeometry FiltersModeling FiltersSources
    IOGeometry IOImage IOImport IOLegacy IOPLY IOXML ImagingCore InteractionStyle RenderingAnnotation
    RenderingFreeType RenderingVolume RenderingVolumeOpenGL2 InteractionWidgets)
endif ()
if (VITRINE_BUILD_EXAMPLES)
  list(APPEND vitrine_find_components ChartsCore RenderingContext2D RenderingContextOpenGL2)
endif ()
set(vitrine_optional_components)
if (VITRINE_BUILD_EXAMPLES)
  set(vitrine_optional_components OPTIONAL_COMPONENTS IOHDF) # needs HDF5, which not every VTK has
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${vitrine_find_components} ${vitrine_optional_components})
include(VitrineStringABI)
include(VitrineEGL)
set(VITRINE_LEFT_OUT) # beside vtkHeadlessRenderWindow, for Module's message
if (NOT VITRINE_HAS_EGL AND VITRINE_BUILD_EXAMPLES)
  set(VITRINE_BUILD_EXAMPLES OFF)
  string(APPEND VITRINE_LEFT_OUT ", the program vitrine, the examples and benchmarks")
endif ()
if (NOT VITRINE_HAS_EGL AND BUILD_TESTING)
  string(APPEND VITRINE_LEFT_OUT ", all tests but those of Core")
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(vitrine_python_destination "lib/python3/dist-packages")
set(vitrine_versions VERSION ${PROJECT_VERSION} SOVERSION 1)
set(CMAKE_INSTALL_RPATH "\$ORIGIN" "\$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON) # to a VTK outside the system's folders
if (SKBUILD)
  include(VitrineWheel)
endif ()

set(vitrine_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Vitrine")

# vtk_module_build() adds the module's folder, which is the project's root, into the same relative
# binary folder; a binary root of its own keeps the two apart.
set(vitrine_binary_dir "${CMAKE_BINARY_DIR}")
set(CMAKE_BINARY_DIR "${PROJECT_BINARY_DIR}/vtkmodule")

vtk_module_scan(
  MODULE_FILES     "${PROJECT_SOURCE_DIR}/vtk.module"
  REQUEST_MODULES  Vitrine::Rendering
  PROVIDES_MODULES vitrine_modules
  ENABLE_TESTS     OFF)
vtk_module_build(
  MODULES                ${vitrine_modules}
  PACKAGE                Vitrine
  INSTALL_EXPORT         Vitrine
  ${vitrine_versions}
  LIBRARY_DESTINATION    "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION      "${vitrine_cmake_destination}"
  HEADERS_DESTINATION    "${CMAKE_INSTALL_INCLUDEDIR}/vitrine"
  LICENSE_DESTINATION    "${CMAKE_INSTALL_DATADIR}/licenses/vitrine"
  HIERARCHY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/Vitrine")

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${vitrine_cmake_destination}"
  FILE_NAME         "Vitrine-vtk-module-find-packages.cmake"
  MODULES           ${vitrine_modules})

set(CMAKE_BINARY_DIR "${vitrine_binary_dir}")

if (VITRINE_WRAP_PYTHON)
  include(VitrinePython)
endif ()
include(VitrinePackage)
