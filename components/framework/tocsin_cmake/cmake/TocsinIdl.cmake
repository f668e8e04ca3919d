# SPDX-License-Identifier: Apache-2.0
# tocsin_idl_library(name IDL idl/a.idl ... [LINK ros_idl::ros_idl])
# Generates C++ from IDL at build time into one shared library; fastddsgen parses it. Headers are
# included as "<name>/<stem>.hpp". The same in TypeScript is installed as share/<name>/ts/<stem>.ts.
# What Fast DDS needs to know of a type, the runtime makes from its TypeInfo.
include_guard(GLOBAL)
set(TOCSIN_GENERATE_IDL "${CMAKE_CURRENT_LIST_DIR}/generate_idl.py")
file(GLOB TOCSIN_GENERATE_IDL_PARTS "${CMAKE_CURRENT_LIST_DIR}/*.py"
     "${CMAKE_CURRENT_LIST_DIR}/fields.stg")

function(tocsin_idl_library name)
  cmake_parse_arguments(A "" "" "IDL;LINK" ${ARGN})
  find_program(FASTDDSGEN_EXECUTABLE fastddsgen)
  if(NOT FASTDDSGEN_EXECUTABLE)
    message(FATAL_ERROR "fastddsgen not found: needed to turn IDL into C++ (apt install fastddsgen)")
  endif()
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(gen "${CMAKE_CURRENT_BINARY_DIR}/gen/${name}")
  set(idls ${A_IDL})
  list(TRANSFORM idls PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set(outputs)
  set(sources)
  foreach(idl IN LISTS idls)
    get_filename_component(stem "${idl}" NAME_WE)
    list(APPEND outputs "${gen}/${stem}.hpp" "${gen}/${stem}.ts")
    list(APPEND sources "${gen}/${stem}_type_info.cpp")
  endforeach()
  tocsin_find(idl_support::idl_support ${A_LINK})
  set(search --search "${CMAKE_CURRENT_SOURCE_DIR}/idl")
  foreach(item IN LISTS A_LINK)
    string(REGEX REPLACE "::.*" "" package "${item}")
    list(APPEND search --search "${${package}_DIR}/../idl")
  endforeach()
  add_custom_command(
    OUTPUT ${outputs} ${sources}
    COMMAND Python3::Interpreter -B "${TOCSIN_GENERATE_IDL}" --generator "${FASTDDSGEN_EXECUTABLE}"
            --package ${name} --out "${gen}" ${search} -- ${idls}
    DEPENDS ${idls} ${TOCSIN_GENERATE_IDL_PARTS}
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
  install(DIRECTORY "${gen}/" DESTINATION include/${name} FILES_MATCHING PATTERN "*.hpp")
  install(FILES ${idls} DESTINATION share/${name}/idl)
  install(DIRECTORY "${gen}/" DESTINATION share/${name}/ts FILES_MATCHING PATTERN "*.ts")
  tocsin_export(TARGETS ${name} LINK idl_support::idl_support ${A_LINK})
endfunction()
