# SPDX-License-Identifier: Apache-2.0
# cmake -DGENERATOR=... -DIDLS=a,b -DSEARCH=dir,dir -DOUT=dir -P generate_idl.cmake
# Runs fastddsgen 2.3 into a scratch directory and copies the type files of IDLS only:
# * it also writes every included IDL, flattened by base name   -> copy our own stems
# * comments carry JVM object hashes (not reproducible)         -> stripped
cmake_minimum_required(VERSION 3.25)
foreach(variable IDLS SEARCH)
  string(REPLACE "," ";" ${variable} "${${variable}}")
endforeach()
set(scratch "${OUT}/.scratch")
file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}/out" "${scratch}/temporary")
set(flags -cs -replace -t "${scratch}/temporary" -d "${scratch}/out")
foreach(directory IN LISTS SEARCH)
  list(APPEND flags -I "${directory}")
endforeach()
execute_process(COMMAND "${GENERATOR}" ${flags} ${IDLS} WORKING_DIRECTORY "${scratch}"
                RESULT_VARIABLE result OUTPUT_VARIABLE log ERROR_VARIABLE log)
if(NOT result EQUAL 0 OR log MATCHES "ERROR|error:")
  message(FATAL_ERROR "fastddsgen failed (${result}):\n${log}")
endif()
foreach(idl IN LISTS IDLS)
  get_filename_component(stem "${idl}" NAME_WE)
  foreach(extension h cxx)
    file(READ "${scratch}/out/${stem}.${extension}" text)
    string(REGEX REPLACE "(//[^\n]*)@[0-9a-f]+" "\\1" text "${text}")
    file(WRITE "${OUT}/${stem}.${extension}" "${text}")
  endforeach()
endforeach()
file(REMOVE_RECURSE "${scratch}")
