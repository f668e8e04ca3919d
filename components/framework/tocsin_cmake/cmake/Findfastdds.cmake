# SPDX-License-Identifier: Apache-2.0
# find_package(fastdds): Fast DDS of either version, as target `fastdds`. 2.9 calls itself fastrtps.
find_package(fastdds CONFIG QUIET)
if(NOT fastdds_FOUND)
  find_package(fastrtps CONFIG REQUIRED)
  set(fastdds_FOUND TRUE)
  set(fastdds_VERSION "${fastrtps_VERSION}")
  if(NOT TARGET fastdds)
    add_library(fastdds INTERFACE IMPORTED)
    target_link_libraries(fastdds INTERFACE fastrtps fastcdr)
  endif()
endif()
