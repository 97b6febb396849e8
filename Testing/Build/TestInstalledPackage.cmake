# Install BUILD_DIR into a prefix below WORK_DIR; build the projects minimal and qt in EXAMPLES_DIR against it by
# find_package(Vitrine), and run them, what needs a display by DESKTOP; import the Python package from it, if PYTHON
# names an interpreter.
include("${CMAKE_CURRENT_LIST_DIR}/Run.cmake")

file(REMOVE_RECURSE "${WORK_DIR}")
set(prefix "${WORK_DIR}/prefix")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --config "${CONFIG}" --prefix "${prefix}")
foreach (header vtkSeeThroughPass vtkHeadlessRenderWindow vtkVitrineRenderingModule)
  if (NOT EXISTS "${prefix}/include/vitrine/${header}.h")
    message(FATAL_ERROR "${header}.h is not installed")
  endif ()
endforeach ()

foreach (example minimal qt)
  run("${CMAKE_COMMAND}" -S "${EXAMPLES_DIR}/${example}" -B "${WORK_DIR}/${example}" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}" -DCMAKE_BUILD_TYPE=Debug)
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/${example}")
endforeach ()

# Projects that link all that they asked VTK for get no less by asking for Vitrine, too.
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/libraries" -B "${WORK_DIR}/libraries" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DVTK_DIR=${VTK_DIR}")

# Nothing but the installed files may be needed, nor a display.
unset(ENV{LD_LIBRARY_PATH})
unset(ENV{DISPLAY})
set(picture "${WORK_DIR}/minimal.png")
run("${WORK_DIR}/minimal/minimal" "${picture}")
file(READ "${picture}" signature LIMIT 8 HEX)
if (NOT signature STREQUAL "89504e470d0a1a0a")
  message(FATAL_ERROR "${picture} is not a PNG file")
endif ()

# A window of Qt shows the same scene: behind it all, the glass, and what is in it. Edges may have other samples.
set(ENV{QT_QPA_PLATFORM} xcb)
set(ENV{XDG_RUNTIME_DIR} "${WORK_DIR}")
run(/usr/bin/python3 -B "${DESKTOP}" "${WORK_DIR}/qt/qt_window" "${WORK_DIR}/qt.png")
run(/usr/bin/python3 -B "${CMAKE_CURRENT_LIST_DIR}/same_pixels.py" "${picture}" "${WORK_DIR}/qt.png"
  5,5 200,85 135,160 265,150 200,150 180,140 215,170)

if (PYTHON)
  set(ENV{PYTHONPATH} "${prefix}/lib/python3/dist-packages")
  run("${PYTHON}" -c "import vitrine; vitrine.vtkSeeThroughPass()")
endif ()
