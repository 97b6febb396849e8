# Wrap the module for Python as the package vitrine, in the build tree under the same relative folder as
# in the installed one.

add_library(VitrinePythonWrapping INTERFACE)
target_compile_options(VitrinePythonWrapping INTERFACE -w) # VTK writes these sources

vtk_module_wrap_python(
  MODULES             ${vitrine_modules}
  PYTHON_PACKAGE      vitrine
  MODULE_DESTINATION  "${vitrine_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${vitrine_cmake_destination}"
  UTILITY_TARGET      VitrinePythonWrapping
  BUILD_STATIC        OFF)

set(vitrine_python_build_dir "${PROJECT_BINARY_DIR}/${vitrine_python_destination}/vitrine")
file(GLOB vitrine_python_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/Python/vitrine"
  "${PROJECT_SOURCE_DIR}/Python/vitrine/*.py" "${PROJECT_SOURCE_DIR}/Python/vitrine/*.pyi"
  "${PROJECT_SOURCE_DIR}/Python/vitrine/py.typed"
  "${PROJECT_SOURCE_DIR}/Python/vitrine/inspector/*" "${PROJECT_SOURCE_DIR}/Python/vitrine/explore/*")
list(FILTER vitrine_python_files EXCLUDE REGEX "__pycache__")
foreach (file IN LISTS vitrine_python_files)
  configure_file("Python/vitrine/${file}" "${vitrine_python_build_dir}/${file}" COPYONLY)
endforeach ()
configure_file(Python/vitrine/_build.py.in "${vitrine_python_build_dir}/_build.py" @ONLY)
foreach (file IN LISTS vitrine_python_files ITEMS _build.py)
  get_filename_component(folder "${file}" DIRECTORY)
  install(
    FILES       "${vitrine_python_build_dir}/${file}"
    DESTINATION "${vitrine_python_destination}/vitrine/${folder}"
    COMPONENT   python)
endforeach ()
