# Find what Core works on meshes with: the decoders of compressed geometry, which are Draco, as a static library, and
# meshoptimizer, by its C interface; and OpenMesh, which makes meshes coarser. They are VITRINE_MESH_LIBRARIES, and
# their headers VITRINE_MESH_INCLUDES. CMake files of Debian's packages name files by paths that hold only where the
# packages are installed, so they are not used.
find_path(VITRINE_DRACO_INCLUDE draco/compression/decode.h)
find_library(VITRINE_DRACO_LIBRARY NAMES libdraco.a draco)
find_path(VITRINE_MESHOPTIMIZER_INCLUDE meshoptimizer.h)
find_library(VITRINE_MESHOPTIMIZER_LIBRARY meshoptimizer)
find_path(VITRINE_OPENMESH_INCLUDE OpenMesh/Tools/Decimater/DecimaterT.hh)
find_library(VITRINE_OPENMESH_CORE_LIBRARY OpenMeshCore)
find_library(VITRINE_OPENMESH_TOOLS_LIBRARY OpenMeshTools)
mark_as_advanced(VITRINE_DRACO_INCLUDE VITRINE_DRACO_LIBRARY
  VITRINE_MESHOPTIMIZER_INCLUDE VITRINE_MESHOPTIMIZER_LIBRARY
  VITRINE_OPENMESH_INCLUDE VITRINE_OPENMESH_CORE_LIBRARY VITRINE_OPENMESH_TOOLS_LIBRARY)
if (NOT VITRINE_DRACO_INCLUDE OR NOT VITRINE_DRACO_LIBRARY)
  message(FATAL_ERROR "Vitrine needs Draco with its headers. Debian's package is libdraco-dev.")
endif ()
if (NOT VITRINE_MESHOPTIMIZER_INCLUDE OR NOT VITRINE_MESHOPTIMIZER_LIBRARY)
  message(FATAL_ERROR "Vitrine needs meshoptimizer with its header. Debian's package is libmeshoptimizer-dev.")
endif ()
if (NOT VITRINE_OPENMESH_INCLUDE OR NOT VITRINE_OPENMESH_CORE_LIBRARY OR NOT VITRINE_OPENMESH_TOOLS_LIBRARY)
  message(FATAL_ERROR "Vitrine needs OpenMesh with its headers. Debian's package is libopenmesh-dev.")
endif ()
set(VITRINE_MESH_LIBRARIES "${VITRINE_DRACO_LIBRARY}" "${VITRINE_MESHOPTIMIZER_LIBRARY}"
  "${VITRINE_OPENMESH_TOOLS_LIBRARY}" "${VITRINE_OPENMESH_CORE_LIBRARY}")
set(VITRINE_MESH_INCLUDES
  "${VITRINE_DRACO_INCLUDE}" "${VITRINE_MESHOPTIMIZER_INCLUDE}" "${VITRINE_OPENMESH_INCLUDE}")
