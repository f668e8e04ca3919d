# SPDX-License-Identifier: Apache-2.0
# The CMake functions of the workspace. Every package includes them with find_package(tocsin_cmake).
include_guard(DIRECTORY)
include(GNUInstallDirs)
include(CTest)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)  # not only cxx_std_17: clang-tidy needs -std on the command line
endif()
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)  # Boost is found by its own BoostConfig.cmake
endif()
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/.." "$ORIGIN/../lib")
if(NOT DEFINED CMAKE_INSTALL_RPATH_USE_LINK_PATH)
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
endif()
set(TOCSIN_TESTS "unit;component;system" CACHE STRING "Labels of the tests that are built and run")
set(TOCSIN_CMAKE_FOLDER "${CMAKE_CURRENT_LIST_DIR}")
list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")  # Findfastdds
set(TOCSIN_TESTED "" CACHE STRING "Packages whose tests are built and run; empty: all")
set(TOCSIN_SANITIZE "" CACHE STRING "Sanitizers for all of our code: address,undefined or thread")
if(TOCSIN_TESTED AND NOT PROJECT_NAME IN_LIST TOCSIN_TESTED AND NOT PROJECT_NAME STREQUAL tocsin_cmake)
  set(BUILD_TESTING OFF)
endif()

# Finds the packages of a LINK list: `package::target`, or a package by its name. Every function below
# calls it for its own list, so a package needs find_package for tocsin_cmake only.
function(tocsin_find)
  foreach(item IN LISTS ARGN)
    string(REGEX REPLACE "::.*" "" package "${item}")
    if(TARGET "${item}" OR package STREQUAL PROJECT_NAME OR package MATCHES "${TOCSIN_OF_THE_SYSTEM}|^-")
      continue()
    endif()
    find_package(${package} REQUIRED)
  endforeach()
endfunction()
set(TOCSIN_OF_THE_SYSTEM "^(dl|rt|m|util|jpeg|pthread)$")  # libraries that are linked by name

# Calls within a shared library go straight to their function, those between libraries through one
# pointer: a stub on the way costs a line of the instruction cache.
function(tocsin_link_directly target)
  target_compile_options(${target} PRIVATE -fno-plt)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL SHARED_LIBRARY)
    target_link_options(${target} PRIVATE "LINKER:-Bsymbolic-functions")
  endif()
endfunction()

