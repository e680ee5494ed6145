# SPDX-License-Identifier: Apache-2.0
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # the libraries go into the Python module, too
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

include(GNUInstallDirs)
# Where a program of FOLDER finds the libraries once it is installed: programs and libraries are moved together.
function(fairway_rpath variable folder)
  if(BUILD_SHARED_LIBS)
    cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${folder} OUTPUT_VARIABLE libraries)
    set(${variable} $ORIGIN $ORIGIN/${libraries} PARENT_SCOPE)
  endif()
endfunction()
fairway_rpath(CMAKE_INSTALL_RPATH ${CMAKE_INSTALL_FULL_BINDIR})

# Whoever builds once, as most do, builds in half the time when many files are compiled as one. File by file is quicker after
# an edit, and shows a missing #include and a shadowed name.
set(fairway_unity_default 0)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(fairway_unity_default 12)
endif()
set(FAIRWAY_UNITY ${fairway_unity_default} CACHE STRING "how many files of a target are compiled as one; 0: each by itself")
set(fairway_file_by_file -Wshadow)
if(NOT FAIRWAY_UNITY EQUAL 0)  # what a file declares for itself, others compiled with it see too
  set(fairway_file_by_file $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()

add_library(fairway_options INTERFACE)
target_compile_options(fairway_options INTERFACE
  -Wall -Wextra -Wpedantic ${fairway_file_by_file} -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers
  $<$<BOOL:${FAIRWAY_WERROR}>:-Werror>
  # g++ 12 raises these for plain strings and temporaries when it inlines them
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-maybe-uninitialized>
  -fno-semantic-interposition
  -ffp-contract=off)  # the same bits whether or not the machine has FMA

# fairway_unity(target [FOLDERS]): compiles FAIRWAY_UNITY of its files as one; with FOLDERS those of one folder, up to eight.
# Names in unnamed namespaces are unique among what is compiled as one.
function(fairway_unity target)
  if(FAIRWAY_UNITY EQUAL 0)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${FAIRWAY_UNITY})
  if(NOT ARGN STREQUAL "FOLDERS")
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "in_${folder}" folder)
    math(EXPR ${folder} "${${folder}} + 1")
    math(EXPR part "(${${folder}} - 1) / 8")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${part})
  endforeach()
endfunction()

# What nearly every file includes, compiled once: it takes two thirds off a build file by file.
set(fairway_common_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <functional> <memory> <optional> <span>
                           <string> <string_view> <tuple> <variant> <vector>)

# fairway_precompile(target first [header...]): the common headers, and those named. The target `first` compiles them, and others of
# the same flags have them from there: a compiler takes its flags from what was precompiled.
function(fairway_precompile target first)
  if(target STREQUAL first)
    target_precompile_headers(${target} PRIVATE ${fairway_common_headers} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${first})
  endif()
endfunction()

