// SPDX-License-Identifier: Apache-2.0
#pragma once

#if __has_include(<fastdds/config.hpp>)
#define TOCSIN_FAST_DDS 3
#else
#define TOCSIN_FAST_DDS 2
#endif

namespace tocsin::fast_dds {

inline constexpr int version = TOCSIN_FAST_DDS;

}  // namespace tocsin::fast_dds
