# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0

# Flags of our own targets; never exported to users of the library.
add_library(setsquare_own_flags INTERFACE)
target_compile_features(setsquare_own_flags INTERFACE cxx_std_20)
if(SETSQUARE_WARNINGS)
  target_compile_options(
    setsquare_own_flags
    INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
              -Wconversion -Wno-sign-conversion $<$<BOOL:${SETSQUARE_WARNINGS_AS_ERRORS}>:-Werror>)
endif()
target_compile_options(
  setsquare_own_flags
  INTERFACE # The same numbers on every machine: no fused multiply-add behind our back.
            -ffp-contract=off
            # Lets loops over plain arrays vectorise; NaN and infinity keep their meaning.
            -fno-math-errno -fno-trapping-math
            # Code that a shared object can hold, as fast as a program's: nobody replaces our functions.
            -fno-semantic-interposition -fvisibility=hidden
            # GCC's garbage collector costs a tenth of a compilation; a unit needs 1 GB at most.
            $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)

# What many sources include and what takes long to parse. Few: to write them precompiled takes twice
# as long as to parse them.
set(setsquare_large_headers
    <Eigen/Core>
    <Eigen/LU>
    <algorithm>
    <functional>
    <map>
    <memory>
    <optional>
    <span>
    <string>
    <vector>)

# setsquare_precompile_headers(TARGET [FROM])
# Under SETSQUARE_PRECOMPILE_HEADERS gives a test program the precompiled headers of another target
# or, where none is named, its own: the large headers and GoogleTest.
function(setsquare_precompile_headers target)
  if(NOT SETSQUARE_PRECOMPILE_HEADERS)
    return()
  endif()
  # Programs and libraries are else compiled differently, and cannot share the headers.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  if(ARGC GREATER 1)
    target_precompile_headers(${target} REUSE_FROM ${ARGV1})
    return()
  endif()
  target_precompile_headers(
    ${target} PRIVATE ${setsquare_large_headers} <Eigen/Cholesky> <Eigen/Eigenvalues> <chrono>
    <filesystem> <fstream> <random> <sstream> <gmock/gmock.h> <gtest/gtest.h>)
  setsquare_compile_as_tests(${target})
endfunction()

# setsquare_set_temperature(TARGET hot|cold)
# Hot is what the time of a map or of a match depends on: it is compiled for speed, the cold rest in
# two thirds of the time. The large headers are parsed once a temperature, not once a target: the
# compiler takes precompiled headers only where its options are the same.
function(setsquare_set_temperature target temperature)
  set(headers setsquare_${temperature}_headers)
  set(libraries Eigen3::Eigen Threads::Threads setsquare_own_flags)
  if(temperature STREQUAL cold)
    list(APPEND libraries fmt::fmt)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:fmt::fmt>)
  endif()
  setsquare_set_optimisation(${target} ${temperature})
  # To write them takes longer than to parse them a few times.
  if(NOT SETSQUARE_PRECOMPILE_HEADERS OR SETSQUARE_FEW_UNITS)
    return()
  endif()
  # Programs are else compiled differently from libraries, and cannot share the headers.
  get_target_property(type ${target} TYPE)
  if(type STREQUAL EXECUTABLE)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE -fPIC)
  endif()
  if(NOT TARGET ${headers})
    set(source "${PROJECT_BINARY_DIR}/${headers}.cpp")
    file(CONFIGURE OUTPUT "${source}" CONTENT "// Nothing but the precompiled headers.\n")
    add_library(${headers} OBJECT "${source}")
    target_precompile_headers(${headers} PRIVATE ${setsquare_large_headers})
    if(temperature STREQUAL cold)
      target_precompile_headers(${headers} PRIVATE <fmt/core.h>)
    endif()
    target_link_libraries(${headers} PRIVATE ${libraries})
    setsquare_set_optimisation(${headers} ${temperature})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

# setsquare_set_optimisation(TARGET hot|cold)
function(setsquare_set_optimisation target temperature)
  if(temperature STREQUAL hot)
    target_compile_options(${target} PRIVATE ${SETSQUARE_HOT_OPTIONS})
    return()
  endif()
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1>
                      # A false alarm of GCC 12 (its bug 105562).
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