# fairway_cold(target link...): outside the step, so built for a quick build rather than for speed. What links JSON has that
# precompiled too: it is up to half of what a file costs that includes it.
function(fairway_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if("nlohmann_json::nlohmann_json" IN_LIST ARGN)
    fairway_precompile(${target} fairway_experiment <fmt/format.h> <nlohmann/json.hpp>)
  else()
    fairway_precompile(${target} fairway_scenario <fmt/format.h>)
  endif()
endfunction()

# What each library may see, of tools/layers.toml.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS tools/layers.toml)
file(STRINGS tools/layers.toml fairway_layers REGEX "^[a-z]+ +=")
foreach(line IN LISTS fairway_layers)
  string(REGEX MATCH "^[a-z]+" name "${line}")
  string(REGEX MATCHALL "\"[a-z]+\"" uses "${line}")
  string(REPLACE "\"" "" fairway_uses_${name} "${uses}")
endforeach()

# fairway_library(name [COLD] [FACADE] [LINKS target...]): declares fairway/<name>/** as target fairway::<name>, which uses what
# tools/layers.toml lets it see; fairway_make_libraries() makes it. COLD: by fairway_cold(). FACADE: its headers
# are C++17 and show nothing of what it uses, so neither does its target.
function(fairway_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD;FACADE" "" "LINKS")
  set(fairway_libraries ${fairway_libraries} ${name} PARENT_SCOPE)
  set(fairway_links_${name} ${arg_LINKS} PARENT_SCOPE)
  set(fairway_is_cold_${name} ${arg_COLD} PARENT_SCOPE)
  set(fairway_is_facade_${name} ${arg_FACADE} PARENT_SCOPE)
endfunction()

# fairway_make_libraries(): of what was declared, the libraries of FAIRWAY_COMPONENTS and all that they use. fairway_made
# comes back as their names.
function(fairway_make_libraries)
  set(wanted ${FAIRWAY_COMPONENTS})
  if(wanted STREQUAL "all")
    set(wanted ${fairway_libraries})
  endif()
  foreach(name IN LISTS wanted)
    if(NOT name IN_LIST fairway_libraries)
      string(REPLACE ";" ", " known "${fairway_libraries}")
      message(FATAL_ERROR "FAIRWAY_COMPONENTS: there is no library \"${name}\"; known: all, ${known}")
    endif()
  endforeach()
  fairway_closure(made "${fairway_libraries}" "${wanted}")
  foreach(name IN LISTS made)
    fairway_make_library(${name})
  endforeach()
  set(fairway_made ${made} PARENT_SCOPE)
endfunction()

function(fairway_make_library name)
  foreach(target IN LISTS fairway_links_${name})
    fairway_find(${target} missing)
    if(missing)
      message(FATAL_ERROR "fairway::${name} needs ${missing}, which was not found; "
                          "scripts/deps installs it, and FAIRWAY_COMPONENTS chooses fewer libraries")
    endif()
  endforeach()

  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.hpp)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*.cpp)
  list(FILTER headers EXCLUDE REGEX "/testing/")
  list(FILTER sources EXCLUDE REGEX "(_test\\.cpp|/testing/)")
  set(uses ${fairway_uses_${name}})
  list(TRANSFORM uses PREPEND fairway::)
  list(APPEND uses ${fairway_links_${name}})
  set(seen PUBLIC)
  if(fairway_is_facade_${name})
    set(seen PRIVATE)
  endif()
  if(sources)
    add_library(fairway_${name} ${sources})  # static, or shared with -DBUILD_SHARED_LIBS=ON
    target_sources(fairway_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
    target_link_libraries(fairway_${name} ${seen} ${uses} PRIVATE $<BUILD_INTERFACE:fairway_options>)
    target_compile_features(fairway_${name} ${seen} cxx_std_20)
    if(fairway_is_facade_${name})
      target_compile_features(fairway_${name} INTERFACE cxx_std_17)
    endif()
    if(fairway_is_cold_${name})
      fairway_cold(fairway_${name} ${fairway_links_${name}})
    else()
      fairway_precompile(fairway_${name} fairway_core)
    endif()
    fairway_unity(fairway_${name})
    # before 1.0 a minor version may change the interface; without a symbol of its own a shared library is compiled as a static one is
    set_target_properties(fairway_${name} PROPERTIES
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} DEFINE_SYMBOL "")
  else()
    add_library(fairway_${name} INTERFACE)
    target_sources(fairway_${name} INTERFACE FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
    target_link_libraries(fairway_${name} INTERFACE ${uses})
    target_compile_features(fairway_${name} INTERFACE cxx_std_20)
  endif()
  set_target_properties(fairway_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(fairway::${name} ALIAS fairway_${name})
endfunction()

# fairway_test_program(name SOURCES source... LINKS target... [SHARDS n] [HOT]): a program of tests, which ctest runs from the root
# as n processes that share them out. What is tested is optimised, who tests it need not be: it is compiled in half the time. HOT:
# it computes much in templates and inline functions, of which the linker takes the test's own, so it is optimised a little.
function(fairway_test_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HOT" "SHARDS" "SOURCES;LINKS")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} fairway_options GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE FAIRWAY_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O$<BOOL:${arg_HOT}>>)
  if(NOT arg_SHARDS)
    set(arg_SHARDS 1)
  endif()
  foreach(shard RANGE 1 ${arg_SHARDS})
    math(EXPR index "${shard} - 1")
    add_test(NAME ${name}_${shard} COMMAND ${name} --gtest_brief=1 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name}_${shard} PROPERTIES
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${arg_SHARDS};GTEST_SHARD_INDEX=${index}" COST ${arg_SHARDS})
  endforeach()
endfunction()

# fairway_precompile_test(target [HOT]): the common headers and GoogleTest's, and unless it is HOT JSON's; the first of its kind
# compiles them for all
function(fairway_precompile_test target)
  get_property(first GLOBAL PROPERTY fairway_first_test_${ARGN})
  if(NOT first)
    set(first ${target})
    set_property(GLOBAL PROPERTY fairway_first_test_${ARGN} ${first})
  endif()
  set(json ${PROJECT_SOURCE_DIR}/cmake/json_made.hpp)
  if("HOT" IN_LIST ARGN)
    set(json "")
  endif()
  fairway_precompile(${target} ${first} <gtest/gtest.h> <gmock/gmock.h> ${json})
endfunction()

# fairway_test(name USES lib... [SOURCES extra...] [SHARDS n] [HOT]): every fairway/<name>/**_test.cpp in one program;
# nothing where one of the libraries was not chosen
function(fairway_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "HOT" "SHARDS" "USES;SOURCES;LINKS")
  if(NOT FAIRWAY_TESTS)
    return()
  endif()
  foreach(library IN LISTS arg_USES)
    if(NOT TARGET fairway::${library})
      return()
    endif()
  endforeach()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fairway/${name}/*_test.cpp)
  list(APPEND sources ${arg_SOURCES})
  if(NOT sources)
    return()
  endif()
  list(TRANSFORM arg_USES PREPEND fairway::)
  set(hot "")
  if(arg_HOT)
    set(hot HOT)
  endif()
  fairway_test_program(${name}_test SOURCES ${sources} LINKS ${arg_USES} ${arg_LINKS} SHARDS ${arg_SHARDS} ${hot})
  fairway_precompile_test(${name}_test ${hot})
  fairway_unity(${name}_test FOLDERS)
endfunction()

# fairway_wants(option package suite): an optional part of the tree, AUTO, ON or OFF. <option>_ON says whether it is built;
# AUTO builds it where the package is installed, ON requires that. What is left out is told to the tests in tests/<suite>, whose
# packages are the group of that name in scripts/deps. A macro: what find_package() sets is needed.
macro(fairway_wants option package suite)
  set(${option} AUTO CACHE STRING "AUTO, ON or OFF")
  set(${option}_ON FALSE)
  file(REMOVE ${PROJECT_BINARY_DIR}/left_out/${suite})
  if(${option} STREQUAL "OFF")
    fairway_left_out(${suite} "${option} is OFF; cmake --preset release -D${option}=AUTO asks for it")
  else()
    if(${option} STREQUAL "ON")
      find_package(${package} REQUIRED)
    else()
      find_package(${package} QUIET)
    endif()
    if(${package}_FOUND)
      set(${option}_ON TRUE)
    else()
      fairway_left_out(${suite} "${option} is AUTO, and ${package} is not installed; scripts/deps ${suite} installs it")
    endif()
  endif()
endmacro()

# fairway_left_out(suite why): a part that is not built, and why; tests/needs reads it
function(fairway_left_out suite why)
  message(STATUS "not built: what tests/${suite} needs, for ${why}")
  file(WRITE ${PROJECT_BINARY_DIR}/left_out/${suite} "${why}\n")
endfunction()
