# Install BUILD_DIR into a prefix below WORK_DIR; build the project in EXAMPLE_DIR against it by
# find_package(Vitrine), and run it; import the Python package from it, if PYTHON names an interpreter.
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")
foreach (header vtkSeeThroughPass vtkHeadlessRenderWindow vtkVitrineRenderingModule)
  if (NOT EXISTS "${prefix}/include/vitrine/${header}.h")
    message(FATAL_ERROR "${header}.h is not installed")
  endif ()
endforeach ()

run("${CMAKE_COMMAND}" -S "${EXAMPLE_DIR}" -B "${WORK_DIR}/example" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}" -DCMAKE_BUILD_TYPE=Debug)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/example")

# Projects that link all that they asked VTK for get no less by asking for Vitrine, too.
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/libraries" -B "${WORK_DIR}/libraries" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}")

# Nothing but the installed files may be needed, nor a display.
unset(ENV{LD_LIBRARY_PATH})
unset(ENV{DISPLAY})
set(picture "${WORK_DIR}/minimal.png")
run("${WORK_DIR}/example/minimal" "${picture}")
file(READ "${picture}" signature LIMIT 8 HEX)
if (NOT signature STREQUAL "89504e470d0a1a0a")
  message(FATAL_ERROR "${picture} is not a PNG file")
endif ()

if (PYTHON)
  set(ENV{PYTHONPATH} "${prefix}/lib/python3/dist-packages")
  run("${PYTHON}" -c "import vitrine; vitrine.vtkSeeThroughPass()")
endif ()
