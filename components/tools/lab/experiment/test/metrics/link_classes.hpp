// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/recording.hpp"

namespace tocsin::experiment {

inline constexpr report::LinkClass uxv_critical{Role::uxv, TrafficClass::critical};
inline constexpr report::LinkClass uxv_high{Role::uxv, TrafficClass::high};
inline constexpr report::LinkClass uxv_low{Role::uxv, TrafficClass::low};
inline constexpr report::LinkClass gcs_high{Role::gcs, TrafficClass::high};

}  // namespace tocsin::experiment