# Armed asserts and sanitizers for a target. No warnings: which ones, and that they are errors, is
# for who builds to say; for ours bringup/build does.
function(tocsin_target_options target)
  tocsin_link_directly(${target})
  target_compile_options(${target} PRIVATE -UNDEBUG)
  if(CMAKE_UNITY_BUILD)
    # What a source keeps to itself seems to be in a header then.
    target_compile_options(${target} PRIVATE -Wno-shadow
                                             $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  if(TOCSIN_SANITIZE)
    target_compile_definitions(${target} PRIVATE TOCSIN_SANITIZED)
    target_compile_options(${target} PRIVATE -fsanitize=${TOCSIN_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all -g1)
    target_link_options(${target} PUBLIC -fsanitize=${TOCSIN_SANITIZE})
    # Optimised, the checks take twice as long to compile; only where the computing is, it pays.
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL STATIC_LIBRARY)
      target_compile_options(${target} PRIVATE -O0)
    endif()
  endif()
endfunction()

# Installs targets with headers, as libraries of this package, whose configuration finds what they link to. A
# package may consist of parts: folders with a CMakeLists.txt each, which call this for themselves.
# tocsin_export(TARGETS a b LINK pkg::target ...)
function(tocsin_export)
  cmake_parse_arguments(A "" "" "TARGETS;LINK" ${ARGN})
  get_property(is_known GLOBAL PROPERTY TOCSIN_DEPENDENCIES SET)
  set_property(GLOBAL APPEND PROPERTY TOCSIN_DEPENDENCIES ${A_LINK})
  install(TARGETS ${A_TARGETS} EXPORT ${PROJECT_NAME}Targets LIBRARY DESTINATION lib)
  if(NOT is_known)
    cmake_language(DEFER DIRECTORY "${PROJECT_SOURCE_DIR}" CALL tocsin_write_configuration)
  endif()
  set(headers "${CMAKE_CURRENT_SOURCE_DIR}/include")
  if(IS_DIRECTORY "${headers}")
    # Not install(DIRECTORY): that keeps the time of the source, so that a header installed after an
    # object was compiled with its predecessor looks older than the object, and nothing is rebuilt.
    install(CODE "file(GLOB_RECURSE headers RELATIVE \"${headers}\" \"${headers}/*\")
                  foreach(header IN LISTS headers)
                    set(to \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/include/\${header}\")
                    get_filename_component(folder \"\${to}\" DIRECTORY)
                    file(MAKE_DIRECTORY \"\${folder}\")
                    execute_process(COMMAND \"${CMAKE_COMMAND}\" -E copy_if_different
                                    \"${headers}/\${header}\" \"\${to}\"
                                    COMMAND_ERROR_IS_FATAL ANY)
                  endforeach()")
  endif()
endfunction()

# The configuration of this package, after all of its parts.
function(tocsin_write_configuration)
  get_property(links GLOBAL PROPERTY TOCSIN_DEPENDENCIES)
  list(TRANSFORM links REPLACE "::.*" "")
  list(REMOVE_DUPLICATES links)
  set(config "include(CMakeFindDependencyMacro)\n")
  foreach(package IN LISTS links)
    if(NOT package STREQUAL PROJECT_NAME AND NOT package MATCHES "${TOCSIN_OF_THE_SYSTEM}")
      string(APPEND config "find_dependency(${package})\n")
    endif()
  endforeach()
  string(APPEND config "include(\"\${CMAKE_CURRENT_LIST_DIR}/${PROJECT_NAME}Targets.cmake\")\n")
  file(WRITE "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake" "${config}")
  set(to share/${PROJECT_NAME}/cmake)
  install(EXPORT ${PROJECT_NAME}Targets NAMESPACE ${PROJECT_NAME}:: DESTINATION ${to})
  install(FILES "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake" DESTINATION ${to})
endfunction()

# One of several libraries of this package, to be exported by tocsin_export.
# tocsin_part(name [SHARED] SOURCES a.cpp ... [LINK pkg::target ...] [PRIVATE_LINK ...])
function(tocsin_part name)
  cmake_parse_arguments(A "SHARED" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  tocsin_find(${A_LINK} ${A_PRIVATE_LINK})
  set(kind STATIC)
  if(A_SHARED)
    set(kind SHARED)
  endif()
  add_library(${name} ${kind} ${A_SOURCES})
  add_library(${PROJECT_NAME}::${name} ALIAS ${name})
  target_include_directories(${name} PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>"
                                            "$<INSTALL_INTERFACE:include>")
  target_link_libraries(${name} PUBLIC ${A_LINK} PRIVATE ${A_PRIVATE_LINK})
  tocsin_target_options(${name})
endfunction()

# The library of this package, exported as <project>::<name>: arguments as of tocsin_part.
function(tocsin_library name)
  cmake_parse_arguments(A "SHARED" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  tocsin_part(${name} ${ARGN})
  tocsin_export(TARGETS ${name} LINK ${A_LINK} ${A_PRIVATE_LINK})
endfunction()

# What programs and tests of this package share, and nobody else: a static library, not installed, whose
# headers lie in src/.
# tocsin_core(name SOURCES a.cpp ... [LINK pkg::target ...] [INCLUDE folder ...])
function(tocsin_core name)
  cmake_parse_arguments(A "" "" "SOURCES;LINK;INCLUDE" ${ARGN})
  tocsin_find(${A_LINK})
  add_library(${name} STATIC ${A_SOURCES})
  target_include_directories(${name} PUBLIC src ${A_INCLUDE})
  target_link_libraries(${name} PUBLIC ${A_LINK})
  tocsin_target_options(${name})
endfunction()

# Registers the library lib/tocsin/lib<name>.so as the component <name>, where the runtime looks for
# it: in the ament index of the package, a line for each of its components.
function(tocsin_register_component name)
  if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
    message(FATAL_ERROR "tocsin_component(${name}): is not a name (a lower-case letter, then such "
                        "letters, digits and '_')")
  endif()
  set(index "${PROJECT_BINARY_DIR}/tocsin_components/${PROJECT_NAME}")
  get_property(known GLOBAL PROPERTY TOCSIN_COMPONENTS_OF_${PROJECT_NAME})
  if(NOT known)
    install(FILES "${index}" DESTINATION share/ament_index/resource_index/tocsin_components)
  endif()
  string(APPEND known "${name};lib/tocsin/lib${name}.so\n")
  set_property(GLOBAL PROPERTY TOCSIN_COMPONENTS_OF_${PROJECT_NAME} "${known}")
  file(WRITE "${index}" "${known}")
endfunction()

# A component package: <name>_core holds the decision and links no runtime; lib<name>.so holds the
# ports and is loaded by name into a container process. A package may have several. Components do not
# link each other; for tests of several decisions together a package exports its own:
# tocsin_export(TARGETS <name>_core LINK ...).
# tocsin_component(name [CORE a.cpp ...] [CORE_LINK ...] COMPONENT b.cpp ... [LINK ...])
function(tocsin_component name)
  cmake_parse_arguments(A "" "" "CORE;CORE_LINK;COMPONENT;LINK" ${ARGN})
  tocsin_find(${A_CORE_LINK} ${A_LINK} runtime::runtime)
  if(A_CORE)
    add_library(${name}_core STATIC ${A_CORE})
    add_library(${PROJECT_NAME}::${name}_core ALIAS ${name}_core)
    target_include_directories(${name}_core PUBLIC
      "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>" "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/src>"
      "$<INSTALL_INTERFACE:include>")
    target_link_libraries(${name}_core PUBLIC ${A_CORE_LINK})
    tocsin_target_options(${name}_core)
  endif()
  add_library(${name} SHARED ${A_COMPONENT})
  target_include_directories(${name} PUBLIC include src)
  target_link_libraries(${name} PUBLIC $<TARGET_NAME_IF_EXISTS:${name}_core> runtime::runtime
                                       ${A_LINK})
  tocsin_target_options(${name})
  install(TARGETS ${name} LIBRARY DESTINATION lib/tocsin)
  tocsin_register_component(${name})
endfunction()

# Tells a target the version of its package (package.xml) as TOCSIN_VERSION. All packages have the same one.
function(tocsin_tell_version target)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/package.xml")
  file(STRINGS "${PROJECT_SOURCE_DIR}/package.xml" version REGEX "<version>")
  string(REGEX REPLACE ".*<version>(.*)</version>.*" "\\1" version "${version}")
  target_compile_definitions(${target} PRIVATE TOCSIN_VERSION="${version}")
endfunction()

# A program of this package, installed in bin/; also under the names of ALIASES, by which it tells what
# it is asked for.
# tocsin_executable(name SOURCES a.cpp ... [LINK ...] [ALIASES name ...])
function(tocsin_executable name)
  cmake_parse_arguments(A "" "" "SOURCES;LINK;ALIASES" ${ARGN})
  tocsin_find(${A_LINK})
  add_executable(${name} ${A_SOURCES})
  target_link_libraries(${name} PRIVATE ${A_LINK})
  tocsin_target_options(${name})
  install(TARGETS ${name} RUNTIME DESTINATION bin)
  foreach(alias IN LISTS A_ALIASES)
    set_property(GLOBAL PROPERTY TOCSIN_ALIAS_${alias} ${name})
    file(CREATE_LINK ${name} "${CMAKE_CURRENT_BINARY_DIR}/${alias}" SYMBOLIC)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${alias}" DESTINATION bin)
  endforeach()
endfunction()

# GoogleTest's headers, precompiled by tocsin_cmake; build trees of a workspace stand side by side.
# GCC wants the header's name and finds the precompiled one beside it, Clang that one itself.
set(TOCSIN_TEST_HEADER
    "${CMAKE_BINARY_DIR}/../tocsin_cmake/CMakeFiles/test_precompiled.dir/cmake_pch.hxx")
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  set(TOCSIN_TEST_PRECOMPILED "${TOCSIN_TEST_HEADER}.pch")
  set(TOCSIN_TEST_INCLUDE "SHELL:-include-pch ${TOCSIN_TEST_PRECOMPILED}")
else()
  set(TOCSIN_TEST_PRECOMPILED "${TOCSIN_TEST_HEADER}.gch")
  set(TOCSIN_TEST_INCLUDE "SHELL:-include ${TOCSIN_TEST_HEADER}")
endif()

# How every test program is compiled. Not optimised: that saves a third of its compile time.
function(tocsin_test_options target)
  target_compile_options(${target} PRIVATE -O0)
  set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
  if(TOCSIN_SANITIZE)
    # Clang's thread sanitizer brings an `operator new` also where a test that counts has its own.
    target_link_options(${target} PRIVATE LINKER:--allow-multiple-definition)
  endif()
  if(EXISTS "${TOCSIN_TEST_PRECOMPILED}" AND NOT PROJECT_NAME STREQUAL tocsin_cmake)
    target_compile_options(${target} PRIVATE "${TOCSIN_TEST_INCLUDE}")
  endif()
endfunction()

# The folder above this package that holds colcon.meta; the package's own when there is none.
function(tocsin_repository variable)
  set(folder "${CMAKE_CURRENT_SOURCE_DIR}")
  while(NOT EXISTS "${folder}/colcon.meta")
    cmake_path(GET folder PARENT_PATH above)
    if(above STREQUAL folder)
      set(folder "${CMAKE_CURRENT_SOURCE_DIR}")
      break()
    endif()
    set(folder "${above}")
  endwhile()
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

# Copies programs of this package for a test that runs them: each into an installation of its own, with
# the shipped configuration and nothing else.
function(tocsin_stage test repository)
  foreach(program IN LISTS ARGN)
    set(root "${CMAKE_CURRENT_BINARY_DIR}/stage/${program}/root")
    if(NOT TARGET stage_${program})
      get_property(target GLOBAL PROPERTY TOCSIN_ALIAS_${program})
      if(NOT target)
        set(target ${program})
      endif()
      file(MAKE_DIRECTORY "${root}/bin" "${root}/share/tocsin")
      file(CREATE_LINK "${repository}/config" "${root}/share/tocsin/config" SYMBOLIC)
      add_custom_target(stage_${program}
        COMMAND "${CMAKE_COMMAND}" -E copy_if_different $<TARGET_FILE:${target}> "${root}/bin/${program}"
        DEPENDS ${target})
    endif()
    string(REGEX REPLACE "^tocsin-" "" word "${program}")
    string(TOUPPER "${word}_PROGRAM" word)
    target_compile_definitions(${test} PRIVATE ${word}="${root}/bin/${program}")
    add_dependencies(${test} stage_${program})
  endforeach()
endfunction()

# A GoogleTest program. LABEL is unit, component or system; sources default to test/<path>.cpp, and
# the program is called as the last part of the path.
# What TOCSIN_TESTS does not name is built on demand only and does not run, except of packages that
# are tests as a whole (test/). With a sanitizer, tests may take five times as long.
# PROGRAMS are programs of this package that the test runs: tocsin-qos is QOS_PROGRAM for it.
# tocsin_test(path LABEL unit LINK target ... [SOURCES ...] [INCLUDE folder ...] [TIMEOUT seconds] [PROGRAMS name ...])
function(tocsin_test path)
  if(NOT BUILD_TESTING)
    return()
  endif()
  cmake_parse_arguments(A "" "LABEL;TIMEOUT" "LINK;SOURCES;INCLUDE;PROGRAMS" ${ARGN})
  cmake_path(GET path FILENAME name)
  if(NOT A_LABEL MATCHES "^(unit|component|system)$")
    message(FATAL_ERROR "tocsin_test(${name}): LABEL '${A_LABEL}' is not unit, component or system")
  endif()
  if(NOT A_SOURCES)
    set(A_SOURCES test/${path}.cpp)
  endif()
  tocsin_test_program(${name} SOURCES ${A_SOURCES} LINK ${A_LINK} INCLUDE ${A_INCLUDE}
                      PROGRAMS ${A_PROGRAMS})
  tocsin_repository(repository)
  set(repository_tests "${repository}/test")
  cmake_path(IS_PREFIX repository_tests "${CMAKE_CURRENT_SOURCE_DIR}" of_tests)
  if(A_LABEL IN_LIST TOCSIN_TESTS OR of_tests)
    tocsin_add_test(${name} ${name} "${A_LABEL}" "${A_TIMEOUT}")
  else()
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# The program of one or more tests.
function(tocsin_test_program name)
  cmake_parse_arguments(A "" "" "LINK;SOURCES;INCLUDE;PROGRAMS" ${ARGN})
  tocsin_find(GTest ${A_LINK})
  add_executable(${name} ${A_SOURCES})
  target_link_libraries(${name} PRIVATE ${A_LINK} GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${A_INCLUDE})
  tocsin_target_options(${name})
  tocsin_test_options(${name})
  tocsin_repository(repository)
  target_compile_definitions(${name} PRIVATE TOCSIN_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
                                             TOCSIN_REPOSITORY="${repository}")
  tocsin_stage(${name} "${repository}" ${A_PROGRAMS})
endfunction()

# Has ctest run a test program, with further variables of its environment.
function(tocsin_add_test name program label timeout)
  if(NOT timeout)
    set(timeout 120)
  endif()
  if(TOCSIN_SANITIZE OR CMAKE_CROSSCOMPILING)  # emulated
    math(EXPR timeout "5 * ${timeout}")
  endif()
  add_test(NAME ${name} COMMAND ${program} --gtest_shuffle
           --gtest_output=xml:${CMAKE_CURRENT_BINARY_DIR}/test_results/${name}.xml)
  # What a test leaves in ::testing::TempDir() meets no other test's.
  set(temporary "${CMAKE_CURRENT_BINARY_DIR}/test_tmp/${name}/")
  file(MAKE_DIRECTORY "${temporary}")
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout}
                       ENVIRONMENT "TEST_TMPDIR=${temporary};${ARGN}")
endfunction()

# Tests that share their label and what they link: test/<name>_test.cpp each, with tocsin_test's arguments.
# With a sanitizer they are compiled and linked as one program, which runs one source at a time; so their
# names are their sources' only, and no two sources have a fixture of the same name.
# tocsin_tests(LABEL unit LINK target ... [INCLUDE folder ...] [TIMEOUT seconds] [PROGRAMS name ...] TESTS name ...)
function(tocsin_tests)
  cmake_parse_arguments(A "" "LABEL;TIMEOUT" "LINK;INCLUDE;PROGRAMS;TESTS" ${ARGN})
  list(LENGTH A_TESTS count)
  if(TOCSIN_SANITIZE AND count GREATER 1 AND A_LABEL IN_LIST TOCSIN_TESTS AND BUILD_TESTING)
    tocsin_united_tests(LABEL ${A_LABEL} TIMEOUT ${A_TIMEOUT} LINK ${A_LINK} INCLUDE ${A_INCLUDE}
                        PROGRAMS ${A_PROGRAMS} TESTS ${A_TESTS})
    return()
  endif()
  foreach(test IN LISTS A_TESTS)
    tocsin_test(${test}_test LABEL ${A_LABEL} TIMEOUT ${A_TIMEOUT} LINK ${A_LINK}
                INCLUDE ${A_INCLUDE} PROGRAMS ${A_PROGRAMS})
  endforeach()
endfunction()

# tocsin_tests, with a sanitizer.
function(tocsin_united_tests)
  cmake_parse_arguments(A "" "LABEL;TIMEOUT" "LINK;INCLUDE;PROGRAMS;TESTS" ${ARGN})
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  list(GET A_TESTS 0 first)
  cmake_path(GET first FILENAME program)
  string(APPEND program _and_other_tests)
  set(script "${TOCSIN_CMAKE_FOLDER}/unite_tests.py")
  set(sources)
  set(rest "${TOCSIN_CMAKE_FOLDER}/united_tests_main.cpp")
  foreach(test IN LISTS A_TESTS)
    list(APPEND rest "${CMAKE_CURRENT_SOURCE_DIR}/test/${test}_test.cpp")
  endforeach()
  set(number 0)
  while(rest)
    list(SUBLIST rest 0 13 some)  # more take more memory than they save time
    list(REMOVE_ITEM rest ${some})
    set(source "${CMAKE_CURRENT_BINARY_DIR}/united/${program}_${number}.cpp")
    add_custom_command(OUTPUT "${source}" DEPENDS "${script}" ${some} VERBATIM
                       COMMAND Python3::Interpreter -B "${script}" "${source}" ${some})
    list(APPEND sources "${source}")
    math(EXPR number "${number} + 1")
  endwhile()
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/united")
  tocsin_test_program(${program} SOURCES ${sources} LINK ${A_LINK} INCLUDE ${A_INCLUDE}
                      PROGRAMS ${A_PROGRAMS})
  foreach(test IN LISTS A_TESTS)
    cmake_path(GET test PARENT_PATH folder)
    target_include_directories(${program} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/test/${folder}")
    cmake_path(GET test FILENAME name)
    tocsin_add_test(${name}_test ${program} "${A_LABEL}" "${A_TIMEOUT}" "TOCSIN_TEST_SOURCE=test/${test}_test.cpp")
  endforeach()
endfunction()

include("${CMAKE_CURRENT_LIST_DIR}/TocsinIdl.cmake")
