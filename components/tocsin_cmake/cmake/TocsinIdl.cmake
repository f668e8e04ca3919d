# SPDX-License-Identifier: Apache-2.0
# tocsin_idl_library(name IDL idl/a.idl ... [LINK ros_idl::ros_idl])
# Generates C++ from IDL with fastddsgen at build time into one shared library. Headers are included
# as "<name>/<stem>.hpp". Only the types and their CDR coding are compiled: what Fast DDS needs to
# know of a type, the runtime makes from its TypeInfo (a PubSubTypes file costs four times as much
# to compile as the type itself).
include_guard(GLOBAL)
set(TOCSIN_DESCRIBE_IDL "${CMAKE_CURRENT_LIST_DIR}/describe_idl.py")
set(TOCSIN_GENERATE_IDL "${CMAKE_CURRENT_LIST_DIR}/generate_idl.cmake")
set(TOCSIN_INLINE_TYPES "${CMAKE_CURRENT_LIST_DIR}/inline_types.py")

function(tocsin_idl_library name)
  cmake_parse_arguments(A "" "" "IDL;LINK" ${ARGN})
  find_program(FASTDDSGEN_EXECUTABLE fastddsgen)
  if(NOT FASTDDSGEN_EXECUTABLE)
    message(FATAL_ERROR "fastddsgen not found: needed to turn IDL into C++ (apt install fastddsgen)")
  endif()
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(gen "${CMAKE_CURRENT_BINARY_DIR}/gen/${name}")
  set(raw "${CMAKE_CURRENT_BINARY_DIR}/fastddsgen")
  set(idls ${A_IDL})
  list(TRANSFORM idls PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set(stems)
  set(outputs)
  set(sources)
  foreach(idl IN LISTS idls)
    get_filename_component(stem "${idl}" NAME_WE)
    list(APPEND stems ${stem})
    list(APPEND outputs "${gen}/${stem}.h" "${gen}/${stem}.hpp")
    list(APPEND sources "${gen}/${stem}.cxx" "${gen}/${stem}_type_info.cpp")
  endforeach()
  set(search "${CMAKE_CURRENT_SOURCE_DIR}/idl")
  foreach(item IN LISTS A_LINK)
    string(REGEX REPLACE "::.*" "" package "${item}")
    list(APPEND search "${${package}_DIR}/../idl")
  endforeach()
  string(REPLACE ";" "," search_list "${search}")
  string(REPLACE ";" "," idl_list "${idls}")
  add_custom_command(
    OUTPUT ${outputs} ${sources}
    COMMAND "${CMAKE_COMMAND}" "-DGENERATOR=${FASTDDSGEN_EXECUTABLE}" "-DIDLS=${idl_list}"
            "-DSEARCH=${search_list}" "-DOUT=${raw}" -P "${TOCSIN_GENERATE_IDL}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${gen}"
    COMMAND Python3::Interpreter -B "${TOCSIN_INLINE_TYPES}" "${raw}" "${gen}" ${stems}
    COMMAND Python3::Interpreter -B "${TOCSIN_DESCRIBE_IDL}" ${name} "${gen}" ${idls}
    DEPENDS ${idls} "${TOCSIN_GENERATE_IDL}" "${TOCSIN_INLINE_TYPES}" "${TOCSIN_DESCRIBE_IDL}"
    COMMENT "fastddsgen ${name}" VERBATIM)
  add_library(${name} SHARED ${sources})
  target_include_directories(${name} SYSTEM PUBLIC
    "$<BUILD_INTERFACE:${CMAKE_CURRENT_BINARY_DIR}/gen>" "$<BUILD_INTERFACE:${gen}>"
    "$<INSTALL_INTERFACE:include>" "$<INSTALL_INTERFACE:include/${name}>")
  target_compile_options(${name} PRIVATE -w)  # generated code gets none of our warnings
  tocsin_link_directly(${name})
  target_link_libraries(${name} PUBLIC idl_support::idl_support ${A_LINK})
  if(IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include")
    target_include_directories(${name} PUBLIC
      "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>")
  endif()
  install(DIRECTORY "${gen}/" DESTINATION include/${name} FILES_MATCHING PATTERN "*.h"
          PATTERN "*.hpp")
  install(FILES ${idls} DESTINATION share/${name}/idl)
  tocsin_export(TARGETS ${name} LINK idl_support::idl_support ${A_LINK})
endfunction()
