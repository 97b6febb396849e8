# The CMake package by which other projects find_package(Vitrine).
include(CMakePackageConfigHelpers)

set(vitrine_package_dir "${PROJECT_BINARY_DIR}/package")
configure_package_config_file(
  cmake/VitrineConfig.cmake.in "${vitrine_package_dir}/VitrineConfig.cmake"
  INSTALL_DESTINATION "${vitrine_cmake_destination}"
  PATH_VARS           CMAKE_INSTALL_BINDIR
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${vitrine_package_dir}/VitrineConfigVersion.cmake"
  VERSION       ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${vitrine_package_dir}/VitrineConfig.cmake"
    "${vitrine_package_dir}/VitrineConfigVersion.cmake"
    cmake/VitrineImageTest.cmake
    cmake/VitrineImageTestRun.cmake
  DESTINATION "${vitrine_cmake_destination}"
  COMPONENT   development)
if (NOT SKBUILD) # which puts it beside the metadata of a wheel
  install(
    FILES       LICENSE
    DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/vitrine"
    COMPONENT   runtime)
endif ()
