// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "runtime/fast_dds/names.hpp"

/// How the linker calls security::Permissions::check_create_datawriter of Fast DDS, for tests that
/// put something in its place.
#if TOCSIN_FAST_DDS >= 3
#define CHECK_CREATE_DATAWRITER \
  _ZN8eprosima7fastdds4rtps8security11Permissions23check_create_datawriterERKNS2_6HandleEjRKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKSt6vectorISC_SaISC_EERNS2_17SecurityExceptionE
#else
#define CHECK_CREATE_DATAWRITER \
  _ZN8eprosima8fastrtps4rtps8security11Permissions23check_create_datawriterERKNS2_6HandleEjRKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKSt6vectorISC_SaISC_EERNS2_17SecurityExceptionE
#endif