# setsquare_compile_as_tests(TARGET)
# The library is to be fast, not its tests: they compile in half the time.
function(setsquare_compile_as_tests target)
  target_compile_options(
    ${target} PRIVATE $<$<CONFIG:Release>:-O1>
                      # False alarms of GCC 12 (its bugs 105562, 105651).
                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow>)
endfunction()

# setsquare_set_unity(TARGET)
# Under SETSQUARE_UNITY_BUILD compiles many of a target's sources at once: a quarter of the time.
function(setsquare_set_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SETSQUARE_UNITY_BUILD}
                                             UNITY_BUILD_BATCH_SIZE 40)
endfunction()

# setsquare_add_layer(NAME [NOT_INSTALLED] [COLD [HOT a.cpp ...]] [UNIT name] [HEADERS a.hpp ...]
#                     [SOURCES a.cpp ...] DEPENDS core ... [DEFINITIONS A=1 ...]
#                     [PUBLIC_LIBRARIES ...] [PRIVATE_LIBRARIES ...])
# One library per layer, target setsquare::NAME, of all sources below the folder NAME and of SOURCES,
# which are made by the build. HEADERS, below the folder, are the public ones: they alone are
# installed; NOT_INSTALLED: a part of our programs alone. DEPENDS names the layers that it may include.
# HOT names the few sources of a cold layer where a profile finds the time. UNIT is the unit that they
# are compiled in under SETSQUARE_FEW_UNITS, NAME where it is not said; hot ones of cold layers are in
# the unit `tracking`.
function(setsquare_add_layer name)
  cmake_parse_arguments(arg "NOT_INSTALLED;COLD" "UNIT"
                        "HOT;HEADERS;SOURCES;DEPENDS;DEFINITIONS;PUBLIC_LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp"
       "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.hpp")
  list(TRANSFORM arg_HOT PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/${name}/")
  list(REMOVE_ITEM sources ${arg_HOT})
  list(APPEND sources ${arg_SOURCES})
  list(TRANSFORM arg_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/${name}/")
  list(TRANSFORM arg_DEPENDS PREPEND setsquare::)
  set(temperature hot)
  if(arg_COLD)
    set(temperature cold)
  endif()
  if(SETSQUARE_FEW_UNITS AND NOT arg_NOT_INSTALLED)
    if(NOT arg_UNIT)
      set(arg_UNIT ${name})
    endif()
    set(scope INTERFACE)
    add_library(setsquare_${name} INTERFACE)
    setsquare_add_to_unit(${arg_UNIT} ${temperature} SOURCES ${sources} DEFINITIONS ${arg_DEFINITIONS}
                          LIBRARIES ${arg_PUBLIC_LIBRARIES} ${arg_PRIVATE_LIBRARIES})
    if(arg_HOT)
      setsquare_add_to_unit(tracking hot SOURCES ${arg_HOT} LIBRARIES ${arg_PRIVATE_LIBRARIES})
    endif()
    target_link_libraries(setsquare_${name} INTERFACE setsquare_units)
  else()
    set(scope PUBLIC)
    add_library(setsquare_${name} STATIC ${sources})
    target_compile_definitions(setsquare_${name} PRIVATE ${arg_DEFINITIONS})
    target_link_libraries(setsquare_${name} PRIVATE $<BUILD_INTERFACE:setsquare_own_flags> ${arg_PRIVATE_LIBRARIES})
    setsquare_set_unity(setsquare_${name})
    setsquare_set_temperature(setsquare_${name} ${temperature})
    if(arg_HOT)
      # Options are a target's, not a source's, where many sources are compiled at once.
      add_library(setsquare_${name}_hot OBJECT ${arg_HOT})
      target_link_libraries(setsquare_${name}_hot PRIVATE ${arg_DEPENDS} ${arg_PRIVATE_LIBRARIES} setsquare_own_flags)
      setsquare_set_unity(setsquare_${name}_hot)
      setsquare_set_temperature(setsquare_${name}_hot hot)
      target_sources(setsquare_${name} PRIVATE $<TARGET_OBJECTS:setsquare_${name}_hot>)
    endif()
  endif()
  add_library(setsquare::${name} ALIAS setsquare_${name})
  set_target_properties(setsquare_${name} PROPERTIES EXPORT_NAME ${name})
  target_sources(setsquare_${name} ${scope} FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}" FILES
                                            ${arg_HEADERS})
  target_compile_features(setsquare_${name} ${scope} cxx_std_20)
  target_link_libraries(setsquare_${name} ${scope} ${arg_DEPENDS} ${arg_PUBLIC_LIBRARIES})
  if(NOT arg_NOT_INSTALLED)
    set_property(GLOBAL APPEND PROPERTY SETSQUARE_LAYERS setsquare_${name})
  endif()
endfunction()

# setsquare_add_to_unit(UNIT hot|cold SOURCES ... [DEFINITIONS ...] [LIBRARIES ...])
# Under SETSQUARE_FEW_UNITS: the sources of several layers are one unit of the compiler, and all units
# are the library setsquare_units.
function(setsquare_add_to_unit unit temperature)
  cmake_parse_arguments(arg "" "" "SOURCES;DEFINITIONS;LIBRARIES" ${ARGN})
  set(objects setsquare_${temperature}_units)
  if(NOT TARGET setsquare_units)
    add_library(setsquare_units STATIC)
  endif()
  if(NOT TARGET ${objects})
    add_library(${objects} OBJECT)
    set_target_properties(${objects} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    target_include_directories(${objects} PRIVATE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${objects} PRIVATE Eigen3::Eigen Threads::Threads setsquare_own_flags)
    setsquare_set_optimisation(${objects} ${temperature})
    target_sources(setsquare_units PRIVATE $<TARGET_OBJECTS:${objects}>)
  endif()
  set_source_files_properties(${arg_SOURCES} PROPERTIES UNITY_GROUP ${unit})
  target_sources(${objects} PRIVATE ${arg_SOURCES})
  target_compile_definitions(${objects} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(${objects} PRIVATE ${arg_LIBRARIES})
  target_link_libraries(setsquare_units PUBLIC ${arg_LIBRARIES})
endfunction()

# setsquare_add_test(NAME [SOURCES a_test.cpp ...] LAYERS matching ... [LIBRARIES ...] [LONG Suite.* ...])
# One test program a layer: it links only its own layer and those below. Without SOURCES, all those
# of the folder NAME. LONG names the tests that get the label `long`: they map whole drives, to judge
# a figure or to show a rule switched off, and other tests run the same lines on less. The sanitizers'
# preset leaves them out. They start first, so that none of them is left over at the end.
function(setsquare_add_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LAYERS;LIBRARIES;LONG" ${ARGN})
  if(NOT arg_SOURCES)
    file(GLOB arg_SOURCES CONFIGURE_DEPENDS "${name}/*.cpp" "${name}/*.hpp")
  endif()
  add_executable(${name}_test ${arg_SOURCES})
  list(TRANSFORM arg_LAYERS PREPEND setsquare::)
  target_link_libraries(${name}_test PRIVATE ${arg_LAYERS} ${arg_LIBRARIES} setsquare_own_flags
                                             setsquare_test_support GTest::gmock_main)
  # Each test file has a namespace of its own name, so that files can be compiled together.
  setsquare_set_unity(${name}_test)
  setsquare_precompile_headers(${name}_test setsquare_test_support)
  setsquare_compile_as_tests(${name}_test)
  set(discovery TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60)
  if(NOT arg_LONG)
    gtest_discover_tests(${name}_test ${discovery})
    return()
  endif()
  list(JOIN arg_LONG ":" long)
  gtest_discover_tests(${name}_test ${discovery} TEST_FILTER "-${long}")
  gtest_discover_tests(${name}_test ${discovery} TEST_FILTER "${long}" TEST_LIST ${name}_long_TESTS
                       PROPERTIES LABELS long COST 10)
endfunction()
