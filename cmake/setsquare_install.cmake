# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0

# Installs the layers as a package: find_package(setsquare) gives setsquare::core, setsquare::scan,
# setsquare::matching ...; find_package(setsquare COMPONENTS matching) demands no more of the
# machine than those layers need. Only the public headers are installed (HEADERS of each layer in
# setsquare/CMakeLists.txt); they keep their path below include/setsquare.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

get_property(setsquare_layers GLOBAL PROPERTY SETSQUARE_LAYERS)
# The simulator has no public header.
list(REMOVE_ITEM setsquare_layers setsquare_sim)
install(
  TARGETS ${setsquare_layers}
  EXPORT setsquare-targets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library
  FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT library)

set(setsquare_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/setsquare")
install(
  EXPORT setsquare-targets
  NAMESPACE setsquare::
  DESTINATION "${setsquare_package_dir}"
  COMPONENT library)
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/setsquare-config.cmake.in"
  "${PROJECT_BINARY_DIR}/setsquare-config.cmake" INSTALL_DESTINATION "${setsquare_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/setsquare-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(
  FILES "${PROJECT_BINARY_DIR}/setsquare-config.cmake"
        "${PROJECT_BINARY_DIR}/setsquare-config-version.cmake"
  DESTINATION "${setsquare_package_dir}"
  COMPONENT library)
