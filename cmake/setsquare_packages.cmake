# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0

# Debian packages, made by `cpack` in the build folder: setsquare (the command, its manual pages and
# completions), libsetsquare-dev (the library) and, where they are built, setsquare-live (`setsquare
# live`) and python3-setsquare. tools/make_packages builds them.
include(GNUInstallDirs)

# What the command tells of itself, when it has been built.
if(TARGET setsquare_app)
  set(reference_dir "${PROJECT_BINARY_DIR}/reference")
  add_custom_command(
    OUTPUT "${reference_dir}/made"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${reference_dir}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${reference_dir}"
    COMMAND setsquare_app manual -o "${reference_dir}/man1"
    COMMAND gzip -9 -n -r "${reference_dir}/man1"
    COMMAND setsquare_app completion bash > "${reference_dir}/setsquare"
    COMMAND setsquare_app completion zsh > "${reference_dir}/_setsquare"
    COMMAND setsquare_app completion fish > "${reference_dir}/setsquare.fish"
    COMMAND "${CMAKE_COMMAND}" -E touch "${reference_dir}/made"
    DEPENDS setsquare_app
    VERBATIM)
  add_custom_target(setsquare_reference DEPENDS "${reference_dir}/made")
  install(DIRECTORY "${reference_dir}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}"
          COMPONENT command OPTIONAL)
  install(FILES "${reference_dir}/setsquare" OPTIONAL
          DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT command)
  install(FILES "${reference_dir}/_setsquare" OPTIONAL
          DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT command)
  install(FILES "${reference_dir}/setsquare.fish" OPTIONAL
          DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT command)
endif()

# What Debian's policy asks of each package: its licence, and its changes, packed.
string(TIMESTAMP package_date "%a, %d %b %Y 00:00:00 +0000" UTC)
set(package_copyright "${PROJECT_BINARY_DIR}/packages/copyright")
configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/copyright" "${package_copyright}" COPYONLY)
configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/changelog"
               "${PROJECT_BINARY_DIR}/packages/changelog" @ONLY)
execute_process(COMMAND gzip -9 -n -k -f "${PROJECT_BINARY_DIR}/packages/changelog")
foreach(pair IN ITEMS command=setsquare library=libsetsquare-dev live=setsquare-live
                      python=python3-setsquare)
  string(REPLACE "=" ";" pair "${pair}")
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(FILES "${package_copyright}" "${PROJECT_BINARY_DIR}/packages/changelog.gz"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component}
          EXCLUDE_FROM_ALL)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME setsquare)
set(CPACK_PACKAGE_CONTACT "The Setsquare authors <setsquare@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "map buildings from 2-D laser scans")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL command library)
set(description "Turns the scans of a 2-D laser scanner into a map whose walls are straight and
square, without odometry, without an initial guess and without tuning, and
says where the scans do not determine the answer.")
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "${description}\n\nThis package has the command.")
set(CPACK_COMPONENT_LIVE_DESCRIPTION
    "${description}\n\nThis package maps and localises while the robot drives, beside ROS 2.")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "${description}\n\nThis package has the C++ library.")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${description}\n\nThis package is for Python.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libeigen3-dev (>= 3.4), libfmt-dev, libbz2-dev, liblz4-dev, libpng-dev, libsqlite3-dev, \
libyaml-cpp-dev, libzstd-dev, zlib1g-dev")
# Apart from the command, which most want without the libraries of a network.
if(TARGET setsquare_live_app)
  list(APPEND CPACK_COMPONENTS_ALL live)
  set(CPACK_DEBIAN_LIVE_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_LIVE_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_LIVE_PACKAGE_DEPENDS "setsquare (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_COMMAND_PACKAGE_SUGGESTS setsquare-live)
endif()
if(TARGET setsquare_python)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(python_version "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${python_version}~), \
python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)
  # What Python compiles beside the files goes with them.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/python/postinst"
                                                "${PROJECT_SOURCE_DIR}/cmake/debian/python/prerm")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()
include(CPack)
