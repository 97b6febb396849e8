# Put SOURCE_DIR where VTK looks for remote modules, in a stand-in for VTK's source tree made from
# PROJECT_DIR, and build the module there.
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
file(COPY "${PROJECT_DIR}/" DESTINATION "${WORK_DIR}/source")
# A link, except for the build trees and the repository within the sources, which VTK would search.
foreach (entry CMakeLists.txt LICENSE Module Testing cmake vtk.module)
  file(MAKE_DIRECTORY "${WORK_DIR}/source/Remote/Vitrine")
  file(CREATE_LINK "${SOURCE_DIR}/${entry}" "${WORK_DIR}/source/Remote/Vitrine/${entry}" SYMBOLIC)
endforeach ()

run("${CMAKE_COMMAND}" -S "${WORK_DIR}/source" -B "${WORK_DIR}/build" -G "${GENERATOR}"
  "-DVTK_DIR=${VTK_DIR}" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
  -DCMAKE_UNITY_BUILD=ON)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")

file(GLOB_RECURSE libraries "${WORK_DIR}/build/libvtkVitrineRendering*.so")
if (NOT libraries)
  message(FATAL_ERROR "The module's library was not built")
endif ()
